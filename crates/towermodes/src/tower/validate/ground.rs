//! The checks of soil in layers.

use super::scale::{coordinate, error, length, not_negative, positive};
use crate::tower::description::TowerDescription;
use crate::tower::error::{Place, Problem, TowerError};
use crate::tower::ground::{
    AxialModel, Clay, Ground, GroundLayer, LayerSoil, PyRow, Rock, Sand, ShearModulus, SoilModel,
};

type Checked = Result<(), TowerError>;

fn at(key: &'static str) -> Place {
    Place::Ground { key }
}

/// The layer that is checked, and its number.
#[derive(Clone, Copy)]
struct Layer<'a> {
    index: usize,
    own: &'a GroundLayer,
}

pub(super) fn check_ground(description: &TowerDescription, base_m: f64, top_m: f64) -> Checked {
    let Some(ground) = &description.ground else {
        return Ok(());
    };
    check_heights(ground, base_m, top_m)?;
    check_diameter(description, ground)?;
    positive(at("factor"), "the factor on the soil", ground.factor, "")?;
    check_layers(ground, base_m)?;
    for (index, own) in ground.layers.iter().enumerate() {
        let layer = Layer { index, own };
        layer.check_values()?;
        layer.check_model()?;
        layer.check_axial(ground.axial)?;
    }
    check_weights(ground)
}

fn check_heights(ground: &Ground, base_m: f64, top_m: f64) -> Checked {
    let surface_m = ground.surface_m;
    coordinate(at("surface"), "the height of the surface", surface_m)?;
    let (general_m, local_m) = (ground.scour.general_m, ground.scour.local_m);
    not_negative(
        at("scour.general"),
        "the depth of general scour",
        general_m,
        " m",
    )?;
    not_negative(at("scour.local"), "the depth of local scour", local_m, " m")?;
    coordinate(at("scour.general"), "the depth of general scour", general_m)?;
    coordinate(at("scour.local"), "the depth of local scour", local_m)?;
    if surface_m > top_m {
        return error(
            at("surface"),
            Problem::SurfaceAboveTower { surface_m, top_m },
        );
    }
    let scoured_m = surface_m - general_m - local_m;
    if scoured_m > base_m {
        return Ok(());
    }
    let (key, scour_m) = match surface_m > base_m {
        true => ("scour", general_m + local_m),
        false => ("surface", 0.0),
    };
    let problem = Problem::PileAboveSoil {
        surface_m,
        scour_m,
        tip_m: base_m,
    };
    error(at(key), problem)
}

/// A table of properties has no diameters, and stations have their own.
fn check_diameter(description: &TowerDescription, ground: &Ground) -> Checked {
    let key = "pile_diameter";
    match (ground.pile_diameter_m, description.stations.is_empty()) {
        (Some(diameter_m), true) => length(at(key), "the pile's diameter", diameter_m),
        (None, true) => error(at(key), Problem::PileWithoutDiameter),
        (Some(_), false) => error(at(key), Problem::PileWithTwoDiameters),
        (None, false) => Ok(()),
    }
}

