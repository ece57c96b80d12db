//! Water around the tower, and masses that move with it as water does.

use super::Given;
use super::usual::Usual;
use crate::tower::Warning;
use crate::tower::{Ineffective, Quantity, Site};
use crate::tower::{Place, Tower, Water};

const DENSITY: Usual = Usual::new(Quantity::WaterDensity, 900.0, 1100.0);
const COEFFICIENT: Usual = Usual::new(Quantity::AddedMassCoefficient, 0.0, 2.0);

pub(super) fn check(tower: &Tower, given: &Given<'_>, warnings: &mut Vec<Warning>) {
    if let Some(water) = given.water {
        still_water(tower, water, warnings);
    }
    for (table, rows) in given.added_mass.iter().enumerate() {
        if rows.iter().all(|row| row.mass_kg_per_m == 0.0) {
            let (row, key) = (0, "rows");
            warnings.push(Warning::NoEffect {
                site: Site::at(Place::AddedMass { table, row, key }),
                what: Ineffective::AddedMassOfZeros,
            });
        }
    }
}

fn still_water(tower: &Tower, water: &Water, warnings: &mut Vec<Warning>) {
    let at = |key| Site::at(Place::Water { key });
    DENSITY.check(water.density_kg_per_m3, at("density"), warnings);
    let (key, coefficient) = ("added_mass_coefficient", water.added_mass_coefficient);
    COEFFICIENT.check(coefficient, at(key), warnings);
    let (level_m, top_m) = (water.level_m, tower.top_m());
    if level_m > top_m {
        let site = at("level");
        warnings.push(Warning::UnderWater {
            site,
            level_m,
            top_m,
        });
    }
    if coefficient == 0.0 && !water.flooded {
        let (site, what) = (at(key), Ineffective::WaterOfZeros);
        warnings.push(Warning::NoEffect { site, what });
    }
}
