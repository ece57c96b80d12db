//! Soil in layers: units, angles in radians, dry weights, and the range of the models.

use super::Given;
use super::frame_piles;
use super::unused;
use super::usual::{Usual, check_inputs};
use crate::tower::ground::{ApiEdition, FramePile, Ground, GroundLayer, Models, Piles};
use crate::tower::{Ineffective, Place, Quantity, Site, Tower, Warning, Water};

const BUOYANT_WEIGHT: Usual = Usual::new(Quantity::BuoyantUnitWeight, 3e3, 14e3);
const UNIT_WEIGHT: Usual = Usual::new(Quantity::SoilUnitWeight, 8e3, 25e3);

pub(super) fn check(tower: &Tower, given: &Given<'_>, warnings: &mut Vec<Warning>) {
    let Some(ground) = given.ground else {
        return;
    };
    check_inputs(ground, |key| Place::Ground { key }, warnings);
    let piles = piles_of(tower, given, ground);
    let tips = piles.iter().map(|pile| pile.tip_m);
    let tip_m = tips.fold(f64::INFINITY, f64::min);
    for (index, layer) in ground.layers.iter().enumerate() {
        let at = |key| Site::at(Place::GroundLayer { index, key });
        weight(ground, layer, at("effective_unit_weight"), warnings);
        check_inputs(layer, |key| Place::GroundLayer { index, key }, warnings);
        if let Ok(models) = Models::of(layer, ground) {
            unused::check(layer, &models, at, warnings);
        }
        if layer.top_m <= tip_m && index > 0 && !is_under_a_tip(ground, index, &piles) {
            let (site, what) = (at("top"), Ineffective::LayerBelowTip);
            warnings.push(Warning::NoEffect { site, what });
        }
    }
    deep_scour(tip_m, ground, warnings);
    modulus_before_scour(tip_m, ground, warnings);
    models(&piles, ground, warnings);
    if let Some(foundation) = given.foundation.frame() {
        frame_piles::check(foundation.frame.description(), ground, warnings);
    }
    if !ground.submerged
        && ground.edition == ApiEdition::Rp2Geo
        && ground.modulus_depends_on_edition()
    {
        let key = "submerged";
        warnings.push(Warning::NoEffect {
            site: Site::at(Place::Ground { key }),
            what: Ineffective::SandAboveWater,
        });
    }
    if let Some(water) = given.water {
        water_over(ground, water, warnings);
    }
}

/// Lowest remaining fraction of the embedded length after scour.
const SCOURED: f64 = 0.5;

/// Scour that removes more than half of the embedded length of the deepest pile.
fn deep_scour(tip_m: f64, ground: &Ground, warnings: &mut Vec<Warning>) {
    let scour_m = ground.scour.general_m + ground.scour.local_m;
    let embedded_m = ground.surface_m - tip_m;
    if embedded_m > 0.0 && scour_m > SCOURED * embedded_m {
        warnings.push(Warning::DeepScour {
            site: Site::at(Place::Ground { key: "scour" }),
            scour_m,
            embedded_m,
            left_m: embedded_m - scour_m,
        });
    }
}

/// Scour where the springs of a layer that is left depend on a modulus that does not follow it.
fn modulus_before_scour(tip_m: f64, ground: &Ground, warnings: &mut Vec<Warning>) {
    let scoured_m = ground.scoured_surface_m();
    if scoured_m == ground.surface_m {
        return;
    }
    let layers = ground.layers.iter().enumerate();
    let is_left = |layer: &GroundLayer| layer.bottom_m < scoured_m && layer.top_m > tip_m;
    let fixed = layers.filter_map(|(index, layer)| {
        let modulus = layer.shear_modulus?;
        let models = Models::of(layer, ground).ok()?;
        let key = modulus.key();
        let is_fixed = !modulus.follows_scour() && models.used.contains(&key);
        (is_fixed && is_left(layer)).then_some((index, key))
    });
    let fixed: Vec<_> = fixed.collect();
    if let Some(&(index, key)) = fixed.first() {
        let mut keys: Vec<_> = fixed.iter().map(|(_, key)| *key).collect();
        keys.sort_unstable();
        keys.dedup();
        let site = Site::at(Place::GroundLayer { index, key });
        warnings.push(Warning::ModulusBeforeScour { site, keys });
    }
}

