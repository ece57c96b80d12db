//! The towers and beams of the manual, shared by all methods and tests.

mod beams;
mod coupled;
pub mod offshore;
mod rotated;
mod turbines;

pub use beams::{Tapered, Uniform};
pub use coupled::{
    floater, monopile, reference_eccentric, reference_in_soil, reference_on_springs,
};
pub use rotated::rotated;
pub use turbines::{nrel_tower, nrel_turbine, uniform_tower, uniform_turbine};

use std::f64::consts::PI;

use towermodes::{
    Inertia, Material, Planes, PointMass, Properties, PropertyStation, Rna, Shear, Station,
    TowerDescription,
};

/// The tower of Nikolić & Šalinić, without a top mass.
pub fn reference() -> TowerDescription {
    TowerDescription {
        name: "reference".into(),
        materials: vec![reference_steel()],
        stations: vec![
            Station::new(0.0, 6.0, 0.027),
            Station::new(87.6, 3.87, 0.019),
        ],
        ..TowerDescription::default()
    }
}

fn reference_steel() -> Material {
    Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)
}

/// The reference tower with a point mass of 350 t on top.
pub fn reference_350t() -> TowerDescription {
    TowerDescription {
        rna: Rna::point(350e3),
        rna_is_point: true,
        ..reference()
    }
}

/// The reference tower with the rotor-nacelle assembly of the NREL 5 MW turbine, centred on the
/// axis.
pub fn reference_with_machine() -> TowerDescription {
    TowerDescription {
        rna: centred_rna(
            349_606.5,
            1.966427,
            [42_620_975.3, 24_376_664.3, 22_652_099.0],
        ),
        ..reference()
    }
}

/// A rotor-nacelle assembly with its centre of mass on the axis and its principal moments of
/// inertia.
fn centred_rna(mass_kg: f64, above_m: f64, [xx, yy, zz]: [f64; 3]) -> Rna {
    Rna {
        mass_kg,
        center_m: [0.0, 0.0, above_m],
        inertia_kg_m2: Inertia {
            xx,
            yy,
            zz,
            ..Inertia::default()
        },
    }
}

/// The reference tower with its wall thickness multiplied by a factor, as a table of eleven equally
/// spaced rows, with a point mass (kg) on top.
pub fn reference_table(wall: f64, top_kg: f64) -> TowerDescription {
    let steel = reference_steel();
    let row = |k: u8| {
        let s = f64::from(k) / 10.0;
        let (d, t) = (6.0 - 2.13 * s, wall * (0.027 - 0.008 * s));
        let area = PI * t * (d - t);
        let second_moment = area * (d * d + (d - 2.0 * t).powi(2)) / 16.0;
        let rotary = steel.density_kg_per_m3 * second_moment;
        PropertyStation {
            height_m: 87.6 * s,
            properties: Properties {
                mass_kg_per_m: steel.density_kg_per_m3 * area,
                rotary_inertia_kg_m: Planes::both(rotary),
                polar_inertia_kg_m: 2.0 * rotary,
                bending_n_m2: Planes::both(steel.youngs_modulus_pa * second_moment),
                torsion_n_m2: 2.0 * steel.shear_modulus_pa * second_moment,
                axial_n: steel.youngs_modulus_pa * area,
                shear_n: None,
            },
        }
    };
    TowerDescription {
        name: "reference, eleven rows".into(),
        properties: (0..11).map(row).collect(),
        rna: Rna::point(top_kg),
        rna_is_point: true,
        ..TowerDescription::default()
    }
}

/// A stepped tower of two materials with all features of a tower of tubes, for tests of
/// invariances.
pub fn rich() -> TowerDescription {
    let steel = Material::from_poissons_ratio(7850.0, 2.1e11, 0.3);
    let concrete = Material::from_poissons_ratio(2500.0, 3.6e10, 0.2);
    let station = |z, d, t, material| Station {
        material,
        ..Station::new(z, d, t)
    };
    let mass = |height_m, mass_kg| PointMass {
        height_m,
        mass_kg,
        ..PointMass::default()
    };
    TowerDescription {
        name: "rich".into(),
        materials: vec![steel, concrete],
        stations: vec![
            station(10.0, 9.0, 0.5, 1),
            station(50.0, 7.5, 0.4, 1),
            station(50.0, 6.0, 0.045, 0),
            station(80.0, 6.0, 0.035, 0),
            station(120.0, 4.0, 0.022, 0),
        ],
        outfitting_factor: 1.05,
        shear: Shear::Cowper,
        rna: centred_rna(400e3, 2.1, [4.4e7, 2.4e7, 2.5e7]),
        point_masses: vec![mass(50.0, 20e3), mass(95.0, 8e3)],
        ..TowerDescription::default()
    }
}

/// A tower of elliptic sections with a step, as a table; all properties of the bending planes
/// differ.
pub fn elliptic() -> TowerDescription {
    let row = |height_m: f64, scale: f64| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 4000.0 * scale,
            rotary_inertia_kg_m: Planes {
                fore_aft: 9000.0 * scale.powi(3),
                side_side: 16_000.0 * scale.powi(3),
            },
            polar_inertia_kg_m: 25_000.0 * scale.powi(3),
            bending_n_m2: Planes {
                fore_aft: 2.2e11 * scale.powi(3),
                side_side: 3.9e11 * scale.powi(2),
            },
            torsion_n_m2: 2.1e11 * scale.powi(3),
            axial_n: 1.0e11 * scale,
            shear_n: Some(Planes {
                fore_aft: 2.1e10 * scale,
                side_side: 1.7e10 * scale,
            }),
        },
    };
    TowerDescription {
        name: "elliptic".into(),
        properties: vec![
            row(5.0, 1.3),
            row(40.0, 1.1),
            row(40.0, 1.0),
            row(95.0, 0.6),
        ],
        rna: centred_rna(300e3, 1.8, [4e7, 2e7, 2e7]),
        ..TowerDescription::default()
    }
}
