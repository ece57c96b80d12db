//! The checks that turn a description into a tower.

mod damping;
mod drivetrain;
mod foundation;
mod ground;
pub(in crate::tower) mod inertia;
mod inputs;
mod rotor;
mod scale;
mod surroundings;

pub(super) use foundation::largest_asymmetry;
pub(super) use ground::{check_frame_in_ground, check_springs_of_frame, check_springs_of_ground};
pub(crate) use rotor::check_rotor;

use damping::check_damping;
use drivetrain::check_drivetrain;
use foundation::{check_buoyancy, check_foundation};
use ground::check_ground;
use inertia::check_inertia;
use inputs::check_inputs;
use scale::{coordinate, error, length, not_negative, positive};
use surroundings::check_surroundings;

use super::description::{PointMass, PropertyStation, Rna, Station, TowerDescription};
use super::error::{Place, Problem, TowerError};
use super::parts::inertia::Inertia;
use super::parts::material::Material;
use super::parts::properties::Properties;
use super::pieces::shear::Shear;

/// Checks everything that makes a description a tower.
pub(super) fn validate(description: &TowerDescription) -> Result<(), TowerError> {
    for (index, material) in description.materials.iter().enumerate() {
        check_material(index, material)?;
    }
    let heights_m = if description.properties.is_empty() {
        check_stations(&description.stations, description.materials.len())?
    } else if description.stations.is_empty() {
        check_properties(&description.properties)?
    } else {
        return error(Place::Stations, Problem::StationsAndProperties);
    };
    positive(
        Place::OutfittingFactor,
        "the outfitting factor",
        description.outfitting_factor,
        "",
    )?;
    check_shear(description.shear)?;
    check_rna(&description.rna)?;
    let (base_m, top_m) = ends(&heights_m);
    for (index, mass) in description.point_masses.iter().enumerate() {
        check_point_mass(index, mass, base_m, top_m)?;
    }
    check_foundation(&description.foundation)?;
    check_buoyancy(description)?;
    check_surroundings(description, base_m, top_m)?;
    check_ground(description, base_m, top_m)?;
    description.rotor.as_ref().map_or(Ok(()), check_rotor)?;
    if let Some(drivetrain) = &description.drivetrain {
        check_drivetrain(drivetrain, description.rna.inertia_kg_m2.xx)?;
    }
    check_damping(&description.damping)
}

fn check_material(index: usize, material: &Material) -> Result<(), TowerError> {
    let at = |key| Place::Material { index, key };
    let (e, g) = (material.youngs_modulus_pa, material.shear_modulus_pa);
    positive(
        at("density"),
        "density",
        material.density_kg_per_m3,
        " kg/m3",
    )?;
    positive(at("youngs_modulus"), "Young's modulus", e, " Pa")?;
    positive(at("shear_modulus"), "shear modulus", g, " Pa")?;
    let poissons_ratio = material.poissons_ratio();
    if poissons_ratio > -1.0 && poissons_ratio < 0.5 {
        return Ok(());
    }
    error(
        at("shear_modulus"),
        Problem::ImpossibleModuli {
            youngs_modulus_pa: e,
            shear_modulus_pa: g,
            poissons_ratio,
        },
    )
}

/// Checks the stations and gives their heights, m.
fn check_stations(stations: &[Station], materials: usize) -> Result<Vec<f64>, TowerError> {
    for (index, station) in stations.iter().enumerate() {
        check_tube(index, station)?;
        if station.material >= materials {
            let problem = Problem::UnknownMaterial {
                index: station.material,
                count: materials,
            };
            return error(
                Place::Station {
                    index,
                    key: "material",
                },
                problem,
            );
        }
    }
    let heights_m: Vec<f64> = stations.iter().map(|station| station.height_m).collect();
    check_heights(&heights_m)?;
    Ok(heights_m)
}

/// Checks the rows of a property table and gives their heights, m.
fn check_properties(rows: &[PropertyStation]) -> Result<Vec<f64>, TowerError> {
    for (index, row) in rows.iter().enumerate() {
        check_row(index, row)?;
        if row.properties.shear_n.is_some() != rows[0].properties.shear_n.is_some() {
            let key = "shear_stiffness_fore_aft_n";
            return error(Place::Station { index, key }, Problem::ShearInSomeRows);
        }
        check_rigidity(index, &row.properties, &rows[0].properties)?;
    }
    let heights_m: Vec<f64> = rows.iter().map(|row| row.height_m).collect();
    check_heights(&heights_m)?;
    Ok(heights_m)
}

/// Checks that a stiffness is infinite in all rows or in none.
fn check_rigidity(index: usize, row: &Properties, first: &Properties) -> Result<(), TowerError> {
    let columns = [
        ("gj_n_m2", row.torsion_n_m2, first.torsion_n_m2),
        ("ea_n", row.axial_n, first.axial_n),
    ];
    for (key, value, first) in columns {
        if value.is_infinite() != first.is_infinite() {
            let problem = Problem::RigidInSomeRows { column: key };
            return error(Place::Station { index, key }, problem);
        }
    }
    Ok(())
}

