//! Reese et al.: stiff clay.

use super::clay::{self, Resistance, Undrained};
use crate::tower::ground::layer_springs::{LayerSprings, Nature};
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, Values};
use crate::tower::warning::{Ineffective, Site, Warning};

/// The secant 5 p_u √0.1/y_c, y_c = ε₅₀ D, N/m², of the curve p = 0.5 p_u (y/y_c)^½ for stiff clay
/// at 0.1 y_c.
///
/// The straight line k_s z y with which the curve of Reese begins is not used: it does not depend
/// on the diameter, and at some depth it is much stiffer than elastic soil.
///
/// Source: Reese, Cox & Koop, OTC 2312 (1975), with the secant that COSPIN takes.
#[derive(Debug)]
struct StiffClay {
    clay: Undrained,
    /// Whether Matlock's factor J is given, although it has no effect.
    has_factor: bool,
}

pub(super) fn springs<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    let clay = Undrained::of(values)?;
    let factor = values.clay()?.strength_factor;
    let has_factor = values.optional("strength_factor", factor).is_some();
    Ok(Box::new(StiffClay { clay, has_factor }))
}

impl StiffClay {
    /// p_u = min((2 c_a + σ′_v) D + 2.83 c_a z, 11 S_u D), with the mean strength c_a of the clay
    /// above.
    ///
    /// Source: Reese, Cox & Koop, *Field testing and analysis of laterally loaded piles in stiff
    /// clay*, OTC 2312 (1975), as in COSPIN.
    fn resistance(&self, spot: &Spot<'_>) -> Resistance {
        let (strength_pa, diameter_m) = (spot.between(self.clay.strength_pa), spot.diameter_m());
        let mean_strength_pa = spot.mean_strength_pa();
        Resistance {
            shallow: (2.0 * mean_strength_pa + spot.effective_stress_pa()) * diameter_m
                + 2.83 * mean_strength_pa * spot.depth_m(),
            deep: 11.0 * strength_pa * diameter_m,
        }
    }
}

impl LayerSprings for StiffClay {
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64 {
        let strength_n_per_m = self.resistance(spot).least();
        5.0 * strength_n_per_m * 0.1_f64.sqrt() / (self.clay.strain_50 * spot.diameter_m())
    }

    fn nature(&self) -> Nature {
        clay::NATURE
    }

    fn kink(&self, number: usize, spot: &Spot<'_>) -> Option<f64> {
        self.resistance(spot).kink(number)
    }

    fn doubt(&self, at: &dyn Fn(&'static str) -> Site, warnings: &mut Vec<Warning>) {
        if self.has_factor {
            let (site, what) = (at("strength_factor"), Ineffective::FactorOfMatlock);
            warnings.push(Warning::NoEffect { site, what });
        }
    }
}
