//! Foundations by closed form in tables.

use towermodes::{FoundationSprings, Monopile, PileTube, SoilProfile, WinklerPile};

use super::super::document::Block;
use super::super::table::Table;
use super::foundation::of_springs;
use super::table;
use crate::number::{digits, given, length};

pub(super) fn of_monopile(pile: &Monopile) -> Vec<Block> {
    let slenderness = pile.slenderness();
    let mut facts = of_tube(&pile.tube);
    facts.extend([
        (
            "Young's modulus of the soil at the depth of one diameter (Pa)",
            given(pile.soil_youngs_modulus_pa),
        ),
        (
            "profile of Young's modulus",
            profile(pile.soil_profile).to_owned(),
        ),
        (
            "Poisson's ratio of the soil (−)",
            given(pile.soil_poissons_ratio),
        ),
        ("length/diameter (−)", digits(slenderness.ratio, 4)),
        ("rigid up to (−)", digits(slenderness.rigid_at_most, 4)),
        (
            "flexible from (−)",
            digits(slenderness.flexible_at_least, 4),
        ),
    ]);
    let caption = format!("Monopile in elastic soil, by {}", pile.formula.name());
    blocks(Table::of_facts(&caption, facts), &pile.springs())
}

pub(super) fn of_winkler_pile(pile: &WinklerPile) -> Vec<Block> {
    let mut facts = of_tube(&pile.tube);
    facts.extend([
        (
            "soil spring at the depth of one diameter (N/m²)",
            given(pile.soil_spring_n_per_m2),
        ),
        ("exponent of the depth (−)", given(pile.exponent)),
        ("reduced length ηL (−)", digits(pile.reduced_length(), 4)),
    ]);
    let caption = "Pile on springs along its length";
    blocks(Table::of_facts(caption, facts), &pile.springs())
}

fn of_tube(tube: &PileTube) -> Vec<(&'static str, String)> {
    vec![
        ("diameter (m)", length(tube.diameter_m)),
        ("wall thickness (m)", length(tube.wall_thickness_m)),
        ("embedded length (m)", length(tube.embedded_length_m)),
        ("Young's modulus (Pa)", given(tube.youngs_modulus_pa)),
    ]
}

fn profile(profile: SoilProfile) -> &'static str {
    match profile {
        SoilProfile::Homogeneous => "homogeneous",
        SoilProfile::Parabolic => "with the square root of the depth",
        SoilProfile::Linear => "with the depth",
    }
}

fn blocks(facts: Table, springs: &FoundationSprings) -> Vec<Block> {
    let springs = of_springs("Springs at the base", springs, |value| digits(value, 5));
    vec![table(facts), table(springs)]
}
