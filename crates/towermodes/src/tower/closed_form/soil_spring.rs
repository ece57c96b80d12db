//! The springs along a pile: given, or from the modulus of the soil.

use super::pile_tube::PileTube;

/// The spring k_D of the soil at the depth of one diameter, per metre of pile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SoilSpring {
    /// Given.
    Given {
        /// k_D, N/m².
        spring_n_per_m2: f64,
    },
    /// 1.2 E. Source: Gazetas.
    Gazetas {
        /// Young's modulus E of the soil at the depth of one diameter, Pa.
        youngs_modulus_pa: f64,
    },
    /// 0.65 (E D⁴/EI)^(1/12) E/(1 − ν²). Source: Vesić (1961). Its constants are not checked
    /// against the original.
    Vesic {
        /// Young's modulus E of the soil at the depth of one diameter, Pa.
        youngs_modulus_pa: f64,
        /// Poisson's ratio ν of the soil.
        poissons_ratio: f64,
    },
}

impl SoilSpring {
    /// k_D, N/m².
    pub fn of(&self, tube: &PileTube) -> f64 {
        match *self {
            Self::Given { spring_n_per_m2 } => spring_n_per_m2,
            Self::Gazetas { youngs_modulus_pa } => 1.2 * youngs_modulus_pa,
            Self::Vesic {
                youngs_modulus_pa,
                poissons_ratio,
            } => {
                let stiffness = youngs_modulus_pa * tube.diameter_m.powi(4) / tube.bending_n_m2();
                0.65 * stiffness.powf(1.0 / 12.0) * youngs_modulus_pa
                    / (1.0 - poissons_ratio * poissons_ratio)
            }
        }
    }

    /// The exponent of the depth in the spring, where the exponent of the tower file is `exponent`:
    /// that of the springs if they are given, otherwise that of Young's modulus.
    pub fn exponent(&self, exponent: f64) -> f64 {
        match self {
            Self::Given { .. } | Self::Gazetas { .. } => exponent,
            // The spring grows with E^(13/12).
            Self::Vesic { .. } => 13.0 / 12.0 * exponent,
        }
    }

    /// In soil that is `factor` times as stiff.
    pub(in crate::tower) fn times(mut self, factor: f64) -> Self {
        match &mut self {
            Self::Given { spring_n_per_m2 } => *spring_n_per_m2 *= factor,
            Self::Gazetas { youngs_modulus_pa }
            | Self::Vesic {
                youngs_modulus_pa, ..
            } => *youngs_modulus_pa *= factor,
        }
        self
    }

    /// Authors of the formula, if the spring is not given.
    pub fn formula_name(&self) -> Option<&'static str> {
        match self {
            Self::Given { .. } => None,
            Self::Gazetas { .. } => Some("Gazetas"),
            Self::Vesic { .. } => Some("Vesić (1961)"),
        }
    }
}
