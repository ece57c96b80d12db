//! The checks of soil, water, wires and gravity.

use super::{error, finite, not_negative, positive};
use crate::tower::ambient;
use crate::tower::description::TowerDescription;
use crate::tower::error::{Place, Problem, TowerError};
use crate::tower::surroundings::{SoilRow, Water, Wires};

pub(super) fn check_surroundings(
    description: &TowerDescription,
    base_m: f64,
    top_m: f64,
) -> Result<(), TowerError> {
    for (layer, rows) in description.soil.iter().enumerate() {
        check_soil(layer, rows, base_m, top_m)?;
    }
    if let Some(water) = &description.water {
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
    if rows.len() < 2 {
        let count = rows.len();
        return error(at(0, "rows"), Problem::TooFewSoilRows { count });
    }
    for (row, soil) in rows.iter().enumerate() {
        finite(at(row, "height"), "height", soil.height_m)?;
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
        ];
        for (key, quantity, value, unit) in values {
            not_negative(at(row, key), quantity, value, unit)?;
        }
        let before = row.checked_sub(1).map(|before| rows[before].height_m);
        if let Some(previous_m) = before.filter(|before| *before > soil.height_m) {
            let height_m = soil.height_m;
            let problem = Problem::SoilRowsDecrease {
                height_m,
                previous_m,
            };
            return error(at(row, "height"), problem);
        }
    }
    let (bottom_m, surface_m) = (rows[0].height_m, rows[rows.len() - 1].height_m);
    if surface_m > top_m || surface_m <= base_m {
        let problem = Problem::SoilOutsideTower {
            bottom_m,
            surface_m,
            base_m,
            top_m,
        };
        return error(at(rows.len() - 1, "height"), problem);
    }
    if bottom_m == surface_m {
        let problem = Problem::SoilWithoutDepth {
            height_m: surface_m,
        };
        return error(at(rows.len() - 1, "height"), problem);
    }
    Ok(())
}

fn check_water(water: &Water, base_m: f64, top_m: f64) -> Result<(), TowerError> {
    let at = |key| Place::Water { key };
    finite(at("level"), "the water level", water.level_m)?;
    positive(
        at("density"),
        "the water's density",
        water.density_kg_per_m3,
        " kg/m3",
    )?;
    let coefficient = water.added_mass_coefficient;
    not_negative(
        at("added_mass_coefficient"),
        "the added mass coefficient",
        coefficient,
        "",
    )?;
    let bed_m = water.bed_m.unwrap_or(base_m);
    finite(at("bed"), "the bed's height", bed_m)?;
    let level_m = water.level_m;
    if water.bed_m.is_some() && bed_m >= level_m {
        return error(at("bed"), Problem::BedAboveWater { bed_m, level_m });
    }
    if ambient::reaches(water, base_m, top_m) {
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
    finite(at("height"), "height", wires.height_m)?;
    positive(
        at("stiffness"),
        "the stiffness of a wire",
        wires.stiffness_n_per_m,
        " N/m",
    )?;
    finite(
        at("angle"),
        "the angle from the horizontal",
        wires.angle_deg,
    )?;
    let count = wires.count;
    if count < 3 {
        return error(at("count"), Problem::TooFewWires { count });
    }
    let angle_deg = wires.angle_deg;
    if !(0.0..=90.0).contains(&angle_deg) {
        return error(at("angle"), Problem::WireAngle { angle_deg });
    }
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