/// Water and ground that contradict each other. Scour lowers the given height of the seabed.
fn water_over(ground: &Ground, water: &Water, warnings: &mut Vec<Warning>) {
    let (surface_m, level_m) = (ground.surface_m, water.level_m);
    let at = |key| Site::at(Place::Water { key });
    if let Some(bed_m) = water.bed_m.filter(|bed_m| *bed_m != surface_m) {
        warnings.push(Warning::BedOffSurface {
            site: at("bed"),
            bed_m,
            surface_m,
        });
    }
    if !ground.submerged && level_m > surface_m {
        warnings.push(Warning::DryUnderWater {
            site: Site::at(Place::Ground { key: "submerged" }),
            level_m,
            surface_m,
        });
    }
    if water.bed_m.is_none() && !water.flooded && level_m <= surface_m {
        let (site, what) = (at("level"), Ineffective::WaterBelowGround);
        warnings.push(Warning::NoEffect { site, what });
    }
}

/// A pile in the ground: the lower part of the tower, or one of the frame below it.
struct EmbeddedPile {
    /// Outer diameter at its tip, m; none if it is not known.
    diameter_m: Option<f64>,
    /// Height of its tip, m.
    tip_m: f64,
    /// Whether it deforms in shear.
    shears: bool,
}

fn piles_of(tower: &Tower, given: &Given<'_>, ground: &Ground) -> Vec<EmbeddedPile> {
    let Some(foundation) = given.foundation.frame() else {
        let first = tower.stations().first();
        let own = first.map(|station| station.outer_diameter_m);
        return vec![EmbeddedPile {
            diameter_m: ground.pile_diameter_m.or(own),
            tip_m: tower.base_m(),
            shears: tower.shears(),
        }];
    };
    let frame = foundation.frame.description();
    let piles = FramePile::all(frame, ground).unwrap_or_default();
    let embedded = piles.iter().map(|pile| {
        let alone = pile.alone(frame, ground);
        let mut members = pile.members.iter();
        EmbeddedPile {
            diameter_m: alone.stations.first().map(|row| row.outer_diameter_m),
            tip_m: pile.tip_m(frame),
            shears: members.all(|part| frame.members[part.member].shears),
        }
    });
    embedded.collect()
}

/// Whether the layer is under a tip, where it may have springs.
fn is_under_a_tip(ground: &Ground, index: usize, piles: &[EmbeddedPile]) -> bool {
    let above_m = ground.layers[index - 1].bottom_m;
    let top_m = ground.layers[index].top_m;
    let mut piles = piles.iter();
    piles.any(|pile| above_m >= pile.tip_m && pile.tip_m >= top_m)
}

fn weight(ground: &Ground, layer: &GroundLayer, site: Site, warnings: &mut Vec<Warning>) {
    if let Some(weight) = layer.effective_unit_weight_n_per_m3 {
        let usual = if ground.submerged {
            BUOYANT_WEIGHT
        } else {
            UNIT_WEIGHT
        };
        usual.check(weight, site, warnings);
    }
}

/// Piles and soils for which the models were not derived.
fn models(piles: &[EmbeddedPile], ground: &Ground, warnings: &mut Vec<Warning>) {
    let mut seen = Vec::new();
    for (index, layer) in ground.layers.iter().enumerate() {
        let Ok(models) = Models::of(layer, ground) else {
            continue;
        };
        let at = |key| Site::at(Place::GroundLayer { index, key });
        let range = models.across.piles();
        if let Some(range) = range.filter(|range| !seen.contains(&range.formula)) {
            seen.push(range.formula);
            let site = at("model");
            if range.need_shear && piles.iter().any(|pile| !pile.shears) {
                warnings.push(Warning::PisaWithoutShear { site });
            }
            warnings.extend(outside(piles, ground, &range, site));
        }
        models.across.doubt(&at, warnings);
    }
}

/// Piles for which a model was not derived: for each value the first pile outside the range.
fn outside(
    piles: &[EmbeddedPile],
    ground: &Ground,
    range: &Piles,
    site: Site,
) -> impl Iterator<Item = Warning> {
    let scoured_m = ground.surface_m - (ground.scour.general_m + ground.scour.local_m);
    let diameters = piles.iter().filter_map(|pile| pile.diameter_m);
    let lengths = piles.iter().filter_map(|pile| {
        let diameter_m = pile.diameter_m?;
        Some((scoured_m - pile.tip_m) / diameter_m)
    });
    let is_outside = |[least, most]: [f64; 2]| move |value: &f64| !(least..=most).contains(value);
    let diameter = diameters.into_iter().find(is_outside(range.diameters_m));
    let length = lengths.into_iter().find(is_outside(range.lengths));
    let (formula, remedy) = (range.formula, range.remedy);
    let numbers = [
        ("the diameter of the pile in m", diameter, range.diameters_m),
        (
            "the embedded length of the pile, divided by its diameter,",
            length,
            range.lengths,
        ),
    ];
    let warning = move |(quantity, value, [least, most]): (&'static str, Option<f64>, [f64; 2])| {
        Some(Warning::OutsideFormula {
            site,
            formula,
            quantity,
            value: value?,
            least,
            most,
            remedy,
        })
    };
    numbers.into_iter().filter_map(warning)
}