/// The layers: each below the previous one, from the surface to the tip of the pile.
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
        if bottom_m >= top_m {
            return error(at("bottom"), Problem::LayerUpsideDown { top_m, bottom_m });
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

    fn positive(
        &self,
        key: &'static str,
        what: &'static str,
        value: f64,
        unit: &'static str,
    ) -> Checked {
        positive(self.at(key), what, value, unit)
    }

    fn both(
        &self,
        key: &'static str,
        what: &'static str,
        pair: [f64; 2],
        unit: &'static str,
    ) -> Checked {
        pair.into_iter()
            .try_for_each(|value| self.positive(key, what, value, unit))
    }

    fn within(
        &self,
        key: &'static str,
        quantity: &'static str,
        value: f64,
        unit: &'static str,
        [least, most]: [f64; 2],
    ) -> Checked {
        let problem = match value.is_finite() {
            true if (least..=most).contains(&value) => return Ok(()),
            true => Problem::OutOfRange {
                quantity,
                value,
                unit,
                least,
                most,
            },
            false => Problem::NotFinite { quantity, value },
        };
        error(self.at(key), problem)
    }

    /// The numbers that are given, whether the model needs them or not.
    fn check_values(&self) -> Checked {
        let own = self.own;
        if let Some(weight) = own.effective_unit_weight_n_per_m3 {
            self.positive(
                "effective_unit_weight",
                "the effective unit weight",
                weight,
                " N/m3",
            )?;
        }
        if let Some(ratio) = own.poissons_ratio {
            let what = "Poisson's ratio of the soil";
            self.within("poissons_ratio", what, ratio, "", [0.0, 0.5])?;
        }
        if let Some(pair) = own.shaft_friction_pa {
            self.both("shaft_friction", "the shaft friction", pair, " Pa")?;
        }
        if let Some(bearing) = own.end_bearing_pa {
            self.positive("end_bearing", "the end bearing", bearing, " Pa")?;
        }
        if let Some(modulus) = &own.shear_modulus {
            self.check_shear_modulus(modulus)?;
        }
        match &own.soil {
            LayerSoil::Sand(sand) => self.check_sand(sand),
            LayerSoil::Clay(clay) => self.check_clay(clay),
            LayerSoil::Rock(rock) => self.check_rock(rock),
            LayerSoil::Table(rows) => self.check_table(rows),
            LayerSoil::Elastic => Ok(()),
        }
    }

    fn check_sand(&self, sand: &Sand) -> Checked {
        if let Some(angle_deg) = sand.friction_angle_deg {
            let what = "the friction angle";
            self.positive("friction_angle", what, angle_deg, " degrees")?;
            self.within("friction_angle", what, angle_deg, " degrees", [0.0, 60.0])?;
        }
        if let Some(modulus) = sand.subgrade_modulus_n_per_m3 {
            self.positive("subgrade_modulus", "the subgrade modulus", modulus, " N/m3")?;
        }
        match sand.relative_density {
            Some(density) => {
                let what = "the relative density";
                self.within("relative_density", what, density, "", [0.0, 1.0])
            }
            None => Ok(()),
        }
    }

    fn check_clay(&self, clay: &Clay) -> Checked {
        if let Some(pair) = clay.undrained_strength_pa {
            self.both("undrained_strength", "the undrained strength", pair, " Pa")?;
        }
        let factors = [
            (
                "strain_at_half_strength",
                "the strain at half the strength",
                clay.strain_at_half_strength,
            ),
            (
                "strength_factor",
                "the factor J of the strength",
                clay.strength_factor,
            ),
            (
                "stiffness_factor",
                "the factor of the initial stiffness",
                clay.stiffness_factor,
            ),
        ];
        for (key, what, value) in factors {
            if let Some(value) = value {
                self.positive(key, what, value, "")?;
            }
        }
        match clay.strain_at_half_strength {
            Some(strain) => {
                let (key, what) = ("strain_at_half_strength", "the strain at half the strength");
                self.within(key, what, strain, "", [0.0, 1.0])
            }
            None => Ok(()),
        }
    }

    fn check_rock(&self, rock: &Rock) -> Checked {
        let what = "Young's modulus of the rock";
        let modulus = rock.youngs_modulus_pa;
        modulus.map_or(Ok(()), |pair| {
            self.both("youngs_modulus", what, pair, " Pa")
        })
    }

    /// Rows from the top to the bottom of the layer.
    fn check_table(&self, rows: &[PyRow]) -> Checked {
        let layer = self.index;
        let at = |row, key| Place::GroundRow { layer, row, key };
        if rows.len() < 2 {
            let (what, count) = ("the table of the layer", rows.len());
            return error(self.at("rows"), Problem::TooFewRows { what, count });
        }
        for (row, own) in rows.iter().enumerate() {
            coordinate(at(row, "height"), "height", own.height_m)?;
            length(
                at(row, "displacement"),
                "the displacement",
                own.displacement_m,
            )?;
            let (what, reaction) = ("the reaction", own.reaction_n_per_m);
            not_negative(at(row, "reaction"), what, reaction, " N/m")?;
            if row > 0 && rows[row - 1].height_m <= own.height_m {
                let problem = Problem::TableRowsRise {
                    height_m: own.height_m,
                    previous_m: rows[row - 1].height_m,
                };
                return error(at(row, "height"), problem);
            }
        }
        let (first_m, last_m) = (rows[0].height_m, rows[rows.len() - 1].height_m);
        let (top_m, bottom_m) = (self.own.top_m, self.own.bottom_m);
        if first_m >= top_m && last_m <= bottom_m {
            return Ok(());
        }
        let problem = Problem::TableShorterThanLayer {
            first_m,
            last_m,
            top_m,
            bottom_m,
        };
        error(at(0, "height"), problem)
    }

    fn check_shear_modulus(&self, modulus: &ShearModulus) -> Checked {
        let cone = |pair| self.both("cone_resistance", "the cone resistance", pair, " Pa");
        let density = |value| self.positive("density", "the density of the soil", value, " kg/m3");
        match *modulus {
            ShearModulus::Given { shear_modulus_pa } => {
                let what = "the shear modulus of the soil";
                self.both("shear_modulus", what, shear_modulus_pa, " Pa")
            }
            ShearModulus::Youngs { youngs_modulus_pa } => {
                let what = "Young's modulus of the soil";
                self.both("youngs_modulus", what, youngs_modulus_pa, " Pa")?;
                self.needs(
                    "poissons_ratio",
                    "Poisson's ratio",
                    "the shear modulus by Young's modulus",
                    self.own.poissons_ratio.is_some(),
                )
            }
            ShearModulus::WaveVelocity {
                velocity_m_per_s,
                density_kg_per_m3,
            } => {
                let what = "the velocity of shear waves";
                self.both("shear_wave_velocity", what, velocity_m_per_s, " m/s")?;
                density(density_kg_per_m3)
            }
            ShearModulus::RixStokoe { cone_resistance_pa }
            | ShearModulus::MayneRix { cone_resistance_pa } => cone(cone_resistance_pa),
            ShearModulus::RobertsonCabal {
                cone_resistance_pa,
                behaviour_index,
                density_kg_per_m3,
            } => {
                cone(cone_resistance_pa)?;
                let what = "the soil behaviour type index";
                self.within("behaviour_index", what, behaviour_index, "", [0.5, 5.0])?;
                density(density_kg_per_m3)
            }
            ShearModulus::Hardin {
                void_ratio,
                earth_pressure_at_rest,
            } => {
                self.positive("void_ratio", "the void ratio", void_ratio, "")?;
                let what = "the earth pressure coefficient at rest";
                self.positive("earth_pressure_at_rest", what, earth_pressure_at_rest, "")
            }
            ShearModulus::BlowCount {
                blow_count,
                density_kg_per_m3,
            } => {
                self.both("blow_count", "the blow count", blow_count, "")?;
                density(density_kg_per_m3)
            }
        }
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

    /// Whether the model is one for this soil, and has the numbers that it needs.
    fn check_model(&self) -> Checked {
        let model = self.own.model;
        match (&self.own.soil, model) {
            (LayerSoil::Sand(sand), SoilModel::Api | SoilModel::Dnv | SoilModel::Kallehave) => {
                let is_there = sand
                    .friction_angle_deg
                    .or(sand.subgrade_modulus_n_per_m3)
                    .is_some();
                self.needs(
                    "friction_angle",
                    "the friction angle or the subgrade modulus",
                    model.name(),
                    is_there,
                )
            }
            (LayerSoil::Sand(sand), SoilModel::Sorensen) => {
                let is_there = sand.friction_angle_deg.is_some();
                self.needs(
                    "friction_angle",
                    "the friction angle",
                    model.name(),
                    is_there,
                )
            }
            (LayerSoil::Sand(sand), SoilModel::PisaDunkirk) => {
                let is_there = sand.relative_density.is_some();
                self.needs(
                    "relative_density",
                    "the relative density",
                    model.name(),
                    is_there,
                )?;
                self.needs_modulus(false)
            }
            (
                LayerSoil::Clay(clay),
                SoilModel::Api | SoilModel::Dnv | SoilModel::ReeseStiffClay,
            ) => self.check_model_of_clay(clay),
            (LayerSoil::Clay(_), SoilModel::PisaCowden | SoilModel::PisaBothkennar) => {
                self.needs_modulus(false)
            }
            (
                LayerSoil::Sand(_) | LayerSoil::Clay(_) | LayerSoil::Elastic,
                SoilModel::Winkler | SoilModel::Vesic,
            ) => self.needs_modulus(true),
            (LayerSoil::Rock(rock), SoilModel::WeakRock) => {
                let is_there = rock.youngs_modulus_pa.is_some();
                self.needs(
                    "youngs_modulus",
                    "Young's modulus of the rock",
                    model.name(),
                    is_there,
                )
            }
            (LayerSoil::Table(_), SoilModel::Table) => Ok(()),
            (soil, _) => {
                let (model, soil) = (model.name(), soil.noun());
                error(self.at("model"), Problem::ModelOfOtherSoil { model, soil })
            }
        }
    }

    fn check_model_of_clay(&self, clay: &Clay) -> Checked {
        let user = self.own.model.name();
        let strength = clay.undrained_strength_pa.is_some();
        self.needs(
            "undrained_strength",
            "the undrained strength",
            user,
            strength,
        )?;
        let strain = clay.strain_at_half_strength.is_some();
        let value = "the strain at half the strength";
        self.needs("strain_at_half_strength", value, user, strain)?;
        let factor = clay.strength_factor.is_some();
        self.needs(
            "strength_factor",
            "the factor J (0.5 for soft, 0.25 for stiff clay)",
            user,
            factor,
        )?;
        let value = "the factor of the initial stiffness (10 for normally consolidated, 30 for overconsolidated clay)";
        let is_there = self.own.model != SoilModel::Dnv || clay.stiffness_factor.is_some();
        self.needs("stiffness_factor", value, user, is_there)
    }

    fn needs_modulus(&self, and_ratio: bool) -> Checked {
        let user = self.own.model.name();
        let is_there = self.own.shear_modulus.is_some();
        self.needs("shear_modulus", "the shear modulus", user, is_there)?;
        let is_there = !and_ratio || self.own.poissons_ratio.is_some();
        self.needs("poissons_ratio", "Poisson's ratio", user, is_there)
    }

    fn check_axial(&self, axial: Option<AxialModel>) -> Checked {
        let modulus = self.own.shear_modulus.is_some();
        match axial {
            None => Ok(()),
            Some(model @ AxialModel::Api) => {
                if !matches!(self.own.soil, LayerSoil::Sand(_) | LayerSoil::Clay(_)) {
                    let (model, soil) = (model.name(), self.own.soil.noun());
                    return error(self.at("type"), Problem::ModelOfOtherSoil { model, soil });
                }
                let is_there = self.own.shaft_friction_pa.is_some();
                self.needs(
                    "shaft_friction",
                    "the shaft friction",
                    model.name(),
                    is_there,
                )
            }
            Some(model @ AxialModel::Kraft) => {
                self.needs("shear_modulus", "the shear modulus", model.name(), modulus)
            }
            Some(model @ AxialModel::RandolphWroth) => {
                self.needs("shear_modulus", "the shear modulus", model.name(), modulus)?;
                let is_there = self.own.poissons_ratio.is_some();
                self.needs("poissons_ratio", "Poisson's ratio", model.name(), is_there)
            }
        }
    }
}

/// Every layer above one that depends on the weight of the soil, and this one, has a unit weight.
fn check_weights(ground: &Ground) -> Checked {
    let needs_weight = |layer: &GroundLayer| {
        let is_clay = matches!(layer.soil, LayerSoil::Clay(_));
        let by_model = matches!(
            layer.model,
            SoilModel::Api | SoilModel::Dnv | SoilModel::ReeseStiffClay
        );
        let by_modulus = layer
            .shear_modulus
            .is_some_and(|modulus| modulus.needs_stress());
        (is_clay && by_model) || by_modulus
    };
    let Some(deepest) = ground.layers.iter().rposition(needs_weight) else {
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

/// Springs that follow from numbers far outside their range can be infinite.
pub(in crate::tower) fn check_springs_of_ground(rows: &TowerDescription, given: usize) -> Checked {
    let of_ground = rows.soil.iter().skip(given).flatten();
    let mut values = of_ground.flat_map(|row| row.stiffness.values());
    let quantity = "a spring that follows from the ground";
    match values.find(|value| !value.is_finite()) {
        Some(value) => error(at("layer"), Problem::NotFinite { quantity, value }),
        None => Ok(()),
    }
}
