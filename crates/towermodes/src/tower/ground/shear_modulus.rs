//! The value from which the shear modulus of soil at small strains, G₀, is computed.

use crate::inputs::{Given, Input, Inputs, Limit, Named, Quantity, Value, names};

/// The value from which the shear modulus G₀ of a layer at small strains is computed. Values with
/// two entries are at the top and at the bottom of the layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShearModulus {
    /// G₀ itself is given.
    Given {
        /// G₀, Pa.
        shear_modulus_pa: [f64; 2],
    },
    /// Young's modulus: G₀ = E/(2(1 + ν)) with Poisson's ratio of the layer.
    Youngs {
        /// Young's modulus E, Pa.
        youngs_modulus_pa: [f64; 2],
    },
    /// The measured velocity of shear waves: G₀ = ρ V_s².
    WaveVelocity {
        /// Velocity of shear waves V_s, m/s.
        velocity_m_per_s: [f64; 2],
        /// Density ρ of soil with its water, kg/m³.
        density_kg_per_m3: f64,
    },
    /// Cone resistance in sand: Rix & Stokoe (1991).
    RixStokoe {
        /// Cone resistance q_c, Pa.
        cone_resistance_pa: [f64; 2],
    },
    /// Cone resistance in clay: Mayne & Rix (1993).
    MayneRix {
        /// Cone resistance q_c, Pa.
        cone_resistance_pa: [f64; 2],
    },
    /// Cone resistance and soil behaviour type index, any soil: Robertson & Cabal (2015).
    RobertsonCabal {
        /// Cone resistance q_t, corrected for pore pressure, Pa.
        cone_resistance_pa: [f64; 2],
        /// Soil behaviour type index I_c.
        behaviour_index: f64,
        /// Density ρ of soil with its water, kg/m³.
        density_kg_per_m3: f64,
    },
    /// Void ratio of sand: Hardin's formula with the constant of PISA.
    Hardin {
        /// Void ratio e.
        void_ratio: f64,
        /// Coefficient of earth pressure at rest K₀.
        earth_pressure_at_rest: f64,
    },
    /// Blow count of the standard penetration test: Imai & Tonouchi (1982).
    BlowCount {
        /// Blows N per 0.3 m.
        blow_count: [f64; 2],
        /// Density ρ of soil with its water, kg/m³.
        density_kg_per_m3: f64,
    },
}

impl ShearModulus {
    /// Whether it is linear in height between any values at top and bottom.
    pub(super) fn is_linear(&self) -> bool {
        match self {
            Self::Given { .. } | Self::Youngs { .. } => true,
            Self::WaveVelocity { .. }
            | Self::RixStokoe { .. }
            | Self::MayneRix { .. }
            | Self::RobertsonCabal { .. }
            | Self::Hardin { .. }
            | Self::BlowCount { .. } => false,
        }
    }

    /// The key by which it is given.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Given { .. } => "shear_modulus",
            Self::Youngs { .. } => "youngs_modulus",
            Self::WaveVelocity { .. } => "shear_wave_velocity",
            Self::RixStokoe { .. } | Self::MayneRix { .. } | Self::RobertsonCabal { .. } => {
                "cone_resistance"
            }
            Self::Hardin { .. } => "void_ratio",
            Self::BlowCount { .. } => "blow_count",
        }
    }

    /// The soil that the correlation was made for; none for a measurement, and for a correlation of
    /// any soil.
    pub(in crate::tower) fn own_soil(&self) -> Option<CorrelatedSoil> {
        match self {
            Self::RixStokoe { .. } => Some(CorrelatedSoil::Sand("rix-stokoe")),
            Self::Hardin { .. } => Some(CorrelatedSoil::Sand("Hardin's formula (void_ratio)")),
            Self::MayneRix { .. } => Some(CorrelatedSoil::Clay("mayne-rix")),
            Self::Given { .. }
            | Self::Youngs { .. }
            | Self::WaveVelocity { .. }
            | Self::RobertsonCabal { .. }
            | Self::BlowCount { .. } => None,
        }
    }

    /// Whether it depends on the stress that is left after scour; a measured value and a
    /// correlation with a measurement are values before scour.
    pub(in crate::tower) fn follows_scour(&self) -> bool {
        match self {
            Self::Hardin { .. } => true,
            Self::Given { .. }
            | Self::Youngs { .. }
            | Self::WaveVelocity { .. }
            | Self::RixStokoe { .. }
            | Self::MayneRix { .. }
            | Self::RobertsonCabal { .. }
            | Self::BlowCount { .. } => false,
        }
    }

    /// Whether it depends on the weight of the soil above.
    pub(in crate::tower) fn needs_stress(&self) -> bool {
        match self {
            Self::RixStokoe { .. } | Self::RobertsonCabal { .. } | Self::Hardin { .. } => true,
            Self::Given { .. }
            | Self::Youngs { .. }
            | Self::WaveVelocity { .. }
            | Self::MayneRix { .. }
            | Self::BlowCount { .. } => false,
        }
    }
}

