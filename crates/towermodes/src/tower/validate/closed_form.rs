//! The checks of foundations by closed form.

use super::foundation::check_poissons_ratio_of_soil;
use super::scale::{error, length, positive, stiffness};
use crate::symmetric::eigenpairs;
use crate::tower::closed_form::{
    BeamFormula, HeadStiffness, Monopile, PileTube, SoilSpring, SuctionCaisson, WinklerPile,
};
use crate::tower::error::{Place, Problem, TowerError};

/// Springs that grow with a higher power of the depth are no soil.
const EXPONENTS: [f64; 2] = [0.0, 4.0];

fn at(key: &'static str) -> Place {
    Place::Foundation { key }
}

pub(super) fn check_monopile(pile: &Monopile) -> Result<(), TowerError> {
    check_tube(&pile.tube)?;
    if !pile.formula.has(pile.soil_profile) {
        let formula = pile.formula.name();
        return error(
            at("soil_profile"),
            Problem::ProfileWithoutFormula { formula },
        );
    }
    check_soil_modulus(pile.soil_youngs_modulus_pa)?;
    check_poissons_ratio_of_soil(pile.soil_poissons_ratio)?;
    check_others(pile.vertical_n_per_m, pile.torsion_n_m)?;
    check_head("formula", &pile.head())
}

pub(super) fn check_winkler_pile(pile: &WinklerPile) -> Result<(), TowerError> {
    check_tube(&pile.tube)?;
    check_soil_spring(&pile.soil_spring)?;
    let quantity = "the exponent of the depth";
    within("exponent", quantity, pile.exponent, "", EXPONENTS)?;
    let exponent = pile.spring_exponent();
    if pile.formula == BeamFormula::PoulosDavis && exponent != 0.0 && exponent != 1.0 {
        let formula = pile.formula.name();
        let problem = Problem::ExponentWithoutFormula { formula, exponent };
        return error(at("exponent"), problem);
    }
    check_others(pile.vertical_n_per_m, pile.torsion_n_m)?;
    check_head("type", &pile.head())
}

fn check_soil_spring(spring: &SoilSpring) -> Result<(), TowerError> {
    match *spring {
        SoilSpring::Given { spring_n_per_m2 } => {
            let (key, quantity) = ("soil_spring", "the soil spring");
            positive(at(key), quantity, spring_n_per_m2, " N/m2")
        }
        SoilSpring::Gazetas { youngs_modulus_pa } => check_soil_modulus(youngs_modulus_pa),
        SoilSpring::Vesic {
            youngs_modulus_pa,
            poissons_ratio,
        } => {
            check_soil_modulus(youngs_modulus_pa)?;
            check_poissons_ratio_of_soil(poissons_ratio)
        }
    }
}

pub(super) fn check_caisson(caisson: &SuctionCaisson) -> Result<(), TowerError> {
    let quantity = "the caisson's diameter";
    length(at("diameter"), quantity, caisson.diameter_m)?;
    let quantity = "the length of the caisson's skirt";
    length(at("skirt_length"), quantity, caisson.skirt_length_m)?;
    check_soil_modulus(caisson.soil_youngs_modulus_pa)?;
    check_poissons_ratio_of_soil(caisson.soil_poissons_ratio)?;
    check_others(caisson.vertical_n_per_m, caisson.torsion_n_m)?;
    check_head("skirt_length", &caisson.head())
}

fn check_soil_modulus(youngs_modulus_pa: f64) -> Result<(), TowerError> {
    let (key, quantity) = ("soil_youngs_modulus", "the soil's Young's modulus");
    positive(at(key), quantity, youngs_modulus_pa, " Pa")
}

fn check_tube(tube: &PileTube) -> Result<(), TowerError> {
    length(at("diameter"), "the pile's diameter", tube.diameter_m)?;
    let (key, quantity) = ("wall_thickness", "the pile's wall thickness");
    length(at(key), quantity, tube.wall_thickness_m)?;
    let thickest_m = 0.5 * tube.diameter_m;
    within(
        key,
        quantity,
        tube.wall_thickness_m,
        " m",
        [0.0, thickest_m],
    )?;
    let quantity = "the pile's embedded length";
    length(at("embedded_length"), quantity, tube.embedded_length_m)?;
    let quantity = "the pile's Young's modulus";
    positive(
        at("youngs_modulus"),
        quantity,
        tube.youngs_modulus_pa,
        " Pa",
    )
}

/// Springs that no closed form gives; infinity is a rigid one.
fn check_others(vertical_n_per_m: f64, torsion_n_m: f64) -> Result<(), TowerError> {
    let springs = [
        ("vertical", "the vertical spring", vertical_n_per_m, " N/m"),
        ("torsion", "the torsion spring", torsion_n_m, " N m"),
    ];
    for (key, quantity, value, unit) in springs {
        if value != f64::INFINITY {
            stiffness(at(key), quantity, value, unit)?;
        }
    }
    Ok(())
}

fn within(
    key: &'static str,
    quantity: &'static str,
    value: f64,
    unit: &'static str,
    [least, most]: [f64; 2],
) -> Result<(), TowerError> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    if !value.is_finite() {
        return error(at(key), Problem::NotFinite { quantity, value });
    }
    let problem = Problem::OutOfRange {
        quantity,
        value,
        unit,
        least,
        most,
    };
    error(at(key), problem)
}

/// A formula far outside its range can give a matrix that no soil has.
fn check_head(key: &'static str, head: &HeadStiffness) -> Result<(), TowerError> {
    let (lateral, coupling) = (head.lateral_n_per_m, head.coupling_n);
    let rocking = head.rocking_n_m;
    let quantity = "the stiffness of the foundation's head";
    for value in [lateral, coupling, rocking] {
        if !value.is_finite() {
            return error(at(key), Problem::NotFinite { quantity, value });
        }
    }
    if lateral > 0.0 && rocking > 0.0 && coupling.abs() <= lateral.sqrt() * rocking.sqrt() {
        return Ok(());
    }
    let (values, _) = eigenpairs([[lateral, coupling], [coupling, rocking]]);
    let problem = Problem::Indefinite {
        what: "stiffness of the foundation's head by its formula",
        eigenvalue: values[0],
    };
    error(at(key), problem)
}
