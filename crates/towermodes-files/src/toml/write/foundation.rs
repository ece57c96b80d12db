//! `[foundation]`.

use towermodes::space::SpatialMatrix;
use towermodes::{
    BeamFormula, CircularFooting, FloatingPlatform, Foundation, FoundationSprings, HalfSpace,
    Monopile, PileTube, RectangularFooting, ReferredMatrix, SoilSpring, StiffnessFoundation,
    SuctionCaisson, WinklerPile,
};

use super::bodies::{inertia_with, triple};
use super::writing::Writing;
use crate::toml::foundation::{
    BEAM_FORMULAS, FOOTING_FORMULAS, FORMULAS, PROFILES, SPRING_FORMULAS, SpringFormula,
};
use crate::toml::schema::{self, TableSchema};

const NONE: SpatialMatrix = [[0.0; 6]; 6];

/// Left out where the base is clamped.
pub(super) fn foundation(foundation: &Foundation, writing: &mut Writing) {
    match foundation {
        Foundation::Clamped => {}
        Foundation::Stiffness(foundation) => stiffness(foundation, writing),
        Foundation::Springs(foundation) => springs(foundation, writing),
        Foundation::HalfSpace(footing) => half_space(footing, writing),
        Foundation::CircularFooting(footing) => circular_footing(footing, writing),
        Foundation::RectangularFooting(footing) => rectangular_footing(footing, writing),
        Foundation::SuctionCaisson(caisson) => suction_caisson(caisson, writing),
        Foundation::Monopile(pile) => monopile(pile, writing),
        Foundation::WinklerPile(pile) => winkler_pile(pile, writing),
        Foundation::Floating(platform) => floating(platform, writing),
    }
}

fn kind(kind: &str, table: &'static TableSchema, writing: &mut Writing) {
    writing.section_called("[foundation]", table);
    writing.commented("type", &format!("\"{kind}\""), "");
}

fn matrix(key: &str, matrix: &SpatialMatrix, writing: &mut Writing) {
    writing.open_rows(key);
    writing.number_rows(matrix, 6);
    writing.line("]");
}

fn stiffness(foundation: &StiffnessFoundation, writing: &mut Writing) {
    kind("stiffness", &schema::STIFFNESS, writing);
    matrix("matrix", &foundation.stiffness, writing);
    if foundation.inertia != NONE {
        matrix("mass", &foundation.inertia, writing);
    }
}

fn springs(springs: &FoundationSprings, writing: &mut Writing) {
    kind("springs", &schema::SPRINGS, writing);
    writing.number("lateral", springs.lateral_n_per_m);
    writing.number("rocking", springs.rocking_n_m);
    writing.number("vertical", springs.vertical_n_per_m);
    writing.number("torsion", springs.torsion_n_m);
    if springs.coupling_n != 0.0 {
        writing.number("coupling", springs.coupling_n);
    }
}

fn half_space(footing: &HalfSpace, writing: &mut Writing) {
    kind("half-space", &schema::HALF_SPACE, writing);
    writing.number("radius", footing.radius_m);
    if footing.embedment_m != 0.0 {
        writing.number("embedment", footing.embedment_m);
    }
    writing.number("soil_shear_modulus", footing.shear_modulus_pa);
    writing.number("soil_poissons_ratio", footing.poissons_ratio);
}

/// Of a footing in or on the soil: embedment, soil.
fn in_soil(embedment_m: f64, shear_modulus_pa: f64, poissons_ratio: f64, writing: &mut Writing) {
    if embedment_m != 0.0 {
        writing.number("embedment", embedment_m);
    }
    writing.number("soil_shear_modulus", shear_modulus_pa);
    writing.number("soil_poissons_ratio", poissons_ratio);
}

/// Left out where a footing is not coupled.
fn coupled(is_coupled: bool, writing: &mut Writing) {
    if is_coupled {
        writing.value("coupled", "true");
    }
}

fn circular_footing(footing: &CircularFooting, writing: &mut Writing) {
    kind("circular-footing", &schema::CIRCULAR_FOOTING, writing);
    writing.number("radius", footing.radius_m);
    let (modulus_pa, ratio) = (footing.shear_modulus_pa, footing.poissons_ratio);
    in_soil(footing.embedment_m, modulus_pa, ratio, writing);
    let thickness_m = footing.stratum_thickness_m;
    let lower_pa = footing.lower_shear_modulus_pa;
    // A modulus below the stratum needs a stratum, be it infinite.
    if thickness_m != f64::INFINITY || lower_pa != f64::INFINITY {
        writing.number("soil_thickness", thickness_m);
    }
    if lower_pa != f64::INFINITY {
        writing.number("lower_shear_modulus", lower_pa);
    }
    coupled(footing.is_coupled, writing);
}