/// A value at the top and at the bottom of the layer.
const fn profile(key: &'static str, unit: &'static str, name: &'static str) -> Input {
    Input::new(key, unit, Limit::Positive, name).optional()
}

/// Young's modulus of soil, and of rock.
pub(super) const YOUNGS_MODULUS: Input =
    profile("youngs_modulus", " Pa", "Young's modulus of the layer")
        .note("at small strains")
        .also("young_s_modulus e e0 e_0 e_ir")
        .symbol("E", 1e-6, " MPa")
        .usual_of(Quantity::SoilYoungsModulus, [1e6, 5e10]);
const CONE: Input = profile("cone_resistance", " Pa", "the cone resistance").also("qc q_c qt q_t");
static GIVEN: Input = profile("shear_modulus", " Pa", "the shear modulus of the soil")
    .note("at small strains")
    .also("g g0 g_0 gmax g_max")
    .symbol("G₀", 1e-6, " MPa")
    .usual_of(Quantity::SoilShearModulus, [5e5, 5e10]);
static YOUNGS: Input = YOUNGS_MODULUS;
static VELOCITY: Input = profile("shear_wave_velocity", " m/s", "the velocity of shear waves")
    .also("vs v_s")
    .symbol("V_s", 1.0, " m/s")
    .usual(
        [30.0, 4000.0],
        "soft clay has about 100, dense sand 300, rock 1500; the unit is m/s",
    );
static CONE_IN_SAND: Input = CONE.symbol("G₀ by Rix & Stokoe, q_c", 1e-6, " MPa").usual(
    [5e5, 1.5e8],
    "clay has 3e5 to 3e6, dense sand 2e7 to 6e7; the unit is Pa, not kPa or MPa",
);
static CONE_IN_CLAY: Input = CONE.symbol("G₀ by Mayne & Rix, q_c", 1e-6, " MPa").usual(
    [5e4, 3e7],
    "clay has 3e5 to 3e6, dense sand 2e7 to 6e7; the unit is Pa, not kPa or MPa",
);
static CONE_IN_SOIL: Input = CONE
    .symbol("G₀ by Robertson & Cabal, q_t", 1e-6, " MPa")
    .usual(
        [5e4, 1.5e8],
        "clay has 3e5 to 3e6, dense sand 2e7 to 6e7; the unit is Pa, not kPa or MPa",
    );
static CORRELATION: Input = Input::choice("correlation", "the correlation")
    .optional()
    .note("of the cone resistance: rix-stokoe, mayne-rix or robertson-cabal");
static BEHAVIOUR_INDEX: Input = Input::new(
    "behaviour_index",
    "",
    Limit::Within([0.5, 5.0]),
    "the soil behaviour type index",
)
.optional()
.note("soil behaviour type index I_c")
.hint("the soil behaviour type index I_c, about 1 to 4")
.symbol("I_c", 1.0, "")
.usual([1.0, 4.0], "clean sand has about 1.5, clay 3");
static BLOW_COUNT: Input = profile("blow_count", "", "the blow count")
    .note("standard penetration test")
    .also("n spt spt_n n_spt")
    .symbol("G₀ by Imai & Tonouchi, N", 1.0, "")
    .usual([1.0, 100.0], "typical: 2 to 60 blows per 0.3 m");
static VOID_RATIO: Input = Input::new("void_ratio", "", Limit::Positive, "the void ratio")
    .optional()
    .symbol("G₀ by Hardin, e", 1.0, "")
    .usual(
        [0.25, 2.0],
        "dense sand has about 0.5, loose sand 0.8; it is a fraction, not percent",
    );
static EARTH_PRESSURE: Input = Input::new(
    "earth_pressure_at_rest",
    "",
    Limit::Positive,
    "the coefficient of earth pressure at rest",
)
.optional()
.note("coefficient K0")
.hint("the coefficient K0, about 0.4")
.symbol("K₀", 1.0, "")
.usual([0.2, 3.0], "normally consolidated sand has about 0.4, overconsolidated soil up to 2; it is a fraction, not percent");
static DENSITY: Input = Input::new(
    "density",
    " kg/m3",
    Limit::Positive,
    "the density of the soil with its water",
)
.optional()
.note("of the soil with its water")
.hint("density of the soil with its water in kg/m3, about 1900")
.symbol("ρ", 1.0, " kg/m³")
.usual(
    [1000.0, 3000.0],
    "soil with its water has 1600 to 2200; the unit is kg/m3",
);