fn check_row(index: usize, row: &PropertyStation) -> Result<(), TowerError> {
    let at = |key| Place::Station { index, key };
    let Properties {
        mass_kg_per_m,
        rotary_inertia_kg_m: rotary,
        polar_inertia_kg_m,
        bending_n_m2: bending,
        torsion_n_m2,
        axial_n,
        shear_n,
    } = row.properties;
    coordinate(at("height"), "height", row.height_m)?;
    let mut positives = vec![
        ("mass_kg_per_m", "mass per length", mass_kg_per_m, " kg/m"),
        ("ei_fore_aft_n_m2", "EI fore-aft", bending.fore_aft, " N m2"),
        (
            "ei_side_side_n_m2",
            "EI side-side",
            bending.side_side,
            " N m2",
        ),
    ];
    // An infinite stiffness means a tower without torsion or axial deformation.
    if torsion_n_m2 != f64::INFINITY {
        positives.push(("gj_n_m2", "GJ", torsion_n_m2, " N m2"));
        let (key, quantity) = ("polar_inertia_kg_m", "polar inertia");
        positives.push((key, quantity, polar_inertia_kg_m, " kg m"));
    }
    if axial_n != f64::INFINITY {
        positives.push(("ea_n", "EA", axial_n, " N"));
    }
    if let Some(shear) = shear_n {
        let (key, other) = ("shear_stiffness_fore_aft_n", "shear_stiffness_side_side_n");
        positives.push((key, "shear stiffness fore-aft", shear.fore_aft, " N"));
        positives.push((other, "shear stiffness side-side", shear.side_side, " N"));
    }
    for (key, quantity, value, unit) in positives {
        positive(at(key), quantity, value, unit)?;
    }
    let (key, quantity) = ("polar_inertia_kg_m", "polar inertia");
    not_negative(at(key), quantity, polar_inertia_kg_m, " kg m")?;
    let (key, other) = (
        "rotary_inertia_fore_aft_kg_m",
        "rotary_inertia_side_side_kg_m",
    );
    not_negative(at(key), "rotary inertia fore-aft", rotary.fore_aft, " kg m")?;
    not_negative(
        at(other),
        "rotary inertia side-side",
        rotary.side_side,
        " kg m",
    )
}

fn check_tube(index: usize, station: &Station) -> Result<(), TowerError> {
    let at = |key| Place::Station { index, key };
    let (d, t) = (station.outer_diameter_m, station.wall_thickness_m);
    coordinate(at("height"), "height", station.height_m)?;
    length(at("diameter"), "outer diameter", d)?;
    length(at("wall"), "wall thickness", t)?;
    if 2.0 * t <= d {
        return Ok(());
    }
    error(
        at("wall"),
        Problem::WallTooThick {
            outer_diameter_m: d,
            wall_thickness_m: t,
            height_m: station.height_m,
        },
    )
}

fn check_heights(heights_m: &[f64]) -> Result<(), TowerError> {
    if heights_m.len() < 2 {
        let count = heights_m.len();
        return error(Place::Stations, Problem::TooFewStations { count });
    }
    let (base_m, top_m) = ends(heights_m);
    if heights_m.iter().all(|&height_m| height_m == base_m) {
        return error(Place::Stations, Problem::NoHeight { height_m: base_m });
    }
    for index in 1..heights_m.len() {
        let place = Place::Station {
            index,
            key: "height",
        };
        let (height_m, previous_m) = (heights_m[index], heights_m[index - 1]);
        if height_m < previous_m {
            return error(
                place,
                Problem::HeightDecreases {
                    height_m,
                    previous_m,
                },
            );
        }
        if index > 1 && height_m == heights_m[index - 2] {
            return error(place, Problem::HeightThrice { height_m });
        }
    }
    length(Place::Stations, "the tower's height", top_m - base_m)
}

fn ends(heights_m: &[f64]) -> (f64, f64) {
    (heights_m[0], heights_m[heights_m.len() - 1])
}

fn check_shear(shear: Shear) -> Result<(), TowerError> {
    match shear {
        Shear::Coefficient(value) if !(value > 0.0 && value <= 1.0) => {
            error(Place::Shear, Problem::ShearCoefficient { value })
        }
        Shear::Coefficient(_) | Shear::Rigid | Shear::Cowper => Ok(()),
    }
}

fn check_rna(rna: &Rna) -> Result<(), TowerError> {
    let at = |key| Place::Rna { key };
    let inertia = &rna.inertia_kg_m2;
    check_inputs(rna, at)?;
    check_inertia(at("inertia"), inertia)?;
    if rna.mass_kg == 0.0 && *inertia != Inertia::default() {
        return error(at("mass"), Problem::InertiaWithoutMass);
    }
    Ok(())
}

fn check_point_mass(
    index: usize,
    mass: &PointMass,
    base_m: f64,
    top_m: f64,
) -> Result<(), TowerError> {
    let at = |key| Place::PointMass { index, key };
    check_inputs(mass, at)?;
    check_inertia(at("inertia"), &mass.inertia_kg_m2)?;
    if mass.height_m >= base_m && mass.height_m <= top_m {
        return Ok(());
    }
    error(
        at("height"),
        Problem::OutsideTower {
            height_m: mass.height_m,
            base_m,
            top_m,
        },
    )
}
