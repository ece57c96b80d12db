//! API: secants to the first points of the t-z curves of clay and sand, and of the Q-z curve.

use std::f64::consts::PI;

use crate::tower::ground::description::ApiEdition;
use crate::tower::ground::layer::LayerSoil;
use crate::tower::ground::layer_springs::{AxialSprings, Nature};
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, NoSprings, Values};

/// The secants to the first points of the curves.
///
/// Along the shaft that is 0.3 t_max at 0.0016 D; for sand in RP 2A t_max at 2.54 mm (0.1 in).
/// Under the tip 0.25 q A at 0.002 D, with the area of the whole section A = π D²/4 (a plugged
/// pile); zero without an end bearing q.
#[derive(Debug)]
struct Api {
    /// Largest friction t_max at the top and at the bottom of the layer, Pa.
    friction_pa: [f64; 2],
    /// Largest pressure q, Pa.
    bearing_pa: Option<f64>,
    /// Whether the soil is sand, whose curve depends on the edition.
    is_sand: bool,
    edition: ApiEdition,
}

pub(super) fn springs(values: &mut Values<'_>) -> Made<dyn AxialSprings> {
    let is_sand = match &values.layer.soil {
        LayerSoil::Sand(_) => true,
        LayerSoil::Clay(_) => false,
        LayerSoil::Elastic | LayerSoil::Rock(_) | LayerSoil::Table(_) => {
            return Err(NoSprings::OtherSoil);
        }
    };
    let (friction, bearing) = (values.layer.shaft_friction_pa, values.layer.end_bearing_pa);
    Ok(Box::new(Api {
        friction_pa: values.needed("shaft_friction", "the shaft friction", friction)?,
        bearing_pa: values.optional("end_bearing", bearing),
        is_sand,
        edition: values.ground.edition,
    }))
}

impl AxialSprings for Api {
    fn along(&self, spot: &Spot<'_>) -> [f64; 2] {
        let diameter_m = spot.diameter_m();
        let displacement_m = match (self.edition, self.is_sand) {
            (ApiEdition::Rp2A, true) => 0.00254,
            (ApiEdition::Rp2A, false) | (ApiEdition::Rp2Geo, _) => 0.0016 * diameter_m / 0.3,
        };
        let friction_pa = spot.between(self.friction_pa);
        [PI * diameter_m * friction_pa / displacement_m, 0.0]
    }

    fn at_tip(&self, spot: &Spot<'_>) -> [f64; 2] {
        let diameter_m = spot.diameter_m();
        let force_n = self.bearing_pa.unwrap_or(0.0) * 0.25 * PI * diameter_m * diameter_m;
        [0.25 * force_n / (0.002 * diameter_m), 0.0]
    }

    fn nature(&self) -> Nature {
        Nature {
            is_linear: self.edition == ApiEdition::Rp2Geo || !self.is_sand,
            needs_weight: false,
            depends_on_edition: self.is_sand,
        }
    }
}
