//! What the shear modulus of soil at small strains, G₀, follows from.

/// What the shear modulus G₀ of a layer at small strains follows from. Values with two entries are
/// at the top and at the bottom of the layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShearModulus {
    /// Itself.
    Given {
        /// G₀, Pa.
        shear_modulus_pa: [f64; 2],
    },
    /// Young's modulus: G₀ = E/(2(1 + ν)) with Poisson's ratio of the layer.
    Youngs {
        /// E, Pa.
        youngs_modulus_pa: [f64; 2],
    },
    /// The measured velocity of shear waves: G₀ = ρ V_s².
    WaveVelocity {
        /// V_s, m/s.
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
    pub(in crate::tower) fn key(&self) -> &'static str {
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

/// The soil of a correlation, with the name of the correlation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::tower) enum CorrelatedSoil {
    Sand(&'static str),
    Clay(&'static str),
}
