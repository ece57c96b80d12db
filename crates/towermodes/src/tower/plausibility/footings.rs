//! Footings by closed form: units, and the range of the formulas.

use super::closed_form::outside;
use super::usual::Usual;
use crate::tower::closed_form::{CircularFooting, RectangularFooting};
use crate::tower::foundation::HalfSpace;
use crate::tower::{Place, Quantity, Site, Tower, Warning};

const SOIL_MODULUS: Usual = Usual::new(Quantity::SoilShearModulus, 1e6, 5e10);
const EMBEDMENT: Usual = Usual::new(Quantity::Embedment, 0.0, 2.0);
const FOOTING: Usual = Usual::new(Quantity::FootingRadius, 1.0, 20.0);
const SIDE: Usual = Usual::new(Quantity::FootingSide, 1.0, 20.0);
/// A rectangular footing deeper than this, as a fraction of half its shorter side, is no footing.
const MOST_EMBEDMENT: f64 = 2.0;

fn at(key: &'static str) -> Site {
    Site::at(Place::Foundation { key })
}

fn against_tower(
    tower: &Tower,
    usual: &Usual,
    half_width_m: f64,
    site: Site,
    warnings: &mut Vec<Warning>,
) {
    if let Some(station) = tower.stations().first() {
        usual.check(
            half_width_m / (0.5 * station.outer_diameter_m),
            site,
            warnings,
        );
    }
}

pub(super) fn half_space(tower: &Tower, footing: &HalfSpace, warnings: &mut Vec<Warning>) {
    let modulus = footing.shear_modulus_pa;
    SOIL_MODULUS.check(modulus, at("soil_shear_modulus"), warnings);
    let depth = footing.embedment_m / footing.radius_m;
    EMBEDMENT.check(depth, at("embedment"), warnings);
    against_tower(tower, &FOOTING, footing.radius_m, at("radius"), warnings);
}

pub(super) fn circular(tower: &Tower, footing: &CircularFooting, warnings: &mut Vec<Warning>) {
    let modulus = footing.shear_modulus_pa;
    SOIL_MODULUS.check(modulus, at("soil_shear_modulus"), warnings);
    against_tower(tower, &FOOTING, footing.radius_m, at("radius"), warnings);
    if footing.is_over_stratum() {
        let modulus = footing.lower_shear_modulus_pa;
        SOIL_MODULUS.check(modulus, at("lower_shear_modulus"), warnings);
    }
    strata(footing, warnings);
    embedment(footing, warnings);
}

/// Thin strata, and strata on softer ones.
fn strata(footing: &CircularFooting, warnings: &mut Vec<Warning>) {
    let least = match footing.is_over_stratum() {
        true => CircularFooting::LEAST_DEPTH_OVER_STRATUM,
        false => CircularFooting::LEAST_DEPTH_OVER_ROCK,
    };
    warnings.extend(outside(
        at("soil_thickness"),
        CircularFooting::FORMULA,
        "the thickness of the stratum, divided by the radius of the footing,",
        footing.stratum_thickness_m / footing.radius_m,
        [least, f64::INFINITY],
        "a thin stratum needs a model of the layers, such as finite elements",
    ));
    warnings.extend(outside(
        at("lower_shear_modulus"),
        CircularFooting::FORMULA,
        "the shear modulus of the stratum, divided by that below it,",
        footing.shear_modulus_pa / footing.lower_shear_modulus_pa,
        [f64::NEG_INFINITY, 1.0],
        "a stratum on softer soil needs a model of the layers, such as finite elements",
    ));
}

fn embedment(footing: &CircularFooting, warnings: &mut Vec<Warning>) {
    let [by_radius, by_depth] = [footing.radius_m, footing.stratum_thickness_m]
        .map(|length_m| footing.embedment_m / length_m);
    let remedy = "check the unit (m), or use type = \"suction-caisson\" or a pile";
    let limits = [
        (
            "the embedment of the footing, divided by its radius,",
            by_radius,
            CircularFooting::MOST_EMBEDMENT,
        ),
        (
            "the embedment of the footing, divided by the thickness of the stratum,",
            by_depth,
            CircularFooting::MOST_EMBEDMENT_IN_STRATUM,
        ),
    ];
    warnings.extend(limits.into_iter().find_map(|(quantity, value, most)| {
        outside(
            at("embedment"),
            CircularFooting::FORMULA,
            quantity,
            value,
            [f64::NEG_INFINITY, most],
            remedy,
        )
    }));
}

pub(super) fn rectangular(
    tower: &Tower,
    footing: &RectangularFooting,
    warnings: &mut Vec<Warning>,
) {
    let modulus = footing.shear_modulus_pa;
    SOIL_MODULUS.check(modulus, at("soil_shear_modulus"), warnings);
    let half_m = footing.half_short_side_m();
    let key = match footing.length_x_m <= footing.length_y_m {
        true => "length_x",
        false => "length_y",
    };
    against_tower(tower, &SIDE, half_m, at(key), warnings);
    warnings.extend(outside(
        at("embedment"),
        footing.formula.name(),
        "the embedment of the footing, divided by half of its shorter side,",
        footing.embedment_m / half_m,
        [f64::NEG_INFINITY, MOST_EMBEDMENT],
        "check the unit (m), or use a type for caissons or piles",
    ));
}
