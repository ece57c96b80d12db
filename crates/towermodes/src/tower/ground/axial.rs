//! Springs along and about the axis of a pile.

use std::f64::consts::PI;

use super::description::{ApiEdition, AxialModel};
use super::layer::{GroundLayer, LayerSoil};
use super::pile::Pile;
use super::reaction::{at, shear_modulus_pa};

/// Zone of influence of Kraft et al., in radii of the pile.
const ZONE_RADII: f64 = 10.0;

/// Springs per length of the shaft against z (N/m²) and against torsion (N).
///
/// - API: the secant to the first point of the t-z curve, 0.3 t_max at 0.0016 D; for sand in RP 2A
///   t_max at 2.54 mm (0.1 in).
/// - Kraft, Ray & Kagawa (1981): 2 G₀/(D ln z_if) per area with the zone of influence z_if = 10
///   radii.
/// - Randolph & Wroth (1978): 2π G/ln(2.5 L (1 − ν)/R), the logarithm at least 1 (not checked
///   against the original), for a modulus that is the same at all depths. Torsion 4π G R²: a rigid
///   cylinder that turns in an elastic space.
pub(super) fn axial(pile: &Pile<'_>, index: usize, height_m: f64) -> [f64; 2] {
    let (layer, share) = pile.layer(index, height_m);
    let diameter_m = pile.diameter_m(height_m);
    let modulus_pa = || shear_modulus_pa(pile, index, height_m);
    match pile.ground.axial {
        None => [0.0; 2],
        Some(AxialModel::Api) => {
            let friction_pa = layer
                .shaft_friction_pa
                .map_or(f64::NAN, |pair| at(pair, share));
            let first_m = 0.0016 * diameter_m / 0.3;
            let displacement_m = match &layer.soil {
                LayerSoil::Sand(_) => match pile.ground.edition {
                    ApiEdition::Rp2Geo => first_m,
                    ApiEdition::Rp2A => 0.00254,
                },
                LayerSoil::Clay(_) => first_m,
                LayerSoil::Elastic | LayerSoil::Rock(_) | LayerSoil::Table(_) => f64::NAN,
            };
            [PI * diameter_m * friction_pa / displacement_m, 0.0]
        }
        Some(AxialModel::Kraft) => [2.0 * PI * modulus_pa() / ZONE_RADII.ln(), 0.0],
        Some(AxialModel::RandolphWroth) => {
            let radius_m = 0.5 * diameter_m;
            let zone = randolph_wroth_zone(layer, pile.length_m(), radius_m);
            let zone = if zone < 1.0 { 1.0 } else { zone };
            let modulus_pa = modulus_pa();
            [
                2.0 * PI * modulus_pa / zone,
                4.0 * PI * modulus_pa * radius_m * radius_m,
            ]
        }
    }
}

/// ln(2.5 L (1 − ν)/R), the logarithm of the radius of influence over that of the pile.
pub(super) fn randolph_wroth_zone(layer: &GroundLayer, length_m: f64, radius_m: f64) -> f64 {
    let poissons_ratio = layer.poissons_ratio.unwrap_or(f64::NAN);
    (2.5 * length_m * (1.0 - poissons_ratio) / radius_m).ln()
}

/// Springs under the tip against z (N/m) and against torsion (N m).
///
/// - API: the secant to the first point of the Q-z curve, 0.25 q A at 0.002 D, with the area of the
///   whole section A = π D²/4 (a plugged pile); zero without an end bearing q.
/// - Randolph & Wroth: a rigid disc on a half-space, 4 G R/(1 − ν) and 16 G R³/3.
/// - Kraft gives none.
pub(super) fn axial_at_tip(pile: &Pile<'_>, index: usize) -> [f64; 2] {
    let (layer, _) = pile.layer(index, pile.tip_m);
    let diameter_m = pile.diameter_m(pile.tip_m);
    match pile.ground.axial {
        None | Some(AxialModel::Kraft) => [0.0; 2],
        Some(AxialModel::Api) => {
            let force_n = layer.end_bearing_pa.unwrap_or(0.0) * 0.25 * PI * diameter_m * diameter_m;
            [0.25 * force_n / (0.002 * diameter_m), 0.0]
        }
        Some(AxialModel::RandolphWroth) => {
            let modulus_pa = shear_modulus_pa(pile, index, pile.tip_m);
            let poissons_ratio = layer.poissons_ratio.unwrap_or(f64::NAN);
            let radius_m = 0.5 * diameter_m;
            [
                4.0 * modulus_pa * radius_m / (1.0 - poissons_ratio),
                16.0 * modulus_pa * radius_m.powi(3) / 3.0,
            ]
        }
    }
}
