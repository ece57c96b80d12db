//! Soil in layers: units, angles in radians, dry weights, and the range of the models.

use super::Given;
use super::unused;
use super::usual::{Usual, check_inputs};
use crate::tower::ground::{ApiEdition, Ground, GroundLayer, Models, Piles};
use crate::tower::{Ineffective, Place, Quantity, Site, Tower, Warning, Water};

const BUOYANT_WEIGHT: Usual = Usual::new(Quantity::BuoyantUnitWeight, 3e3, 14e3);
const UNIT_WEIGHT: Usual = Usual::new(Quantity::SoilUnitWeight, 8e3, 25e3);

pub(super) fn check(tower: &Tower, given: &Given<'_>, warnings: &mut Vec<Warning>) {
    let Some(ground) = given.ground else {
        return;
    };
    check_inputs(ground, |key| Place::Ground { key }, warnings);
    for (index, layer) in ground.layers.iter().enumerate() {
        let at = |key| Site::at(Place::GroundLayer { index, key });
        weight(ground, layer, at("effective_unit_weight"), warnings);
        check_inputs(layer, |key| Place::GroundLayer { index, key }, warnings);
        if let Ok(models) = Models::of(layer, ground) {
            let unused = unused::of(layer, &models).into_iter();
            warnings.extend(unused.map(|(key, what)| Warning::NoEffect {
                site: at(key),
                what,
            }));
        }
        if layer.top_m <= tower.base_m() && index > 0 && !is_under_tip(ground, index, tower) {
            let (site, what) = (at("top"), Ineffective::LayerBelowTip);
            warnings.push(Warning::NoEffect { site, what });
        }
    }
    models(tower, ground, warnings);
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

/// Water and ground that contradict each other. The bed goes down with the scour from the height
/// at which it is given.
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

/// The layer that the tip stands on may give springs under the tip.
fn is_under_tip(ground: &Ground, index: usize, tower: &Tower) -> bool {
    ground.layers[index - 1].bottom_m >= tower.base_m()
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
fn models(tower: &Tower, ground: &Ground, warnings: &mut Vec<Warning>) {
    let mut seen = Vec::new();
    for (index, layer) in ground.layers.iter().enumerate() {
        let Ok(models) = Models::of(layer, ground) else {
            continue;
        };
        let at = |key| Site::at(Place::GroundLayer { index, key });
        let piles = models.across.piles();
        if let Some(piles) = piles.filter(|piles| !seen.contains(&piles.formula)) {
            seen.push(piles.formula);
            pile(tower, ground, &piles, at("model"), warnings);
        }
        models.across.doubt(&at, warnings);
    }
}

/// A pile for which a model was not derived.
fn pile(tower: &Tower, ground: &Ground, piles: &Piles, site: Site, warnings: &mut Vec<Warning>) {
    if piles.need_shear && !tower.shears() {
        warnings.push(Warning::PisaWithoutShear { site });
    }
    let first = tower.stations().first();
    let own = first.map(|station| station.outer_diameter_m);
    let Some(diameter_m) = ground.pile_diameter_m.or(own) else {
        return;
    };
    let scour_m = ground.scour.general_m + ground.scour.local_m;
    let length = (ground.surface_m - scour_m - tower.base_m()) / diameter_m;
    let numbers = [
        (
            "the diameter of the pile in m",
            diameter_m,
            piles.diameters_m,
        ),
        (
            "the embedded length of the pile, divided by its diameter,",
            length,
            piles.lengths,
        ),
    ];
    for (quantity, value, [least, most]) in numbers {
        if !(least..=most).contains(&value) {
            warnings.push(Warning::OutsideFormula {
                site,
                formula: piles.formula,
                quantity,
                value,
                least,
                most,
                remedy: piles.remedy,
            });
        }
    }
}
