//! The checks of soil in layers.

mod model;
mod values;

use super::inputs::check_inputs;
use super::scale::{coordinate, error};
use crate::tower::description::TowerDescription;
use crate::tower::error::{Place, Problem, TowerError};
use crate::tower::frame::FrameDescription;
use crate::tower::ground::{
    AxialModel, ConeBelowStress, FramePile, Ground, GroundLayer, Models, NoPile, cone_below_stress,
};
use crate::tower::parts::surroundings::SoilStiffness;

type Checked<T = ()> = Result<T, TowerError>;

fn at(key: &'static str) -> Place {
    Place::Ground { key }
}

/// A layer during its check, and its index.
#[derive(Clone, Copy)]
struct Layer<'a> {
    index: usize,
    own: &'a GroundLayer,
}

pub(in crate::tower::validate) fn check_ground(
    description: &TowerDescription,
    base_m: f64,
    top_m: f64,
) -> Checked {
    let Some(ground) = &description.ground else {
        return Ok(());
    };
    if let Some(foundation) = description.foundation.frame() {
        check_above_ground(ground, base_m)?;
        let frame = foundation.frame.description();
        check_frame_in_ground(frame, ground)?;
        return check_held(frame, ground);
    }
    check_inputs(ground, at)?;
    check_heights(ground, base_m, top_m)?;
    check_diameter(description, ground)?;
    check_soil(description, ground, base_m)
}

/// The ground around the piles of a frame.
pub(in crate::tower) fn check_frame_in_ground(
    frame: &FrameDescription,
    ground: &Ground,
) -> Checked {
    check_inputs(ground, at)?;
    let piles = match FramePile::all(frame, ground) {
        Ok(piles) => piles,
        Err(NoPile::NoTube(member)) => {
            return error(at("surface"), Problem::PileWithoutTube { member });
        }
        Err(NoPile::NoMember) => {
            let (surface_m, scour_m) = (ground.surface_m, ground.scour.total_m());
            let heights = frame.joints.iter().map(|joint| joint.position_m[2]);
            let lowest_m = heights.fold(f64::INFINITY, f64::min);
            let problem = Problem::FrameAboveSoil {
                surface_m,
                scour_m,
                lowest_m,
            };
            return error(at("surface"), problem);
        }
    };
    if ground.pile_diameter_m.is_some() {
        return error(at("pile_diameter"), Problem::PileWithTwoDiameters);
    }
    // The deepest pile needs the deepest soil.
    let tip_m = |pile: &FramePile| pile.tip_m(frame);
    let deepest = piles.iter().min_by(|a, b| tip_m(a).total_cmp(&tip_m(b)));
    match deepest {
        Some(pile) => check_soil(&pile.alone(frame, ground), ground, tip_m(pile)),
        None => Ok(()),
    }
}

/// Checks that piles are supported: without axial springs of the soil, piles have no vertical
/// stiffness, and a single pile no torsional stiffness.
fn check_held(frame: &FrameDescription, ground: &Ground) -> Checked {
    let holds = |motions: &[usize]| {
        let motions = motions.iter();
        let mut pairs = motions.flat_map(|i| frame.supports.iter().map(move |s| (s, *i)));
        pairs.any(|(support, i)| support.fixed[i] || support.stiffness[i][i] > 0.0)
    };
    if ground.axial.is_none() && !holds(&[2]) {
        return error(at("axial"), Problem::PilesSink);
    }
    let is_alone = FramePile::all(frame, ground).is_ok_and(|piles| piles.len() == 1);
    let resists = ground.axial.is_some_and(AxialModel::resists_torsion);
    match is_alone && !resists && !holds(&[0, 1, 5]) {
        true => error(at("axial"), Problem::PileTurns),
        false => Ok(()),
    }
}

/// Checks that a tower on a frame begins above the ground: below it are the piles of the frame.
fn check_above_ground(ground: &Ground, base_m: f64) -> Checked {
    let surface_m = ground.scoured_surface_m();
    match base_m < surface_m {
        true => error(
            at("surface"),
            Problem::TowerOnFrameInSoil { base_m, surface_m },
        ),
        false => Ok(()),
    }
}

/// Checks the layers down to a tip, and the values that their models need.
fn check_soil(description: &TowerDescription, ground: &Ground, tip_m: f64) -> Checked {
    check_layers(ground, tip_m)?;
    let mut models = Vec::with_capacity(ground.layers.len());
    for (index, own) in ground.layers.iter().enumerate() {
        let layer = Layer { index, own };
        layer.check_values()?;
        models.push(layer.models(ground)?);
    }
    check_weights(ground, &models)?;
    check_cones(description)
}

/// Checks that each cone resistance q_t exceeds the total stress; otherwise no shear modulus
/// follows from it.
fn check_cones(description: &TowerDescription) -> Checked {
    match cone_below_stress(description) {
        None => Ok(()),
        Some(ConeBelowStress {
            layer,
            height_m,
            cone_pa,
            stress_pa,
        }) => {
            let (index, key) = (layer, "cone_resistance");
            let problem = Problem::ConeBelowStress {
                height_m,
                cone_pa,
                stress_pa,
            };
            error(Place::GroundLayer { index, key }, problem)
        }
    }
}

