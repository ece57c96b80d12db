//! Vesić: springs of an elastic half-space, by Young's modulus of the soil and the pile.

use super::winkler::Elastic;
use crate::tower::ground::layer_springs::{LayerSprings, Nature};
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, Values};

/// 0.65 (E D⁴/(E_p I))^(1/12) E/(1 − ν²), N/m², with the bending stiffness E_p I of the pile.
///
/// Derived for long beams on the surface of an elastic half-space, so the springs are softer than
/// those of a pile inside the half-space.
///
/// Source: Vesić, *Bending of beams resting on isotropic elastic solid*, J. Eng. Mech. Div. ASCE 87
/// (1961).
#[derive(Debug)]
struct Vesic(Elastic);

pub(super) fn springs<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    Ok(Box::new(Vesic(Elastic::of(values)?)))
}

impl LayerSprings for Vesic {
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64 {
        let (youngs_modulus_pa, nu) = (self.0.youngs_modulus_pa(spot), self.0.poissons_ratio);
        let ratio = youngs_modulus_pa * spot.diameter_m().powi(4) / spot.bending_n_m2();
        let plane_strain = 1.0 - nu * nu;
        0.65 * ratio.powf(1.0 / 12.0) * youngs_modulus_pa / plane_strain
    }

    fn nature(&self) -> Nature {
        Nature {
            is_linear: false,
            needs_weight: false,
            depends_on_edition: false,
        }
    }
}
