//! Towers whose frequencies are known from elsewhere: one library for all tests and all methods.
//!
//! Units: the beam tests use a tube whose EI, mass per length and length are what they are; a dimensionless λ of the literature,
//! ω = λ √(EI/(m L⁴)), is turned into Hz by [`Uniform::frequency_hz`].
#![allow(dead_code, reason = "each test file uses its own part of the library")]

use std::f64::consts::TAU;

use towermodes::{
    Family, Inertia, Material, Options, Rna, Shear, Solution, Station, Tower, TowerDescription,
    solve,
};

/// The tower of Nikolić & Šalinić, without a top mass.
pub fn reference() -> TowerDescription {
    TowerDescription {
        name: "reference".into(),
        materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
        stations: vec![
            Station::new(0.0, 6.0, 0.027),
            Station::new(87.6, 3.87, 0.019),
        ],
        ..TowerDescription::default()
    }
}

/// The same with a point mass of 350 t on top.
pub fn reference_350t() -> TowerDescription {
    TowerDescription {
        rna: Rna::point(350e3),
        ..reference()
    }
}

/// A stepped tower of three materials with everything this version knows, for invariances.
pub fn rich() -> TowerDescription {
    let steel = Material::from_poissons_ratio(7850.0, 2.1e11, 0.3);
    let concrete = Material::from_poissons_ratio(2500.0, 3.6e10, 0.2);
    let station = |z, d, t, material| Station {
        material,
        ..Station::new(z, d, t)
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
        rna: Rna {
            mass_kg: 400e3,
            center_m: [0.0, 0.0, 2.1],
            inertia_kg_m2: Inertia {
                xx: 4.4e7,
                yy: 2.4e7,
                zz: 2.5e7,
                ..Inertia::default()
            },
        },
        point_masses: vec![
            towermodes::PointMass {
                height_m: 50.0,
                mass_kg: 20e3,
            },
            towermodes::PointMass {
                height_m: 95.0,
                mass_kg: 8e3,
            },
        ],
        ..TowerDescription::default()
    }
}

/// A uniform tube as a clamped beam.
pub struct Uniform {
    pub description: TowerDescription,
    /// √(EI/(m L⁴))/2π, Hz.
    unit_hz: f64,
    mass_per_length: f64,
    length: f64,
}

impl Uniform {
    /// A tube with slenderness r = √(I/A)/L and E/(κG) = s (κ = 1/2 where shear is on).
    pub fn new(r: f64, s: Option<f64>) -> Self {
        // I/A = (d² + dᵢ²)/16; with L = 50 m and dᵢ = 0.9 d this gives d.
        let length = 50.0;
        let d = 4.0 * r * length / (1.0_f64 + 0.81).sqrt();
        let kappa = 0.5;
        let e = 2.0e11;
        let g = s.map_or(0.4 * e, |s| e / (kappa * s));
        let material = Material::from_shear_modulus(8000.0, e, g);
        let description = TowerDescription {
            materials: vec![material],
            stations: vec![
                Station::new(0.0, d, 0.05 * d),
                Station::new(length, d, 0.05 * d),
            ],
            shear: s.map_or(Shear::Rigid, |_| Shear::Coefficient(kappa)),
            ..TowerDescription::default()
        };
        let radius_of_gyration = r * length;
        // EI/m = (E/ρ) r².
        let wave = (e / 8000.0).sqrt() * radius_of_gyration;
        let area = std::f64::consts::PI * 0.05 * d * 0.95 * d;
        Self {
            description,
            unit_hz: wave / (length * length) / TAU,
            mass_per_length: 8000.0 * area,
            length,
        }
    }

    /// The frequency of a dimensionless λ.
    pub fn frequency_hz(&self, lambda: f64) -> f64 {
        lambda * self.unit_hz
    }

    /// With a tip mass μ = M/(mL), its inertia j = J/(mL³) about its centre, and the centre ε = e/L above the tip.
    pub fn with_tip(mut self, mu: f64, j: f64, eps: f64) -> Self {
        let mass_kg = mu * self.mass_per_length * self.length;
        let inertia = j * self.mass_per_length * self.length.powi(3);
        self.description.rna = Rna {
            mass_kg,
            center_m: [0.0, 0.0, eps * self.length],
            inertia_kg_m2: Inertia {
                xx: inertia,
                yy: inertia,
                zz: inertia,
                ..Inertia::default()
            },
        };
        self
    }
}

/// A solid cone: A ∝ (1 − cx)², I ∝ (1 − cx)⁴, the thick end clamped.
pub fn cone(c: f64) -> (TowerDescription, f64) {
    let (length, d) = (60.0, 2.0);
    let (e, density) = (2.0e11, 8000.0);
    let rod = |z: f64, d: f64| Station::new(z, d, d / 2.0);
    let description = TowerDescription {
        materials: vec![Material::from_shear_modulus(density, e, 0.4 * e)],
        stations: vec![rod(0.0, d), rod(length, d * (1.0 - c))],
        ..TowerDescription::default()
    };
    // EI₀/m₀ = (E/ρ) d²/16.
    let unit_hz = (e / density).sqrt() * d / 4.0 / (length * length) / TAU;
    (description, unit_hz)
}

/// Solves a description or panics with what is wrong.
pub fn solved(description: &TowerDescription, options: &Options) -> Solution {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    solve(&tower, options).expect("a solvable tower")
}

/// The frequencies of a family, rising, Hz.
pub fn frequencies(solution: &Solution, family: Family) -> Vec<f64> {
    let of_family = solution.modes.iter().filter(|m| m.family == family);
    of_family.map(|m| m.frequency_hz).collect()
}

/// The extrapolated frequencies of a family, rising, Hz.
pub fn extrapolated(solution: &Solution, family: Family) -> Vec<f64> {
    let of_family = solution.modes.iter().filter(|m| m.family == family);
    of_family.map(|m| m.extrapolated_hz).collect()
}

/// Asserts |got/expected − 1| ≤ tolerance, naming the case.
#[track_caller]
pub fn assert_close(got: f64, expected: f64, tolerance: f64, case: &str) {
    let difference = got / expected - 1.0;
    assert!(
        difference.abs() <= tolerance,
        "{case}: got {got:.12}, expected {expected:.12}, relative difference {difference:.2e} > {tolerance:.0e}"
    );
}
