//! Reese: weak rock.

use crate::tower::ground::layer::LayerSoil;
use crate::tower::ground::layer_springs::{LayerSprings, Nature};
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, NoSprings, Values};

/// The stiffness grows to this depth in diameters below the surface of the rock.
const GROWS_DIAMETERS: f64 = 3.0;

/// k_ir E_ir, N/m², with k_ir = 100 + 400 x_r/(3 D) to a depth x_r = 3 D below the surface of the
/// rock, and 500 below. For rock with a compressive strength of 0.5 to 5 MPa.
///
/// Source: Reese, *Analysis of laterally loaded piles in weak rock*, J. Geotech. Geoenviron. Eng.
/// 123 (1997) 1010–1017.
#[derive(Debug)]
struct WeakRock {
    youngs_modulus_pa: [f64; 2],
}

pub(super) fn springs<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    let LayerSoil::Rock(rock) = &values.layer.soil else {
        return Err(NoSprings::OtherSoil);
    };
    let (given, value) = (rock.youngs_modulus_pa, "Young's modulus of the rock");
    let youngs_modulus_pa = values.needed("youngs_modulus", value, given)?;
    Ok(Box::new(WeakRock { youngs_modulus_pa }))
}

impl LayerSprings for WeakRock {
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64 {
        let share =
            (spot.depth_in_rock_m() / (GROWS_DIAMETERS * spot.diameter_m())).clamp(0.0, 1.0);
        (100.0 + 400.0 * share) * spot.between(self.youngs_modulus_pa)
    }

    fn nature(&self) -> Nature {
        Nature {
            is_linear: false,
            needs_weight: false,
            depends_on_edition: false,
        }
    }

    fn kink(&self, number: usize, spot: &Spot<'_>) -> Option<f64> {
        (number == 0).then(|| spot.depth_in_rock_m() - GROWS_DIAMETERS * spot.diameter_m())
    }
}