/// The correlations of a cone resistance.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Correlation {
    RixStokoe,
    MayneRix,
    RobertsonCabal,
}

names!(Correlation:
    RixStokoe = "rix-stokoe",
    MayneRix = "mayne-rix",
    RobertsonCabal = "robertson-cabal",
);

impl ShearModulus {
    /// One of each, with blank values.
    pub fn blanks() -> [Self; 8] {
        let (one, pair) = (f64::NAN, [f64::NAN; 2]);
        [
            Self::Given {
                shear_modulus_pa: pair,
            },
            Self::Youngs {
                youngs_modulus_pa: pair,
            },
            Self::WaveVelocity {
                velocity_m_per_s: pair,
                density_kg_per_m3: one,
            },
            Self::RixStokoe {
                cone_resistance_pa: pair,
            },
            Self::MayneRix {
                cone_resistance_pa: pair,
            },
            Self::RobertsonCabal {
                cone_resistance_pa: pair,
                behaviour_index: one,
                density_kg_per_m3: one,
            },
            Self::BlowCount {
                blow_count: pair,
                density_kg_per_m3: one,
            },
            Self::Hardin {
                void_ratio: one,
                earth_pressure_at_rest: one,
            },
        ]
    }

    /// The names of the correlations of a cone resistance.
    pub fn correlations() -> &'static [&'static str] {
        Correlation::NAMES
    }

    /// The name of the correlation, of a cone resistance.
    pub fn correlation(&self) -> Option<&'static str> {
        self.cone_correlation().map(Named::name)
    }

    fn cone_correlation(&self) -> Option<Correlation> {
        match self {
            Self::RixStokoe { .. } => Some(Correlation::RixStokoe),
            Self::MayneRix { .. } => Some(Correlation::MayneRix),
            Self::RobertsonCabal { .. } => Some(Correlation::RobertsonCabal),
            Self::Given { .. }
            | Self::Youngs { .. }
            | Self::WaveVelocity { .. }
            | Self::Hardin { .. }
            | Self::BlowCount { .. } => None,
        }
    }

    /// Its values with their descriptions; the name of the correlation stays.
    fn values(&mut self, each: &mut dyn FnMut(&'static Input, &mut dyn Value)) {
        let correlation = self.cone_correlation();
        let mut numbers: Vec<(&'static Input, &mut dyn Value)> = match self {
            Self::Given { shear_modulus_pa } => vec![(&GIVEN, shear_modulus_pa)],
            Self::Youngs { youngs_modulus_pa } => vec![(&YOUNGS, youngs_modulus_pa)],
            Self::WaveVelocity {
                velocity_m_per_s,
                density_kg_per_m3,
            } => vec![(&VELOCITY, velocity_m_per_s), (&DENSITY, density_kg_per_m3)],
            Self::RixStokoe { cone_resistance_pa } => vec![(&CONE_IN_SAND, cone_resistance_pa)],
            Self::MayneRix { cone_resistance_pa } => vec![(&CONE_IN_CLAY, cone_resistance_pa)],
            Self::RobertsonCabal {
                cone_resistance_pa,
                behaviour_index,
                density_kg_per_m3,
            } => vec![
                (&CONE_IN_SOIL, cone_resistance_pa),
                (&BEHAVIOUR_INDEX, behaviour_index),
                (&DENSITY, density_kg_per_m3),
            ],
            Self::BlowCount {
                blow_count,
                density_kg_per_m3,
            } => vec![(&BLOW_COUNT, blow_count), (&DENSITY, density_kg_per_m3)],
            Self::Hardin {
                void_ratio,
                earth_pressure_at_rest,
            } => vec![
                (&VOID_RATIO, void_ratio),
                (&EARTH_PRESSURE, earth_pressure_at_rest),
            ],
        };
        for (place, (input, value)) in numbers.iter_mut().enumerate() {
            each(input, *value);
            if let Some(mut correlation) = correlation.filter(|_| place == 0) {
                each(&CORRELATION, &mut correlation);
            }
        }
    }
}

impl Inputs for Option<ShearModulus> {
    fn blank() -> Self {
        None
    }

    fn visit(&self, each: &mut dyn FnMut(&'static Input, Given)) {
        if let Some(mut own) = *self {
            own.values(&mut |input, value| each(input, value.given()));
        }
    }

    fn update(&mut self, each: &mut dyn FnMut(&'static Input, Given) -> Given) {
        if let Some(own) = self {
            own.values(&mut |input, value| {
                let given = each(input, value.given());
                value.set(given);
            });
        }
    }

    fn idle(&self, _: &mut dyn FnMut(&'static Input, Given)) {}
}

/// The soil of a correlation, with the name of the correlation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::tower) enum CorrelatedSoil {
    Sand(&'static str),
    Clay(&'static str),
}
