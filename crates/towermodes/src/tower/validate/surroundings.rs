//! The checks of soil, added mass, water, wires and gravity.

use super::super::parts::surroundings::{AddedMassRow, SoilRow, Water, Wires};
use super::super::pieces::immersion;
use super::inputs::check_inputs;
use super::scale::{coordinate, error, not_negative, stiffness};
use crate::tower::description::TowerDescription;
use crate::tower::error::{Place, Problem, TowerError};

pub(super) fn check_surroundings(
    description: &TowerDescription,
    base_m: f64,
    top_m: f64,
) -> Result<(), TowerError> {
    for (layer, rows) in description.soil.iter().enumerate() {
        check_soil(layer, rows, base_m, top_m)?;
    }
    for (table, rows) in description.added_mass.iter().enumerate() {
        check_added_mass(table, rows, base_m, top_m)?;
    }
    if let Some(water) = &description.water {
        // The members of a frame may extend down to this height.
        let frame = description.foundation.frame();
        let base_m = frame.map_or(base_m, |frame| base_m.min(frame.lowest_m()));
        if !description.properties.is_empty() {
            return error(Place::Water { key: "level" }, Problem::WaterAroundTable);
        }
        check_water(water, base_m, top_m)?;
    }
    for (index, wires) in description.wires.iter().enumerate() {
        check_wires(index, wires, base_m, top_m)?;
    }
    let gravity = description.gravity_m_per_s2;
    not_negative(
        Place::Gravity,
        "the acceleration of gravity",
        gravity,
        " m/s2",
    )
}

fn check_soil(layer: usize, rows: &[SoilRow], base_m: f64, top_m: f64) -> Result<(), TowerError> {
    let at = |row, key| Place::Soil { layer, row, key };
    for (row, soil) in rows.iter().enumerate() {
        coordinate(at(row, "height"), "height", soil.height_m)?;
        let springs = soil.stiffness;
        let values = [
            ("x", "the soil spring in x", springs.x_n_per_m2, " N/m2"),
            ("y", "the soil spring in y", springs.y_n_per_m2, " N/m2"),
            ("z", "the soil spring in z", springs.z_n_per_m2, " N/m2"),
            (
                "torsion",
                "the soil spring in torsion",
                springs.torsion_n,
                " N",
            ),
            (
                "rotation_x",
                "the soil spring against rotation about x",
                springs.rotation_x_n,
                " N",
            ),
            (
                "rotation_y",
                "the soil spring against rotation about y",
                springs.rotation_y_n,
                " N",
            ),
        ];
        for (key, quantity, value, unit) in values {
            stiffness(at(row, key), quantity, value, unit)?;
        }
    }
    let heights_m: Vec<f64> = rows.iter().map(|row| row.height_m).collect();
    check_rows("the soil", &heights_m, (base_m, top_m), at)
}

fn check_added_mass(
    table: usize,
    rows: &[AddedMassRow],
    base_m: f64,
    top_m: f64,
) -> Result<(), TowerError> {
    let at = |row, key| Place::AddedMass { table, row, key };
    for (row, added) in rows.iter().enumerate() {
        coordinate(at(row, "height"), "height", added.height_m)?;
        let value = added.mass_kg_per_m;
        not_negative(at(row, "mass"), "the added mass", value, " kg/m")?;
    }
    let heights_m: Vec<f64> = rows.iter().map(|row| row.height_m).collect();
    check_rows("the added mass", &heights_m, (base_m, top_m), at)
}

/// Checks the heights of rows around the tower: at least two, increasing, and at least partly on
/// the tower.
fn check_rows(
    what: &'static str,
    heights_m: &[f64],
    (base_m, top_m): (f64, f64),
    at: impl Fn(usize, &'static str) -> Place,
) -> Result<(), TowerError> {
    let (Some(&bottom_m), Some(&surface_m)) = (heights_m.first(), heights_m.last()) else {
        return error(at(0, "rows"), Problem::TooFewRows { what, count: 0 });
    };
    if heights_m.len() == 1 {
        return error(at(0, "rows"), Problem::TooFewRows { what, count: 1 });
    }
    for (row, pair) in heights_m.windows(2).enumerate() {
        if pair[0] > pair[1] {
            let problem = Problem::RowsDecrease {
                height_m: pair[1],
                previous_m: pair[0],
            };
            return error(at(row + 1, "height"), problem);
        }
    }
    let last = at(heights_m.len() - 1, "height");
    if surface_m > top_m || surface_m <= base_m {
        let problem = Problem::RowsOutsideTower {
            what,
            bottom_m,
            surface_m,
            base_m,
            top_m,
        };
        return error(last, problem);
    }
    if bottom_m == surface_m {
        let height_m = surface_m;
        return error(last, Problem::RowsWithoutDepth { what, height_m });
    }
    Ok(())
}

fn check_water(water: &Water, base_m: f64, top_m: f64) -> Result<(), TowerError> {
    let at = |key| Place::Water { key };
    check_inputs(water, at)?;
    let bed_m = water.bed_above_m(base_m);
    let level_m = water.level_m;
    if water.bed_m.is_some() && bed_m >= level_m {
        return error(at("bed"), Problem::BedAboveWater { bed_m, level_m });
    }
    if immersion::reaches(water, base_m, top_m) {
        return Ok(());
    }
    let problem = Problem::WaterOutsideTower {
        bed_m,
        level_m,
        base_m,
        top_m,
    };
    error(at("level"), problem)
}

fn check_wires(index: usize, wires: &Wires, base_m: f64, top_m: f64) -> Result<(), TowerError> {
    let at = |key| Place::Wires { index, key };
    check_inputs(wires, at)?;
    let height_m = wires.height_m;
    if (base_m..=top_m).contains(&height_m) {
        return Ok(());
    }
    let problem = Problem::OutsideTower {
        height_m,
        base_m,
        top_m,
    };
    error(at("height"), problem)
}
