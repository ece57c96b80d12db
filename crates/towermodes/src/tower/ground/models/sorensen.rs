//! Sørensen et al.: sand and piles of large diameter.

use crate::tower::ground::layer_springs::{LayerSprings, Nature};
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, Values};

/// Exponent of the depth.
const EXPONENT: f64 = 0.6;

/// 50 MPa (z/1 m)^0.6 (D/1 m)^0.5 φ′^3.6 with φ′ in radians, N/m².
///
/// Much softer than Kallehave: about six times, as Beuckelaers found.
///
/// Source: Sørensen, Ibsen & Augustesen, *Effects of diameter on initial stiffness of p-y curves
/// for large-diameter piles in sand*, NUMGE 2010, as quoted by Beuckelaers (2013).
#[derive(Debug)]
struct Sorensen {
    friction_angle_deg: f64,
}

pub(super) fn springs<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    let given = values.sand()?.friction_angle_deg;
    let friction_angle_deg = values.needed("friction_angle", "the friction angle", given)?;
    Ok(Box::new(Sorensen { friction_angle_deg }))
}

impl LayerSprings for Sorensen {
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64 {
        let depth = spot.overburden_depth_m().max(0.0).powf(EXPONENT);
        let angle = self.friction_angle_deg.to_radians();
        50e6 * depth * spot.diameter_m().sqrt() * angle.powf(3.6)
    }

    fn nature(&self) -> Nature {
        Nature {
            is_linear: false,
            needs_weight: false,
            depends_on_edition: false,
        }
    }
}
