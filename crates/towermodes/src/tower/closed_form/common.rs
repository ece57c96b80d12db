//! Values of several foundations by closed form, and their common checks.

use super::form::Buried;
use crate::inputs::{Input, Limit, Quantity, names};
use crate::tower::error::{Place, Problem, TowerError};
use crate::tower::warning::{Site, Warning};

/// How Young's modulus of the soil grows with the depth z below the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SoilProfile {
    /// The modulus is constant.
    Homogeneous,
    /// The modulus is proportional to √z.
    Parabolic,
    /// The modulus is proportional to z.
    Linear,
}

names!(SoilProfile: Homogeneous = "homogeneous", Parabolic = "parabolic", Linear = "linear");

/// Radius of a circular footing.
pub(super) const RADIUS: Input =
    Input::length("radius", "the radius of the footing").also("r footing_radius");

/// Depth of the underside of a footing below the surface of the soil.
pub(super) const EMBEDMENT: Input = Input::new(
    "embedment",
    " m",
    Limit::NotNegative,
    "the depth of embedment",
)
.or(0.0)
.quiet()
.also("embed embedment_depth");

/// Shear modulus of the soil below a footing.
pub(super) const SOIL_SHEAR_MODULUS: Input = Input::new(
    "soil_shear_modulus",
    " Pa",
    Limit::Positive,
    "the shear modulus of the soil",
)
.hint("Pa; dense sand has about 5e7")
.usual_of(Quantity::SoilShearModulus, [1e6, 5e10])
.of_soil();

/// Poisson's ratio of the soil.
pub(super) const SOIL_POISSONS_RATIO: Input = Input::new(
    "soil_poissons_ratio",
    "",
    Limit::PoissonsRatioOfSoil,
    "Poisson's ratio of the soil",
)
.hint("sand has about 0.3");

/// Young's modulus of the soil around a pile or a caisson.
pub(super) const SOIL_YOUNGS_MODULUS: Input = Input::new(
    "soil_youngs_modulus",
    " Pa",
    Limit::Positive,
    "Young's modulus of the soil at the depth of one diameter",
)
.note("at the depth of one diameter")
.hint("Pa, at the depth of one diameter")
.usual_of(Quantity::SoilYoungsModulus, [1e6, 5e10])
.of_soil();

/// The profile of that modulus.
pub(super) const SOIL_PROFILE: Input = Input::choice(
    "soil_profile",
    "the profile of Young's modulus over the depth",
)
.note("homogeneous, parabolic or linear");

/// Stiffness against z, which a formula does not give.
pub(super) const VERTICAL: Input = Input::new(
    "vertical",
    " N/m",
    Limit::Stiffness,
    "the stiffness against z",
)
.or(f64::INFINITY)
.quiet()
.note("inf is rigid");

/// Stiffness against rotation about z, which a formula does not give.
pub(super) const TORSION: Input = Input::new(
    "torsion",
    " N m",
    Limit::Stiffness,
    "the stiffness against rotation about z",
)
.or(f64::INFINITY)
.quiet();

/// Whether the embedment couples sliding and rocking.
pub(super) const COUPLED: Input = Input::flag("coupled", "the coupling of sliding and rocking")
    .quiet()
    .note("whether the embedment couples sliding and rocking");

/// A footing of half these sides (m) with its underside at a depth (m).
pub(super) fn footing(half_m: [f64; 2], depth_m: f64) -> Buried {
    Buried {
        noun: "footing",
        half_m,
        depth_m,
        is_round: true,
        is_deep: false,
        soil: None,
    }
}

/// A pile or a caisson.
pub(super) fn deep(noun: &'static str, diameter_m: f64, depth_m: f64) -> Buried {
    Buried {
        noun,
        is_deep: true,
        ..footing([0.5 * diameter_m; 2], depth_m)
    }
}

/// An error at a key of the foundation.
pub(super) fn error(key: &'static str, problem: Problem) -> Result<(), TowerError> {
    let place = Place::Foundation { key };
    Err(TowerError { place, problem })
}

/// The place of a key of the foundation, for warnings.
pub(super) fn at(key: &'static str) -> Site {
    Site::at(Place::Foundation { key })
}

/// A warning of a value outside the usual range of towers.
pub(super) fn unusual(
    quantity: Quantity,
    key: &'static str,
    value: f64,
    [least, most]: [f64; 2],
) -> Option<Warning> {
    (!(least..=most).contains(&value)).then_some(Warning::Unusual {
        quantity,
        site: at(key),
        value,
        least,
        most,
    })
}

/// A warning of half the width of a footing (m) that does not suit the diameter of the tower (m).
pub(super) fn against_tower(
    quantity: Quantity,
    key: &'static str,
    half_width_m: f64,
    base_diameter_m: Option<f64>,
) -> Option<Warning> {
    let ratio = half_width_m / (0.5 * base_diameter_m?);
    unusual(quantity, key, ratio, [1.0, 20.0])
}

/// A warning of the diameter of a pile or a caisson (m) that does not suit the tower's (m).
pub(super) fn against_diameter(diameter_m: f64, base_diameter_m: Option<f64>) -> Option<Warning> {
    let ratio = diameter_m / base_diameter_m?;
    unusual(Quantity::PileDiameter, "diameter", ratio, [0.3, 5.0])
}

/// A warning that a value is outside the range for which a formula was derived.
pub(super) fn outside(
    key: &'static str,
    formula: &'static str,
    quantity: &'static str,
    value: f64,
    [least, most]: [f64; 2],
    remedy: &'static str,
) -> Option<Warning> {
    (!(least..=most).contains(&value)).then_some(Warning::OutsideFormula {
        site: at(key),
        formula,
        quantity,
        value,
        least,
        most,
        remedy,
    })
}

/// The coupling stiffness of an embedded footing about its underside: the lateral spring acts a
/// third of the depth above it.
pub(super) fn coupling_n(is_coupled: bool, embedment_m: f64, lateral_n_per_m: f64) -> f64 {
    match is_coupled {
        true => embedment_m / 3.0 * lateral_n_per_m,
        false => 0.0,
    }
}
