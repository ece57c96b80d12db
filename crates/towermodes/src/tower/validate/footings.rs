//! The checks of footings by closed form.

use super::foundation::{check_finite, check_not_indefinite, check_poissons_ratio_of_soil};
use super::scale::{error, length, not_negative, positive};
use crate::space::SpatialMatrix;
use crate::tower::closed_form::{CircularFooting, RectangularFooting};
use crate::tower::error::{Place, Problem, TowerError};

fn at(key: &'static str) -> Place {
    Place::Foundation { key }
}

pub(super) fn check_circular(footing: &CircularFooting) -> Result<(), TowerError> {
    length(at("radius"), "the footing's radius", footing.radius_m)?;
    check_embedment(footing.embedment_m)?;
    check_soil(footing.shear_modulus_pa, footing.poissons_ratio)?;
    check_strata(footing)?;
    check_stiffness(&footing.springs().matrix())
}

pub(super) fn check_rectangular(footing: &RectangularFooting) -> Result<(), TowerError> {
    let quantity = "the footing's side along x";
    length(at("length_x"), quantity, footing.length_x_m)?;
    let quantity = "the footing's side along y";
    length(at("length_y"), quantity, footing.length_y_m)?;
    check_embedment(footing.embedment_m)?;
    check_soil(footing.shear_modulus_pa, footing.poissons_ratio)?;
    check_stiffness(&footing.stiffness())
}

pub(super) fn check_embedment(embedment_m: f64) -> Result<(), TowerError> {
    not_negative(at("embedment"), "the embedment", embedment_m, " m")
}

pub(super) fn check_soil(shear_modulus_pa: f64, poissons_ratio: f64) -> Result<(), TowerError> {
    let (key, quantity) = ("soil_shear_modulus", "the soil's shear modulus");
    positive(at(key), quantity, shear_modulus_pa, " Pa")?;
    check_poissons_ratio_of_soil(poissons_ratio)
}

/// Infinity is a half-space, or rock.
fn check_strata(footing: &CircularFooting) -> Result<(), TowerError> {
    let (embedment_m, thickness_m) = (footing.embedment_m, footing.stratum_thickness_m);
    if thickness_m != f64::INFINITY {
        let quantity = "the thickness of the stratum";
        length(at("soil_thickness"), quantity, thickness_m)?;
    }
    let lower_pa = footing.lower_shear_modulus_pa;
    if lower_pa != f64::INFINITY {
        let quantity = "the shear modulus below the stratum";
        positive(at("lower_shear_modulus"), quantity, lower_pa, " Pa")?;
    }
    if embedment_m >= thickness_m {
        let problem = Problem::EmbeddedBelowStratum {
            embedment_m,
            thickness_m,
        };
        return error(at("embedment"), problem);
    }
    if embedment_m > 0.0 && footing.is_over_stratum() {
        return error(
            at("embedment"),
            Problem::EmbeddedInTwoStrata { embedment_m },
        );
    }
    Ok(())
}

/// A formula far outside its range can give a matrix that no soil has.
fn check_stiffness(matrix: &SpatialMatrix) -> Result<(), TowerError> {
    let what = "stiffness of the footing by its formula";
    check_finite("type", what, matrix)?;
    check_not_indefinite("embedment", what, matrix)
}
