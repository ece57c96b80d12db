//! DNV: sand as in API, and clay with an initial stiffness.

use super::api;
use super::clay::{self, Matlock};
use crate::tower::ground::layer::LayerSoil;
use crate::tower::ground::layer_springs::{LayerSprings, Nature};
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, Values};

pub(super) fn springs<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    if let LayerSoil::Sand(_) = &values.layer.soil {
        return api::of_sand(values);
    }
    let matlock = Matlock::of(values)?;
    let value = "the factor of the initial stiffness (10 for normally consolidated, 30 for overconsolidated clay)";
    let given = values.clay()?.stiffness_factor;
    let factor = values.needed("stiffness_factor", value, given)?;
    Ok(Box::new(DnvClay { matlock, factor }))
}

/// Initial stiffness ξ p_u/(D ε₅₀^0.25), N/m²: ξ = 10 for normally consolidated clay, 30 for
/// overconsolidated clay. With ξ = 10 it is a third to a fifth of the secant of API.
///
/// Source: DNV-OS-J101, as programmed in COSPIN.
#[derive(Debug)]
struct DnvClay {
    matlock: Matlock,
    /// ξ.
    factor: f64,
}

impl LayerSprings for DnvClay {
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64 {
        let strength_n_per_m = self.matlock.resistance(spot).least();
        let strain = self.matlock.clay.strain_50.powf(0.25);
        self.factor * strength_n_per_m / (spot.diameter_m() * strain)
    }

    fn nature(&self) -> Nature {
        clay::NATURE
    }

    fn kink(&self, number: usize, spot: &Spot<'_>) -> Option<f64> {
        self.matlock.resistance(spot).kink(number)
    }
}
