//! The shear modulus of soil at small strains, G₀.

use super::layer::GroundLayer;
use super::pile::Pile;
use super::reaction::at;
use crate::tower::description::TowerDescription;

/// Reference pressure of Hardin's formula, Pa.
const REFERENCE_PA: f64 = 101.3e3;
/// The pressure p_a of Robertson & Cabal, Pa.
const ROBERTSON_PA: f64 = 100e3;
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
    /// | cone, any soil | V_s² = 10^(0.55 I_c + 1.68) (q_t − σ_v)/100 kPa | Robertson (2015) |
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
                density_kg_per_m3 * factor * net_pa / ROBERTSON_PA
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

/// Stress of soil and pore water before scour, Pa.
fn total_stress_pa(pile: &Pile<'_>, height_m: f64) -> f64 {
    let water_pa = match pile.ground.submerged {
        true => WATER_N_PER_M3 * (pile.ground.surface_m - height_m),
        false => 0.0,
    };
    pile.stress_before_scour_pa(height_m) + water_pa
}

/// A cone resistance q_t at an end of a layer that is smaller than the stress there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::tower) struct ConeBelowStress {
    pub(in crate::tower) layer: usize,
    pub(in crate::tower) height_m: f64,
    pub(in crate::tower) cone_pa: f64,
    pub(in crate::tower) stress_pa: f64,
}

/// The first cone resistance of Robertson & Cabal that the stress of soil and water exceeds; both
/// are linear in a layer.
pub(in crate::tower) fn cone_below_stress(
    description: &TowerDescription,
) -> Option<ConeBelowStress> {
    let pile = Pile::of(description)?;
    let of_layer = |(index, layer): (usize, &GroundLayer)| {
        let Some(ShearModulus::RobertsonCabal {
            cone_resistance_pa, ..
        }) = layer.shear_modulus
        else {
            return None;
        };
        let ends_m = [layer.top_m, layer.bottom_m];
        let ends = ends_m.into_iter().zip(cone_resistance_pa);
        let mut ends = ends.map(|(height_m, cone_pa)| ConeBelowStress {
            layer: index,
            height_m,
            cone_pa,
            stress_pa: total_stress_pa(&pile, height_m),
        });
        ends.find(|end| end.cone_pa < end.stress_pa)
    };
    pile.ground.layers.iter().enumerate().find_map(of_layer)
}
