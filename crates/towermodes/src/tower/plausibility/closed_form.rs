//! Foundations by closed form: units, and the range of the formulas.

use super::usual::Usual;
use crate::tower::closed_form::{
    BeamFormula, Monopile, PileBehaviour, PileFormula, PileTube, Slenderness, SoilSpring,
    SuctionCaisson, WinklerPile,
};
use crate::tower::{Place, Quantity, Site, Tower, Warning};

const SOIL_MODULUS: Usual = Usual::new(Quantity::SoilYoungsModulus, 1e6, 5e10);
const SOIL_SPRING: Usual = Usual::new(Quantity::SoilSpring, 5e4, 1e12);
const PILE_MODULUS: Usual = Usual::new(Quantity::YoungsModulus, 1e9, 1e12);
const PILE_DIAMETER: Usual = Usual::new(Quantity::PileDiameter, 0.3, 5.0);
const PILE_WALL: Usual = Usual::new(Quantity::PileWall, 2.0, 500.0);
const SLENDERNESS: Usual = Usual::new(Quantity::PileSlenderness, 1.0, 100.0);

fn at(key: &'static str) -> Site {
    Site::at(Place::Foundation { key })
}

pub(super) fn monopile(tower: &Tower, pile: &Monopile, warnings: &mut Vec<Warning>) {
    tube(tower, &pile.tube, warnings);
    let modulus_pa = pile.soil_youngs_modulus_pa;
    SOIL_MODULUS.check(modulus_pa, at("soil_youngs_modulus"), warnings);
    warnings.extend(range_of_formula(pile));
}

pub(super) fn winkler_pile(tower: &Tower, pile: &WinklerPile, warnings: &mut Vec<Warning>) {
    tube(tower, &pile.tube, warnings);
    match pile.soil_spring {
        SoilSpring::Given { spring_n_per_m2 } => {
            SOIL_SPRING.check(spring_n_per_m2, at("soil_spring"), warnings);
        }
        SoilSpring::Gazetas { youngs_modulus_pa }
        | SoilSpring::Vesic {
            youngs_modulus_pa, ..
        } => {
            SOIL_MODULUS.check(youngs_modulus_pa, at("soil_youngs_modulus"), warnings);
        }
    }
    warnings.extend(between(pile));
}

pub(super) fn caisson(tower: &Tower, caisson: &SuctionCaisson, warnings: &mut Vec<Warning>) {
    if let Some(station) = tower.stations().first() {
        let ratio = caisson.diameter_m / station.outer_diameter_m;
        PILE_DIAMETER.check(ratio, at("diameter"), warnings);
    }
    let modulus_pa = caisson.soil_youngs_modulus_pa;
    SOIL_MODULUS.check(modulus_pa, at("soil_youngs_modulus"), warnings);
    warnings.extend(outside(
        at("skirt_length"),
        SuctionCaisson::FORMULA,
        "the length of the skirt, divided by the diameter,",
        caisson.slenderness(),
        SuctionCaisson::SLENDERNESS,
        "a longer one is a pile, a shorter one a footing; the unit of both is m",
    ));
}

/// A value for which a formula was not derived.
pub(super) fn outside(
    site: Site,
    formula: &'static str,
    quantity: &'static str,
    value: f64,
    [least, most]: [f64; 2],
    remedy: &'static str,
) -> Option<Warning> {
    (!(least..=most).contains(&value)).then_some(Warning::OutsideFormula {
        site,
        formula,
        quantity,
        value,
        least,
        most,
        remedy,
    })
}

/// Poulos & Davis, neither rigid nor flexible.
fn between(pile: &WinklerPile) -> Option<Warning> {
    let [rigid_at_most, flexible_at_least] = pile.limits_of_poulos_davis();
    let length = pile.reduced_length();
    let is_between = rigid_at_most < length && length < flexible_at_least;
    let is_theirs = pile.formula == BeamFormula::PoulosDavis;
    (is_theirs && is_between).then_some(Warning::BetweenRigidAndFlexible {
        site: at("embedded_length"),
        formula: pile.formula.name(),
        measure: "its reduced length (n/EI)^(1/(4+m)) L on springs n z^m",
        length,
        rigid_at_most,
        flexible_at_least,
    })
}

fn tube(tower: &Tower, tube: &PileTube, warnings: &mut Vec<Warning>) {
    if let Some(station) = tower.stations().first() {
        let ratio = tube.diameter_m / station.outer_diameter_m;
        PILE_DIAMETER.check(ratio, at("diameter"), warnings);
    }
    let wall = tube.diameter_m / tube.wall_thickness_m;
    PILE_WALL.check(wall, at("wall_thickness"), warnings);
    SLENDERNESS.check(tube.slenderness(), at("embedded_length"), warnings);
    PILE_MODULUS.check(tube.youngs_modulus_pa, at("youngs_modulus"), warnings);
}

/// A pile for which its formula was not derived.
fn range_of_formula(pile: &Monopile) -> Option<Warning> {
    let Slenderness {
        ratio,
        rigid_at_most,
        flexible_at_least,
    } = pile.slenderness();
    let (site, formula) = (at("embedded_length"), pile.formula.name());
    let quantity = "the embedded length of the pile, divided by its diameter,";
    let softer = "a shorter pile is softer: use type = \"winkler-pile\" or [[soil]] along the pile";
    let bends = "a longer pile bends: use type = \"winkler-pile\" or [[soil]] along the pile";
    match pile.formula {
        PileFormula::ShadlouBhattacharya => {
            let is_between = pile.slenderness().behaviour() == PileBehaviour::Between;
            is_between.then_some(Warning::BetweenRigidAndFlexible {
                site,
                formula,
                measure: "its embedded length divided by its diameter",
                length: ratio,
                rigid_at_most,
                flexible_at_least,
            })
        }
        PileFormula::Randolph | PileFormula::En1998 => {
            let range = [flexible_at_least, f64::INFINITY];
            outside(site, formula, quantity, ratio, range, softer)
        }
        PileFormula::CarterKulhawy => {
            let range = [f64::NEG_INFINITY, rigid_at_most];
            outside(site, formula, quantity, ratio, range, bends)
        }
    }
}
