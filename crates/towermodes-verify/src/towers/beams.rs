//! Beams with frequencies from the literature, as multiples of a unit.

use std::f64::consts::{PI, TAU};

use towermodes::{
    Foundation, FoundationSprings, Inertia, Material, Planes, Properties, PropertyStation, Rna,
    Shear, SoilRow, SoilStiffness, Station, TowerDescription,
};

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

    /// A tube with slenderness r = √(I/A)/L and E/(κG) = s, with κ = 1/2 if it has shear
    /// deformation; otherwise G = 0.4 E.
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

    /// With a tip mass μ = M/(mL), its inertia j = J/(mL³) about its centre, and the centre ε = e/L
    /// above the tip.
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

    /// With the centre of the tip mass d = x/L beside the axis, fore-aft.
    pub fn with_offset(mut self, d: f64) -> Self {
        self.description.rna.center_m[0] = d * Self::LENGTH_M;
        self
    }

    /// On springs k_T = K_T L³/(EI), against translation, which may be infinite, and k_R = K_R
    /// L/(EI), against rotation, in both planes.
    pub fn on_springs(mut self, k_t: f64, k_r: f64) -> Self {
        let (ei, length) = (self.bending_n_m2(), Self::LENGTH_M);
        self.description.foundation = Foundation::Springs(FoundationSprings {
            lateral_n_per_m: k_t * ei / length.powi(3),
            rocking_n_m: k_r * ei / length,
            ..FoundationSprings::RIGID
        });
        self
    }

    /// In soil of stiffness k L⁴/(EI) over the whole height, against translation in both planes.
    pub fn in_soil(mut self, k: f64) -> Self {
        let spring = k * self.bending_n_m2() / Self::LENGTH_M.powi(4);
        let row = |height_m| SoilRow {
            height_m,
            stiffness: SoilStiffness {
                x_n_per_m2: spring,
                y_n_per_m2: spring,
                ..SoilStiffness::default()
            },
        };
        self.description.soil = vec![vec![row(0.0), row(Self::LENGTH_M)]];
        self
    }

    /// With gravity α = m g L³/(EI).
    pub fn under_gravity(mut self, alpha: f64) -> Self {
        let weight = alpha * self.bending_n_m2() / Self::LENGTH_M.powi(3);
        self.description.gravity_m_per_s2 = weight / self.mass_per_length;
        self
    }

    /// EI, N m².
    fn bending_n_m2(&self) -> f64 {
        self.mass_per_length * (TAU * self.unit_hz).powi(2) * Self::LENGTH_M.powi(4)
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

    /// A tube so thin that it is a wedge: depth 1 − cx and width 1 − wx give A ∝ depth·width, I ∝
    /// depth³·width.
    ///
    /// The wall is 1e-9 of the diameter; this is also the relative deviation of A and I from these
    /// laws.
    pub fn wedge(c: f64, w: f64) -> Self {
        let (d, t) = (Self::DIAMETER_M, 1e-9 * Self::DIAMETER_M);
        let top = [d * (1.0 - c), t * (1.0 - w)];
        Self::of_tubes([d, t], top, d / 8.0_f64.sqrt())
    }

    /// A beam of which only the width tapers: A and I ∝ 1 − cx, as a table of two rows; the
    /// side-side plane is four times as stiff, which doubles its frequencies.
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
