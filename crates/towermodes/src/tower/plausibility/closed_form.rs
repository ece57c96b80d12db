//! Foundations by closed form: units, and the range of the formulas.

use super::usual::Usual;
use crate::tower::closed_form::{
    Monopile, PileBehaviour, PileFormula, PileTube, Slenderness, WinklerPile,
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
    SOIL_SPRING.check(pile.soil_spring_n_per_m2, at("soil_spring"), warnings);
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
    let behaviour = pile.slenderness().behaviour();
    let (site, formula) = (at("embedded_length"), pile.formula.name());
    match (pile.formula, behaviour) {
        (_, PileBehaviour::Flexible) | (PileFormula::ShadlouBhattacharya, PileBehaviour::Rigid) => {
            None
        }
        (PileFormula::ShadlouBhattacharya, _) => Some(Warning::BetweenRigidAndFlexible {
            site,
            formula,
            slenderness: ratio,
            rigid_at_most,
            flexible_at_least,
        }),
        _ => Some(Warning::OutsideFormula {
            site,
            formula,
            quantity: "the embedded length of the pile, divided by its diameter,",
            value: ratio,
            least: flexible_at_least,
            most: f64::INFINITY,
            remedy: "a shorter pile is softer: use type = \"winkler-pile\" or [[soil]] along the pile",
        }),
    }
}
