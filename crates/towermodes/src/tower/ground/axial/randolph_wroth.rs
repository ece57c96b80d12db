//! Randolph & Wroth (1978): from the shear modulus; torsion too.

use std::f64::consts::PI;

use crate::tower::ground::layer_springs::{AxialSprings, Nature};
use crate::tower::ground::modulus::Modulus;
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, Values};

/// Along the shaft 2π G/ln(2.5 L (1 − ν)/R), the logarithm at least 1 (not checked against the
/// original), for a modulus that is the same at all depths. Torsion 4π G R²: a rigid cylinder that
/// turns in an elastic space. Under the tip a rigid disc on a half-space, 4 G R/(1 − ν) and
/// 16 G R³/3.
#[derive(Debug)]
struct RandolphWroth {
    modulus: Modulus,
    poissons_ratio: f64,
}

pub(super) fn springs(values: &mut Values<'_>) -> Made<dyn AxialSprings> {
    Ok(Box::new(RandolphWroth {
        modulus: values.shear_modulus()?,
        poissons_ratio: values.poissons_ratio()?,
    }))
}

impl RandolphWroth {
    /// ln(2.5 L (1 − ν)/R), the logarithm of the radius of influence over that of the pile.
    fn zone(&self, spot: &Spot<'_>) -> f64 {
        let radius_m = 0.5 * spot.diameter_m();
        (2.5 * spot.pile.length_m() * (1.0 - self.poissons_ratio) / radius_m).ln()
    }
}

impl AxialSprings for RandolphWroth {
    fn along(&self, spot: &Spot<'_>) -> [f64; 2] {
        let (radius_m, zone) = (0.5 * spot.diameter_m(), self.zone(spot));
        let zone = if zone < 1.0 { 1.0 } else { zone };
        let modulus_pa = self.modulus.pa(spot);
        [
            2.0 * PI * modulus_pa / zone,
            4.0 * PI * modulus_pa * radius_m * radius_m,
        ]
    }

    fn at_tip(&self, spot: &Spot<'_>) -> [f64; 2] {
        let (radius_m, modulus_pa) = (0.5 * spot.diameter_m(), self.modulus.pa(spot));
        [
            4.0 * modulus_pa * radius_m / (1.0 - self.poissons_ratio),
            16.0 * modulus_pa * radius_m.powi(3) / 3.0,
        ]
    }

    fn nature(&self) -> Nature {
        Nature {
            is_linear: false,
            needs_weight: false,
            depends_on_edition: false,
        }
    }

    fn kink(&self, spot: &Spot<'_>) -> Option<f64> {
        Some(self.zone(spot) - 1.0)
    }
}
