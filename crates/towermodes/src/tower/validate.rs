//! The checks that turn a description into a tower.

use super::description::{PointMass, Rna, Shear, Station, TowerDescription};
use super::error::{Place, Problem, TowerError};
use super::material::Material;

/// Everything a description must satisfy to be a tower.
pub(super) fn validate(description: &TowerDescription) -> Result<(), TowerError> {
    for (index, material) in description.materials.iter().enumerate() {
        check_material(index, material)?;
    }
    check_stations(&description.stations, description.materials.len())?;
    positive(
        Place::OutfittingFactor,
        "the outfitting factor",
        description.outfitting_factor,
        "",
    )?;
    check_shear(description.shear)?;
    check_rna(&description.rna)?;
    let (base_m, top_m) = ends(&description.stations);
    for (index, mass) in description.point_masses.iter().enumerate() {
        check_point_mass(index, mass, base_m, top_m)?;
    }
    Ok(())
}

fn error<T>(place: Place, problem: Problem) -> Result<T, TowerError> {
    Err(TowerError { place, problem })
}

fn finite(place: Place, quantity: &'static str, value: f64) -> Result<(), TowerError> {
    if value.is_finite() {
        return Ok(());
    }
    error(place, Problem::NotFinite { quantity, value })
}

fn positive(
    place: Place,
    quantity: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<(), TowerError> {
    finite(place, quantity, value)?;
    if value > 0.0 {
        return Ok(());
    }
    error(
        place,
        Problem::NotPositive {
            quantity,
            value,
            unit,
        },
    )
}

fn not_negative(
    place: Place,
    quantity: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<(), TowerError> {
    finite(place, quantity, value)?;
    if value >= 0.0 {
        return Ok(());
    }
    error(
        place,
        Problem::Negative {
            quantity,
            value,
            unit,
        },
    )
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

fn check_stations(stations: &[Station], materials: usize) -> Result<(), TowerError> {
    if stations.len() < 2 {
        return error(
            Place::Stations,
            Problem::TooFewStations {
                count: stations.len(),
            },
        );
    }
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
    check_heights(stations)
}

fn check_tube(index: usize, station: &Station) -> Result<(), TowerError> {
    let at = |key| Place::Station { index, key };
    let (d, t) = (station.outer_diameter_m, station.wall_thickness_m);
    finite(at("height"), "height", station.height_m)?;
    positive(at("diameter"), "outer diameter", d, " m")?;
    positive(at("wall"), "wall thickness", t, " m")?;
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

fn check_heights(stations: &[Station]) -> Result<(), TowerError> {
    let (base_m, top_m) = ends(stations);
    if stations.iter().all(|s| s.height_m == base_m) {
        return error(Place::Stations, Problem::NoHeight { height_m: base_m });
    }
    for index in 1..stations.len() {
        let place = Place::Station {
            index,
            key: "height",
        };
        let (height_m, previous_m) = (stations[index].height_m, stations[index - 1].height_m);
        if height_m < previous_m {
            return error(
                place,
                Problem::HeightDecreases {
                    height_m,
                    previous_m,
                },
            );
        }
        if index > 1 && height_m == stations[index - 2].height_m {
            return error(place, Problem::HeightThrice { height_m });
        }
    }
    finite(Place::Stations, "the tower's height", top_m - base_m)
}

fn ends(stations: &[Station]) -> (f64, f64) {
    (stations[0].height_m, stations[stations.len() - 1].height_m)
}

fn check_shear(shear: Shear) -> Result<(), TowerError> {
    match shear {
        Shear::Coefficient(value) if !(value > 0.0 && value <= 1.0) => {
            error(Place::Shear, Problem::ShearCoefficient { value })
        }
        _ => Ok(()),
    }
}

fn check_rna(rna: &Rna) -> Result<(), TowerError> {
    let at = |key| Place::Rna { key };
    let inertia = &rna.inertia_kg_m2;
    not_negative(at("mass"), "mass", rna.mass_kg, " kg")?;
    for (quantity, value) in ["centre x", "centre y", "centre z"]
        .into_iter()
        .zip(rna.center_m)
    {
        finite(at("center"), quantity, value)?;
    }
    not_negative(at("inertia"), "inertia xx", inertia.xx, " kg m2")?;
    not_negative(at("inertia"), "inertia yy", inertia.yy, " kg m2")?;
    not_negative(at("inertia"), "inertia zz", inertia.zz, " kg m2")?;
    let products = [inertia.xy, inertia.xz, inertia.yz];
    for value in products {
        finite(at("inertia"), "product of inertia", value)?;
    }
    if rna.mass_kg == 0.0 && [inertia.xx, inertia.yy, inertia.zz] != [0.0; 3] {
        return error(at("mass"), Problem::InertiaWithoutMass);
    }
    check_centred(rna)
}

/// The families of modes decouple only for a machine centred on the tower's axis.
fn check_centred(rna: &Rna) -> Result<(), TowerError> {
    let [x_m, y_m, _] = rna.center_m;
    let inertia = &rna.inertia_kg_m2;
    if x_m != 0.0 || y_m != 0.0 {
        return error(
            Place::Rna { key: "center" },
            Problem::EccentricRna { x_m, y_m },
        );
    }
    let (xy, xz, yz) = (inertia.xy, inertia.xz, inertia.yz);
    if [xy, xz, yz] != [0.0; 3] {
        return error(
            Place::Rna { key: "inertia" },
            Problem::ProductsOfInertia { xy, xz, yz },
        );
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
    finite(at("height"), "height", mass.height_m)?;
    not_negative(at("mass"), "mass", mass.mass_kg, " kg")?;
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