fn rectangular_footing(footing: &RectangularFooting, writing: &mut Writing) {
    kind("rectangular-footing", &schema::RECTANGULAR_FOOTING, writing);
    writing.value("formula", &named(&FOOTING_FORMULAS, &footing.formula));
    writing.number("length_x", footing.length_x_m);
    writing.number("length_y", footing.length_y_m);
    let (modulus_pa, ratio) = (footing.shear_modulus_pa, footing.poissons_ratio);
    in_soil(footing.embedment_m, modulus_pa, ratio, writing);
    coupled(footing.is_coupled, writing);
}

fn suction_caisson(caisson: &SuctionCaisson, writing: &mut Writing) {
    kind("suction-caisson", &schema::SUCTION_CAISSON, writing);
    writing.number("diameter", caisson.diameter_m);
    writing.number("skirt_length", caisson.skirt_length_m);
    writing.value("soil_profile", &named(&PROFILES, &caisson.soil_profile));
    writing.number("soil_youngs_modulus", caisson.soil_youngs_modulus_pa);
    writing.number("soil_poissons_ratio", caisson.soil_poissons_ratio);
    others(caisson.vertical_n_per_m, caisson.torsion_n_m, writing);
}

/// The name of a choice in quotation marks.
pub(super) fn named<T: PartialEq>(choices: &[(&'static str, T)], choice: &T) -> String {
    let name = choices.iter().find(|(_, other)| other == choice);
    format!("\"{}\"", name.map_or("", |(name, _)| *name))
}

fn tube(tube: &PileTube, writing: &mut Writing) {
    writing.number("diameter", tube.diameter_m);
    writing.number("wall_thickness", tube.wall_thickness_m);
    writing.number("embedded_length", tube.embedded_length_m);
    writing.number("youngs_modulus", tube.youngs_modulus_pa);
}

/// Springs that are rigid are left out.
fn others(vertical_n_per_m: f64, torsion_n_m: f64, writing: &mut Writing) {
    for (key, value) in [("vertical", vertical_n_per_m), ("torsion", torsion_n_m)] {
        if value != f64::INFINITY {
            writing.number(key, value);
        }
    }
}

fn monopile(pile: &Monopile, writing: &mut Writing) {
    kind("monopile", &schema::MONOPILE, writing);
    writing.value("formula", &named(&FORMULAS, &pile.formula));
    tube(&pile.tube, writing);
    writing.value("soil_profile", &named(&PROFILES, &pile.soil_profile));
    writing.number("soil_youngs_modulus", pile.soil_youngs_modulus_pa);
    writing.number("soil_poissons_ratio", pile.soil_poissons_ratio);
    others(pile.vertical_n_per_m, pile.torsion_n_m, writing);
}

fn winkler_pile(pile: &WinklerPile, writing: &mut Writing) {
    kind("winkler-pile", &schema::WINKLER_PILE, writing);
    tube(&pile.tube, writing);
    if pile.formula != BeamFormula::Exact {
        writing.value("formula", &named(&BEAM_FORMULAS, &pile.formula));
    }
    soil_spring(&pile.soil_spring, writing);
    writing.number("exponent", pile.exponent);
    others(pile.vertical_n_per_m, pile.torsion_n_m, writing);
}

fn soil_spring(spring: &SoilSpring, writing: &mut Writing) {
    let mut by = |formula, modulus_pa| {
        writing.value("spring_formula", &named(&SPRING_FORMULAS, &formula));
        writing.number("soil_youngs_modulus", modulus_pa);
    };
    match *spring {
        SoilSpring::Given { spring_n_per_m2 } => writing.number("soil_spring", spring_n_per_m2),
        SoilSpring::Gazetas { youngs_modulus_pa } => by(SpringFormula::Gazetas, youngs_modulus_pa),
        SoilSpring::Vesic {
            youngs_modulus_pa,
            poissons_ratio,
        } => {
            by(SpringFormula::Vesic, youngs_modulus_pa);
            writing.number("soil_poissons_ratio", poissons_ratio);
        }
    }
}

fn floating(platform: &FloatingPlatform, writing: &mut Writing) {
    kind("floating", &schema::FLOATING, writing);
    writing.number("mass", platform.mass_kg);
    writing.value("center", &triple(platform.center_m));
    inertia_with(&platform.inertia_kg_m2, &["xx", "yy", "zz"], writing);
    let matrices = [
        ("added_mass", &platform.added_mass),
        ("hydrostatic", &platform.hydrostatic),
        ("mooring", &platform.mooring),
    ];
    for (key, referred) in matrices {
        if *referred != ReferredMatrix::default() {
            writing.number(&format!("{key}_height"), referred.height_m);
            matrix(key, &referred.matrix, writing);
        }
    }
}
