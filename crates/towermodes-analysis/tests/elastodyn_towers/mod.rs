//! Towers of the tests of ElastoDyn's rows and shapes.

#![allow(dead_code, reason = "each file of tests uses a part")]

use towermodes::{
    Material, Method, Options, Planes, Properties, PropertyStation, Station, Tower,
    TowerDescription,
};
use towermodes_analysis::elastodyn::{PointMasses, Rows, TowerModel, TowerRows, tower_rows};
use towermodes_testing::with;

pub const HEIGHT_M: f64 = 100.0;
pub const MASS_KG_PER_M: f64 = 5e3;
pub const BENDING_N_M2: f64 = 3e11;

pub fn tower(description: TowerDescription) -> Tower {
    Tower::new(description).expect("a tower")
}

/// A beam of Euler and Bernoulli with the same section everywhere.
pub fn uniform() -> TowerDescription {
    let row = |height_m| bending_only(height_m, MASS_KG_PER_M, Planes::both(BENDING_N_M2));
    with!(TowerDescription, properties = vec![row(0.0), row(HEIGHT_M)])
}

/// A row of a tower that only bends.
pub fn bending_only(
    height_m: f64,
    mass_kg_per_m: f64,
    bending_n_m2: Planes<f64>,
) -> PropertyStation {
    PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m,
            rotary_inertia_kg_m: Planes::both(0.0),
            polar_inertia_kg_m: 0.0,
            bending_n_m2,
            torsion_n_m2: f64::INFINITY,
            axial_n: f64::INFINITY,
            shear_n: None,
        },
    }
}

/// A tube of steel between stations of height, diameter and wall, m.
pub fn tube(stations: &[(f64, f64, f64)]) -> TowerDescription {
    let stations = stations.iter().map(|&(z, d, t)| Station::new(z, d, t));
    TowerDescription {
        materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
        stations: stations.collect(),
        ..TowerDescription::default()
    }
}

pub fn tapered() -> TowerDescription {
    tube(&[(10.0, 6.0, 0.035), (97.6, 3.87, 0.02)])
}

/// With a kink at 40 m and a step at 60 m.
pub fn stepped() -> TowerDescription {
    tube(&[
        (10.0, 6.5, 0.05),
        (40.0, 6.5, 0.04),
        (60.0, 5.5, 0.03),
        (60.0, 5.0, 0.03),
        (110.0, 4.0, 0.02),
    ])
}

pub fn options() -> Options {
    Options {
        method: Method::Spectral,
        rotary_inertia: false,
        points: 2,
        ..Options::default()
    }
}

pub fn accurate(tower: &Tower, from_m: f64, masses: PointMasses) -> TowerRows {
    tower_rows(tower, from_m, Rows::Accurate, masses).expect("rows")
}

/// The uniform tower as ElastoDyn has it, in so many elements that their midpoint rule does not
/// matter.
pub fn uniform_model() -> TowerModel {
    let rows = accurate(&tower(uniform()), 0.0, PointMasses::Listed);
    TowerModel {
        flexible_length_m: HEIGHT_M,
        nodes: 5000,
        stations: rows.stations,
        mass_factor: 1.0,
        stiffness_factors: Planes::both(1.0),
        ..TowerModel::default()
    }
}

#[track_caller]
pub fn near(value: f64, expected: f64, share: f64) {
    let off = (value - expected).abs();
    let holds = off <= share * expected.abs();
    assert!(holds, "{value} instead of {expected}");
}
