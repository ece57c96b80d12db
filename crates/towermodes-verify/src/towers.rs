//! The towers and beams of the manual, one library for all methods and tests.

use std::f64::consts::{PI, TAU};

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

/// The same with a point mass of 350 t on top.
pub fn reference_350t() -> TowerDescription {
    TowerDescription {
        rna: Rna::point(350e3),
        ..reference()
    }
}

/// The same with the rotor-nacelle assembly of the NREL 5 MW turbine, centred on the axis.
pub fn reference_with_machine() -> TowerDescription {
    TowerDescription {
        rna: Rna {
            mass_kg: 349_606.5,
            center_m: [0.0, 0.0, 1.966427],
            inertia_kg_m2: Inertia {
                xx: 42_620_975.3,
                yy: 24_376_664.3,
                zz: 22_652_099.0,
                ..Inertia::default()
            },
        },
        ..reference()
    }
}

/// The reference tower with its wall so many times as thick, as a table of eleven equal rows, with a point mass (kg) on top.
pub fn reference_table(wall: f64, top_kg: f64) -> TowerDescription {
    let steel = reference_steel();
    let row = |k: usize| {
        let s = k as f64 / 10.0;
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
        ..TowerDescription::default()
    }
}

/// A stepped tower of two materials with everything a tower of tubes can have, for invariances.
pub fn rich() -> TowerDescription {
    let steel = Material::from_poissons_ratio(7850.0, 2.1e11, 0.3);
    let concrete = Material::from_poissons_ratio(2500.0, 3.6e10, 0.2);
    let station = |z, d, t, material| Station {
        material,
        ..Station::new(z, d, t)
    };
    let mass = |height_m, mass_kg| PointMass { height_m, mass_kg };
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
        point_masses: vec![mass(50.0, 20e3), mass(95.0, 8e3)],
        ..TowerDescription::default()
    }
}

/// A tower of elliptic sections with a step, whose bending planes differ in everything, as a table.
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
        rna: Rna {
            mass_kg: 300e3,
            center_m: [0.0, 0.0, 1.8],
            inertia_kg_m2: Inertia {
                xx: 4e7,
                yy: 2e7,
                zz: 2e7,
                ..Inertia::default()
            },
        },
        ..TowerDescription::default()
    }
}

/// A uniform tube as a clamped beam.
#[derive(Debug, Clone)]
pub struct Uniform {
    /// The beam.
    pub description: TowerDescription,
    /// √(EI/(m L⁴))/2π, Hz.
    pub unit_hz: f64,
    mass_per_length: f64,
}

impl Uniform {
    /// Length, m.
    pub const LENGTH_M: f64 = 50.0;
    /// Young's modulus, Pa.
    pub const YOUNGS_MODULUS_PA: f64 = 2.0e11;
    /// Density, kg/m³.
    pub const DENSITY_KG_PER_M3: f64 = 8000.0;

    /// A tube with slenderness r = √(I/A)/L and E/(κG) = s, with κ = 1/2 where it shears; G = 0.4 E where it does not.
    pub fn new(r: f64, s: Option<f64>) -> Self {
        let (length, e) = (Self::LENGTH_M, Self::YOUNGS_MODULUS_PA);
        // I/A = (d² + dᵢ²)/16 with dᵢ = 0.9 d.
        let d = 4.0 * r * length / (1.0_f64 + 0.81).sqrt();
        let kappa = 0.5;
        let g = s.map_or(0.4 * e, |s| e / (kappa * s));
        let tube = |z| Station::new(z, d, 0.05 * d);
        let description = TowerDescription {
            materials: vec![Material::from_shear_modulus(Self::DENSITY_KG_PER_M3, e, g)],
            stations: vec![tube(0.0), tube(length)],
            shear: s.map_or(Shear::Rigid, |_| Shear::Coefficient(kappa)),
            ..TowerDescription::default()
        };
        // EI/m = (E/ρ) (r L)².
        let wave = (e / Self::DENSITY_KG_PER_M3).sqrt();
        Self {
            description,
            unit_hz: wave * r / length / TAU,
            mass_per_length: Self::DENSITY_KG_PER_M3 * PI * 0.05 * d * 0.95 * d,
        }
    }

