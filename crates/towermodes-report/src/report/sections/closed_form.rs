//! Foundations by closed form in tables.

use towermodes::{
    FoundationSprings, Monopile, PileTube, SoilProfile, SoilSpring, SuctionCaisson, WinklerPile,
};

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
    facts.extend(of_soil_spring(pile));
    facts.extend([
        (
            "exponent of the depth in the springs (−)",
            given(pile.spring_exponent()),
        ),
        ("reduced length ηL (−)", digits(pile.reduced_length(), 4)),
    ]);
    let formula = pile.formula.name();
    let caption = format!("Pile on springs along its length, by {formula}");
    blocks(Table::of_facts(&caption, facts), &pile.springs())
}

fn of_soil_spring(pile: &WinklerPile) -> Vec<(&'static str, String)> {
    let spring = "soil spring at the depth of one diameter (N/m²)";
    let modulus = "Young's modulus of the soil at the depth of one diameter (Pa)";
    match pile.soil_spring {
        SoilSpring::Given { spring_n_per_m2 } => vec![(spring, given(spring_n_per_m2))],
        SoilSpring::Gazetas { youngs_modulus_pa } => vec![
            (modulus, given(youngs_modulus_pa)),
            (spring, digits(pile.spring_n_per_m2(), 5)),
        ],
        SoilSpring::Vesic {
            youngs_modulus_pa,
            poissons_ratio,
        } => vec![
            (modulus, given(youngs_modulus_pa)),
            ("Poisson's ratio of the soil (−)", given(poissons_ratio)),
            (spring, digits(pile.spring_n_per_m2(), 5)),
        ],
    }
}

pub(super) fn of_caisson(caisson: &SuctionCaisson) -> Vec<Block> {
    let facts = vec![
        ("diameter (m)", length(caisson.diameter_m)),
        ("length of the skirt (m)", length(caisson.skirt_length_m)),
        (
            "Young's modulus of the soil at the depth of one diameter (Pa)",
            given(caisson.soil_youngs_modulus_pa),
        ),
        (
            "profile of Young's modulus",
            profile(caisson.soil_profile).to_owned(),
        ),
        (
            "Poisson's ratio of the soil (−)",
            given(caisson.soil_poissons_ratio),
        ),
        ("length/diameter (−)", digits(caisson.slenderness(), 4)),
    ];
    let caption = format!(
        "Suction caisson in elastic soil, by {}",
        SuctionCaisson::FORMULA
    );
    blocks(Table::of_facts(&caption, facts), &caisson.springs())
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
