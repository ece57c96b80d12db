//! Water around the tower, and added masses.

use super::Given;
use super::usual::check_inputs;
use crate::tower::Warning;
use crate::tower::{Ineffective, Site};
use crate::tower::{Place, Tower, Water};

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
    check_inputs(water, |key| Place::Water { key }, warnings);
    let at = |key| Site::at(Place::Water { key });
    let (level_m, top_m) = (water.level_m, tower.top_m());
    if level_m > top_m {
        let site = at("level");
        warnings.push(Warning::UnderWater {
            site,
            level_m,
            top_m,
        });
    }
    if water.added_mass_coefficient == 0.0 && !water.flooded {
        let (site, what) = (at("added_mass_coefficient"), Ineffective::WaterOfZeros);
        warnings.push(Warning::NoEffect { site, what });
    }
}