    /// The frequency of a dimensionless λ, ω = λ √(EI/(m L⁴)), Hz.
    pub fn frequency_hz(&self, lambda: f64) -> f64 {
        lambda * self.unit_hz
    }

    /// With a tip mass μ = M/(mL), its inertia j = J/(mL³) about its centre, and the centre ε = e/L above the tip.
    pub fn with_tip(mut self, mu: f64, j: f64, eps: f64) -> Self {
        let length = Self::LENGTH_M;
        let inertia = j * self.mass_per_length * length.powi(3);
        self.description.rna = Rna {
            mass_kg: mu * self.mass_per_length * length,
            center_m: [0.0, 0.0, eps * length],
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

/// A tapered beam of 60 m and its unit of frequency at the clamped end, √(EI₀/(m₀ L⁴))/2π, Hz.
pub struct Tapered {
    /// The beam.
    pub description: TowerDescription,
    /// √(EI₀/(m₀ L⁴))/2π, Hz.
    pub unit_hz: f64,
}

impl Tapered {
    const LENGTH_M: f64 = 60.0;
    const DIAMETER_M: f64 = 2.0;
    /// √(E/ρ), m/s.
    const WAVE_M_PER_S: f64 = 5000.0;

    fn of_tubes(base: [f64; 2], top: [f64; 2], gyration_m: f64) -> Self {
        let station = |z, [d, t]: [f64; 2]| Station::new(z, d, t);
        Self {
            description: TowerDescription {
                materials: vec![Material::from_shear_modulus(8000.0, 2.0e11, 0.8e11)],
                stations: vec![station(0.0, base), station(Self::LENGTH_M, top)],
                ..TowerDescription::default()
            },
            unit_hz: Self::WAVE_M_PER_S * gyration_m / Self::LENGTH_M.powi(2) / TAU,
        }
    }

    /// A solid cone: A ∝ (1 − cx)², I ∝ (1 − cx)⁴.
    pub fn cone(c: f64) -> Self {
        let d = Self::DIAMETER_M;
        let rod = |d: f64| [d, 0.5 * d];
        Self::of_tubes(rod(d), rod(d * (1.0 - c)), 0.25 * d)
    }

    /// A tube so thin that it is a wedge: depth 1 − cx and width 1 − wx give A ∝ depth·width, I ∝ depth³·width.
    ///
    /// The wall is 1e-9 of the diameter, which is also how far A and I are from these laws.
    pub fn wedge(c: f64, w: f64) -> Self {
        let (d, t) = (Self::DIAMETER_M, 1e-9 * Self::DIAMETER_M);
        let top = [d * (1.0 - c), t * (1.0 - w)];
        Self::of_tubes([d, t], top, d / 8.0_f64.sqrt())
    }

    /// Width alone tapers: A and I ∝ 1 − cx, as a table of two rows; the side-side plane is four times as stiff, which doubles its
    /// frequencies.
    pub fn width(c: f64) -> Self {
        let gyration_m = 0.5;
        let row = |height_m: f64, share: f64| {
            let mass = 8000.0 * share;
            let ei = mass * (Self::WAVE_M_PER_S * gyration_m).powi(2);
            PropertyStation {
                height_m,
                properties: Properties {
                    mass_kg_per_m: mass,
                    rotary_inertia_kg_m: Planes::both(0.0),
                    polar_inertia_kg_m: mass,
                    bending_n_m2: Planes {
                        fore_aft: ei,
                        side_side: 4.0 * ei,
                    },
                    torsion_n_m2: 1e10 * share,
                    axial_n: mass * Self::WAVE_M_PER_S.powi(2),
                    shear_n: None,
                },
            }
        };
        Self {
            description: TowerDescription {
                properties: vec![row(0.0, 1.0), row(Self::LENGTH_M, 1.0 - c)],
                ..TowerDescription::default()
            },
            unit_hz: Self::WAVE_M_PER_S * gyration_m / Self::LENGTH_M.powi(2) / TAU,
        }
    }
}
