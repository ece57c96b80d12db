//! Kallehave et al.: sand and piles of large diameter.

use super::sand::Subgrade;
use crate::tower::ground::layer_springs::{LayerSprings, Nature};
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, Values};
use crate::tower::warning::{Site, Warning};

/// Reference depth and diameter, m.
const REFERENCE_DEPTH_M: f64 = 2.5;
const REFERENCE_DIAMETER_M: f64 = 0.61;
/// Exponent of the depth.
const EXPONENT: f64 = 0.6;

/// k z₀ (z/z₀)^0.6 (D/D₀)^0.5 with z₀ = 2.5 m, D₀ = 0.61 m, N/m².
///
/// It corrects API's stiffness for wide piles, for which that is too soft near the surface and too
/// stiff at depth. The exponent fitted to single sites was 0.4 to 0.7.
///
/// Source: Kallehave, Le Blanc Thilsted & Liingaard, *Modification of the API p-y formulation of
/// initial stiffness of sand*, OSIG 2012, as quoted by Beuckelaers (2013).
#[derive(Debug)]
struct Kallehave(Subgrade);

pub(super) fn springs<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    Ok(Box::new(Kallehave(Subgrade::of(values)?)))
}

impl LayerSprings for Kallehave {
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64 {
        let depth_m = spot.overburden_depth_m();
        let depth = (depth_m / REFERENCE_DEPTH_M).max(0.0).powf(EXPONENT);
        let wide = (spot.diameter_m() / REFERENCE_DIAMETER_M).sqrt();
        self.0.modulus_n_per_m3 * REFERENCE_DEPTH_M * depth * wide
    }

    fn nature(&self) -> Nature {
        Nature {
            is_linear: false,
            needs_weight: false,
            depends_on_edition: self.0.depends_on_edition(),
        }
    }

    fn doubt(&self, at: &dyn Fn(&'static str) -> Site, warnings: &mut Vec<Warning>) {
        self.0.doubt(at, warnings);
    }
}
