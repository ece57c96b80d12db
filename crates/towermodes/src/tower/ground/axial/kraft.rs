//! Kraft, Ray & Kagawa (1981): from the shear modulus.

use std::f64::consts::PI;

use crate::tower::ground::layer_springs::{AxialSprings, Nature};
use crate::tower::ground::modulus::Modulus;
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, Values};

/// Zone of influence, in radii of the pile.
const ZONE_RADII: f64 = 10.0;

/// 2 G₀/(D ln z_if) per area of the shaft with the zone of influence z_if = 10 radii; none under
/// the tip.
#[derive(Debug)]
struct Kraft(Modulus);

pub(super) fn springs(values: &mut Values<'_>) -> Made<dyn AxialSprings> {
    Ok(Box::new(Kraft(values.shear_modulus()?)))
}

impl AxialSprings for Kraft {
    fn along(&self, spot: &Spot<'_>) -> [f64; 2] {
        [2.0 * PI * self.0.pa(spot) / ZONE_RADII.ln(), 0.0]
    }

    fn at_tip(&self, _: &Spot<'_>) -> [f64; 2] {
        [0.0; 2]
    }

    fn nature(&self) -> Nature {
        Nature {
            is_linear: self.0.is_linear(),
            needs_weight: false,
            depends_on_edition: false,
        }
    }
}
