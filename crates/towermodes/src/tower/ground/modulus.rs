//! The shear modulus of soil at small strains, G₀, at a point.

use super::layer::GroundLayer;
use super::pile::Pile;
use super::shear_modulus::ShearModulus;
use super::spot::Spot;
use crate::tower::description::TowerDescription;

/// Reference pressure of Hardin's formula, Pa.
const REFERENCE_PA: f64 = 101.3e3;
/// The pressure p_a of Robertson & Cabal, Pa.
const ROBERTSON_PA: f64 = 100e3;
/// Unit weight of water, to compute the total stress subtracted from a cone resistance, N/m³.
const WATER_N_PER_M3: f64 = 1.0e4;
const KILO: f64 = 1e3;

/// The shear modulus of a layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Modulus {
    source: ShearModulus,
    /// Poisson's ratio, if the source is Young's modulus.
    poissons_ratio: Option<f64>,
}

impl Modulus {
    /// A modulus from this source; Young's modulus also needs Poisson's ratio.
    pub(super) fn new(source: ShearModulus, poissons_ratio: Option<f64>) -> Self {
        Self {
            source,
            poissons_ratio,
        }
    }

    /// Whether it is linear in height between any values at top and bottom.
    pub(super) fn is_linear(&self) -> bool {
        self.source.is_linear()
    }

    /// G₀ at a point, Pa.
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
    pub(super) fn pa(&self, spot: &Spot<'_>) -> f64 {
        let of_source_pa = of_source_pa(&self.source, spot);
        match self.poissons_ratio {
            Some(ratio) => of_source_pa / (2.0 * (1.0 + ratio)),
            None => of_source_pa,
        }
    }
}

/// G₀ at a point, Pa; if Young's modulus is given, that modulus.
fn of_source_pa(source: &ShearModulus, spot: &Spot<'_>) -> f64 {
    let (pile, height_m) = (spot.pile, spot.height_m);
    match *source {
        ShearModulus::Given {
            shear_modulus_pa: pa,
        }
        | ShearModulus::Youngs {
            youngs_modulus_pa: pa,
        } => spot.between(pa),
        ShearModulus::WaveVelocity {
            velocity_m_per_s,
            density_kg_per_m3,
        } => density_kg_per_m3 * spot.between(velocity_m_per_s).powi(2),
        ShearModulus::RixStokoe { cone_resistance_pa } => {
            let cone = spot.between(cone_resistance_pa) / KILO;
            let stress = pile.stress_before_scour_pa(height_m) / KILO;
            1634.0 * KILO * cone.powf(0.25) * stress.powf(0.375)
        }
        ShearModulus::MayneRix { cone_resistance_pa } => {
            2.78 * KILO * (spot.between(cone_resistance_pa) / KILO).powf(1.335)
        }
        ShearModulus::RobertsonCabal {
            cone_resistance_pa,
            behaviour_index,
            density_kg_per_m3,
        } => {
            let net_pa = spot.between(cone_resistance_pa) - total_stress_pa(pile, height_m);
            let factor = 10_f64.powf(0.55 * behaviour_index + 1.68);
            density_kg_per_m3 * factor * net_pa / ROBERTSON_PA
        }
        ShearModulus::Hardin {
            void_ratio,
            earth_pressure_at_rest,
        } => {
            let mean = (1.0 + 2.0 * earth_pressure_at_rest) / 3.0;
            let mean_pa = mean * pile.effective_stress_pa(height_m);
            let void = 0.3 + 0.7 * void_ratio * void_ratio;
            875.0 * REFERENCE_PA / void * (mean_pa / REFERENCE_PA).sqrt()
        }
        ShearModulus::BlowCount {
            blow_count,
            density_kg_per_m3,
        } => density_kg_per_m3 * (97.0 * spot.between(blow_count).powf(0.314)).powi(2),
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

/// A cone resistance q_t at an end of a layer that is smaller than the total stress at this height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::tower) struct ConeBelowStress {
    pub(in crate::tower) layer: usize,
    pub(in crate::tower) height_m: f64,
    pub(in crate::tower) cone_pa: f64,
    pub(in crate::tower) stress_pa: f64,
}

/// The first cone resistance for Robertson & Cabal that is smaller than the stress of soil and
/// water; both are linear in a layer.
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
