//! API: sand with a stiffness proportional to the depth, and clay with the curve of Matlock.

use super::clay::{self, Matlock};
use super::sand::Subgrade;
use crate::tower::ground::layer::LayerSoil;
use crate::tower::ground::layer_springs::{LayerSprings, Nature};
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, Values};
use crate::tower::warning::{Site, Warning};

pub(super) fn springs<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    match &values.layer.soil {
        LayerSoil::Sand(_) => of_sand(values),
        _ => Ok(Box::new(SoftClay(Matlock::of(values)?))),
    }
}

/// The springs of sand; DNV has the same.
pub(super) fn of_sand<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    Ok(Box::new(ApiSand(Subgrade::of(values)?)))
}

/// k z, N/m²: the initial stiffness of the curve.
#[derive(Debug)]
struct ApiSand(Subgrade);

impl LayerSprings for ApiSand {
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64 {
        self.0.modulus_n_per_m3 * spot.overburden_depth_m()
    }

    fn nature(&self) -> Nature {
        Nature {
            is_linear: true,
            needs_weight: false,
            depends_on_edition: self.0.depends_on_edition(),
        }
    }

    fn doubt(&self, at: &dyn Fn(&'static str) -> Site, warnings: &mut Vec<Warning>) {
        self.0.doubt(at, warnings);
    }
}

/// The secant of Matlock's curve p = 0.5 p_u (y/y₅₀)^⅓, y₅₀ = 2.5 ε₅₀ D, to its first point in API,
/// p = 0.23 p_u at y = 0.1 y₅₀: 2.3 p_u/y₅₀, N/m². The curve itself begins vertically.
#[derive(Debug)]
struct SoftClay(Matlock);

impl LayerSprings for SoftClay {
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64 {
        let strength_n_per_m = self.0.resistance(spot).least();
        2.3 * strength_n_per_m / (2.5 * self.0.clay.strain_50 * spot.diameter_m())
    }

    fn nature(&self) -> Nature {
        clay::NATURE
    }

    fn kink(&self, number: usize, spot: &Spot<'_>) -> Option<f64> {
        self.0.resistance(spot).kink(number)
    }
}
