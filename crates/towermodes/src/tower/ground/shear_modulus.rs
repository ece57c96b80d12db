//! The shear modulus of soil at small strains, G₀.

use super::layer::GroundLayer;
use super::pile::Pile;
use super::reaction::at;

/// Reference pressure of Hardin's formula and atmospheric pressure, Pa.
const REFERENCE_PA: f64 = 101.3e3;
/// Unit weight of water, for the total stress that a cone resistance is reduced by, N/m³.
const WATER_N_PER_M3: f64 = 1.0e4;
const KILO: f64 = 1e3;

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
    /// G₀ in Pa at a fraction of the way from the top to the bottom of a layer.
    ///
    /// | input | formula | source |
    /// |---|---|---|
    /// | Young's modulus | E/(2(1 + ν)) | |
    /// | wave velocity | ρ V_s² | |
    /// | cone, sand | 1634 q_c^0.25 σ′_v^0.375, all in kPa | Rix & Stokoe (1991) |
    /// | cone, clay | 2.78 q_c^1.335, in kPa | Mayne & Rix (1993) |
    /// | cone, any soil | V_s² = 10^(0.55 I_c + 1.68) (q_t − σ_v)/p_a | Robertson & Cabal (2015) |
    /// | void ratio | 875 p_ref/(0.3 + 0.7 e²) √(p′/p_ref), p_ref = 101.3 kPa | Hardin, PISA |
    /// | blow count | V_s = 97 N^0.314 | Imai & Tonouchi (1982) |
    ///
    /// Cone resistances belong to the stress before scour, in which they were measured; Hardin's
    /// formula has the mean stress p′ = σ′_v (1 + 2 K₀)/3 with scour. All scatter by a factor of
    /// about 2.
    pub(super) fn at(
        &self,
        layer: &GroundLayer,
        share: f64,
        pile: &Pile<'_>,
        height_m: f64,
    ) -> f64 {
        match *self {
            Self::Given { shear_modulus_pa } => at(shear_modulus_pa, share),
            Self::Youngs { youngs_modulus_pa } => {
                let poissons_ratio = layer.poissons_ratio.unwrap_or(f64::NAN);
                at(youngs_modulus_pa, share) / (2.0 * (1.0 + poissons_ratio))
            }
            Self::WaveVelocity {
                velocity_m_per_s,
                density_kg_per_m3,
            } => density_kg_per_m3 * at(velocity_m_per_s, share).powi(2),
            Self::RixStokoe { cone_resistance_pa } => {
                let cone = at(cone_resistance_pa, share) / KILO;
                let stress = pile.stress_before_scour_pa(height_m) / KILO;
                1634.0 * KILO * cone.powf(0.25) * stress.powf(0.375)
            }
            Self::MayneRix { cone_resistance_pa } => {
                2.78 * KILO * (at(cone_resistance_pa, share) / KILO).powf(1.335)
            }
            Self::RobertsonCabal {
                cone_resistance_pa,
                behaviour_index,
                density_kg_per_m3,
            } => {
                let net_pa = at(cone_resistance_pa, share) - total_stress_pa(pile, height_m);
                let factor = 10_f64.powf(0.55 * behaviour_index + 1.68);
                density_kg_per_m3 * factor * net_pa.max(0.0) / REFERENCE_PA
            }
            Self::Hardin {
                void_ratio,
                earth_pressure_at_rest,
            } => {
                let mean = (1.0 + 2.0 * earth_pressure_at_rest) / 3.0;
                let mean_pa = mean * pile.effective_stress_pa(height_m);
                let void = 0.3 + 0.7 * void_ratio * void_ratio;
                875.0 * REFERENCE_PA / void * (mean_pa / REFERENCE_PA).sqrt()
            }
            Self::BlowCount {
                blow_count,
                density_kg_per_m3,
            } => density_kg_per_m3 * (97.0 * at(blow_count, share).powf(0.314)).powi(2),
        }
    }

    /// Whether it is linear in height.
    pub(super) fn is_linear(&self) -> bool {
        matches!(self, Self::Given { .. } | Self::Youngs { .. }) || self.is_constant()
    }

    /// Whether it is the same at all heights of the layer.
    pub(super) fn is_constant(&self) -> bool {
        let pair = match self {
            Self::Given { shear_modulus_pa } => shear_modulus_pa,
            Self::Youngs { youngs_modulus_pa } => youngs_modulus_pa,
            Self::WaveVelocity {
                velocity_m_per_s, ..
            } => velocity_m_per_s,
            Self::MayneRix { cone_resistance_pa } => cone_resistance_pa,
            Self::BlowCount { blow_count, .. } => blow_count,
            Self::RixStokoe { .. } | Self::RobertsonCabal { .. } | Self::Hardin { .. } => {
                return false;
            }
        };
        pair[0] == pair[1]
    }

    /// Whether it depends on the weight of the soil above.
    pub(in crate::tower) fn needs_stress(&self) -> bool {
        matches!(
            self,
            Self::RixStokoe { .. } | Self::RobertsonCabal { .. } | Self::Hardin { .. }
        )
    }
}

/// Stress of soil and pore water before scour, Pa.
fn total_stress_pa(pile: &Pile<'_>, height_m: f64) -> f64 {
    let water_pa = match pile.ground.submerged {
        true => WATER_N_PER_M3 * (pile.ground.surface_m - height_m),
        false => 0.0,
    };
    pile.stress_before_scour_pa(height_m) + water_pa
}