fn check_heights(ground: &Ground, base_m: f64, top_m: f64) -> Checked {
    let surface_m = ground.surface_m;
    if surface_m > top_m {
        return error(
            at("surface"),
            Problem::SurfaceAboveTower { surface_m, top_m },
        );
    }
    if ground.scoured_surface_m() > base_m {
        return Ok(());
    }
    let (key, scour_m) = match surface_m > base_m {
        true => ("scour", ground.scour.total_m()),
        false => ("surface", 0.0),
    };
    let problem = Problem::PileAboveSoil {
        surface_m,
        scour_m,
        tip_m: base_m,
    };
    error(at(key), problem)
}

/// Checks that a diameter is given only for a table of properties: stations contain diameters.
fn check_diameter(description: &TowerDescription, ground: &Ground) -> Checked {
    let key = "pile_diameter";
    match (ground.pile_diameter_m, description.stations.is_empty()) {
        (None, true) => error(at(key), Problem::PileWithoutDiameter),
        (Some(_), false) => error(at(key), Problem::PileWithTwoDiameters),
        (Some(_), true) | (None, false) => Ok(()),
    }
}

/// Checks the layers: each below the previous one, from the surface to the tip of the pile.
fn check_layers(ground: &Ground, tip_m: f64) -> Checked {
    let Some(last) = ground.layers.last() else {
        return error(at("layer"), Problem::NoLayers);
    };
    let mut above_m = ground.surface_m;
    for (index, layer) in ground.layers.iter().enumerate() {
        let at = |key| Place::GroundLayer { index, key };
        let (top_m, bottom_m) = (layer.top_m, layer.bottom_m);
        coordinate(at("top"), "the height of the layer's top", top_m)?;
        coordinate(at("bottom"), "the height of the layer's bottom", bottom_m)?;
        // This check is first, because depths in place of heights would fail the next one too.
        if bottom_m >= top_m {
            return error(at("bottom"), Problem::LayerUpsideDown { top_m, bottom_m });
        }
        if top_m != above_m {
            let problem = match index {
                0 => Problem::FirstLayerOffSurface {
                    top_m,
                    surface_m: above_m,
                },
                _ => Problem::LayersApart { top_m, above_m },
            };
            return error(at("top"), problem);
        }
        above_m = bottom_m;
    }
    if last.bottom_m <= tip_m {
        return Ok(());
    }
    let index = ground.layers.len() - 1;
    let problem = Problem::LayersAboveTip {
        bottom_m: last.bottom_m,
        tip_m,
    };
    error(
        Place::GroundLayer {
            index,
            key: "bottom",
        },
        problem,
    )
}

impl Layer<'_> {
    fn at(&self, key: &'static str) -> Place {
        let index = self.index;
        Place::GroundLayer { index, key }
    }

    fn needs(
        &self,
        key: &'static str,
        value: &'static str,
        user: &'static str,
        is_there: bool,
    ) -> Checked {
        match is_there {
            true => Ok(()),
            false => error(self.at(key), Problem::SoilValueMissing { value, user }),
        }
    }
}

/// Checks that a layer that depends on the weight of the soil, and every layer above it, have a
/// unit weight.
fn check_weights(ground: &Ground, models: &[Models<'_>]) -> Checked {
    let needs_weight = |(layer, models): &(&GroundLayer, &Models<'_>)| {
        let modulus = layer.shear_modulus;
        models.across.nature().needs_weight || modulus.is_some_and(|modulus| modulus.needs_stress())
    };
    let mut layers = ground.layers.iter().zip(models);
    let Some(deepest) = layers.rposition(|layer| needs_weight(&layer)) else {
        return Ok(());
    };
    let user = "the weight of the soil above, on which this layer or one below depends,";
    let layers = ground.layers[..=deepest].iter().enumerate();
    for (index, own) in layers {
        let is_there = own.effective_unit_weight_n_per_m3.is_some();
        let value = "the effective unit weight";
        Layer { index, own }.needs("effective_unit_weight", value, user, is_there)?;
    }
    Ok(())
}

/// Checks that the springs are finite: from values far outside their range they can be infinite.
pub(in crate::tower) fn check_springs_of_ground(rows: &TowerDescription, given: usize) -> Checked {
    let of_ground = rows.soil.iter().skip(given).flatten();
    check_finite(of_ground.map(|row| &row.stiffness))?;
    let foundation = rows.foundation.frame();
    foundation.map_or(Ok(()), |foundation| {
        check_springs_of_frame(foundation.frame.description())
    })
}

/// Checks that the springs of a frame are finite.
pub(in crate::tower) fn check_springs_of_frame(frame: &FrameDescription) -> Checked {
    let soil = frame.members.iter().flat_map(|member| &member.soil);
    check_finite(soil.flat_map(|soil| &soil.rows).map(|row| &row.stiffness))
}

fn check_finite<'a>(springs: impl Iterator<Item = &'a SoilStiffness>) -> Checked {
    let mut values = springs.flat_map(SoilStiffness::values);
    let quantity = "a spring that follows from the ground";
    match values.find(|value| !value.is_finite()) {
        Some(value) => error(at("layer"), Problem::NotFinite { quantity, value }),
        None => Ok(()),
    }
}
