//! Springs proportional to Young's modulus of the soil.

use crate::tower::ground::layer_springs::{LayerSprings, Nature};
use crate::tower::ground::modulus::Modulus;
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, NoSprings, Values};

/// The elastic constants of a layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Elastic {
    /// The shear modulus at small strains.
    pub(super) modulus: Modulus,
    /// Poisson's ratio ν.
    pub(super) poissons_ratio: f64,
}

impl Elastic {
    /// From the values of a layer.
    pub(super) fn of(values: &mut Values<'_>) -> Result<Self, NoSprings> {
        if !values.is_soil() {
            return Err(NoSprings::OtherSoil);
        }
        Ok(Self {
            modulus: values.shear_modulus()?,
            poissons_ratio: values.poissons_ratio()?,
        })
    }

    /// Young's modulus E = 2 (1 + ν) G, Pa.
    pub(super) fn youngs_modulus_pa(&self, spot: &Spot<'_>) -> f64 {
        2.0 * (1.0 + self.poissons_ratio) * self.modulus.pa(spot)
    }
}

/// 1.2 E, N/m².
///
/// Source: Gazetas (1991), not checked against the original.
#[derive(Debug)]
struct Winkler(Elastic);

pub(super) fn springs<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    Ok(Box::new(Winkler(Elastic::of(values)?)))
}

impl LayerSprings for Winkler {
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64 {
        1.2 * self.0.youngs_modulus_pa(spot)
    }

    fn nature(&self) -> Nature {
        Nature {
            is_linear: self.0.modulus.is_linear(),
            needs_weight: false,
            depends_on_edition: false,
        }
    }
}
