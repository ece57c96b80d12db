//! The springs of one layer of soil at a height, by its model.

use super::axial::axial;
use super::clay::{Resistance, api_secant, dnv_stiffness, reese_stiff_clay};
use super::elastic::{vesic, winkler, youngs_modulus_pa};
use super::layer::{Clay, GroundLayer, LayerSoil, Sand};
use super::model::SoilModel;
use super::pile::Pile;
use super::pisa::Pisa;
use super::rock::weak_rock;
use super::sand::{kallehave, sorensen, subgrade_modulus_n_per_m3};
use super::table::secant_n_per_m2;
use crate::tower::surroundings::SoilStiffness;

/// The springs of a layer at a height of the pile, with the factors on the soil.
pub(super) fn springs(pile: &Pile<'_>, index: usize, height_m: f64) -> SoilStiffness {
    let lateral = lateral_n_per_m2(pile, index, height_m);
    let rotation = rotation_n(pile, index, height_m);
    let [vertical, torsion] = axial(pile, index, height_m);
    let springs = SoilStiffness {
        x_n_per_m2: lateral,
        y_n_per_m2: lateral,
        z_n_per_m2: vertical,
        torsion_n: torsion,
        rotation_x_n: rotation,
        rotation_y_n: rotation,
    };
    springs.times(pile.factor(index))
}

/// Shear modulus G₀ of a layer at a height, Pa: that of rock is E_ir/(2 (1 + ν)).
pub(super) fn shear_modulus_pa(pile: &Pile<'_>, index: usize, height_m: f64) -> f64 {
    let (layer, share) = pile.layer(index, height_m);
    match (&layer.soil, layer.shear_modulus.as_ref()) {
        (_, Some(modulus)) => modulus.at(layer, share, pile, height_m),
        (LayerSoil::Rock(rock), None) => {
            let youngs_modulus_pa = rock
                .youngs_modulus_pa
                .map_or(f64::NAN, |pair| at(pair, share));
            youngs_modulus_pa / (2.0 * (1.0 + layer.poissons_ratio.unwrap_or(f64::NAN)))
        }
        (
            LayerSoil::Sand(_) | LayerSoil::Clay(_) | LayerSoil::Elastic | LayerSoil::Table(_),
            None,
        ) => f64::NAN,
    }
}

fn lateral_n_per_m2(pile: &Pile<'_>, index: usize, height_m: f64) -> f64 {
    let (layer, share) = pile.layer(index, height_m);
    match &layer.soil {
        LayerSoil::Table(rows) => secant_n_per_m2(rows, height_m),
        LayerSoil::Rock(rock) => {
            let modulus_pa = rock
                .youngs_modulus_pa
                .map_or(f64::NAN, |pair| at(pair, share));
            let depth_m = pile.rock_surface_m(index) - height_m;
            weak_rock(modulus_pa, depth_m, pile.diameter_m(height_m))
        }
        LayerSoil::Sand(sand) => of_sand(pile, index, sand, height_m),
        LayerSoil::Clay(clay) => of_clay(pile, index, clay, height_m),
        LayerSoil::Elastic => of_elastic(pile, index, height_m),
    }
}

/// By the shear modulus; not a number for a model that does not have it.
fn of_elastic(pile: &Pile<'_>, index: usize, height_m: f64) -> f64 {
    let layer = &pile.ground.layers[index];
    match layer.model {
        SoilModel::Winkler => winkler(elastic(pile, index, layer, height_m).0),
        SoilModel::Vesic => {
            let (modulus_pa, poissons_ratio) = elastic(pile, index, layer, height_m);
            let bending_n_m2 = pile.bending_n_m2(height_m);
            let diameter_m = pile.diameter_m(height_m);
            vesic(modulus_pa, poissons_ratio, diameter_m, bending_n_m2)
        }
        SoilModel::PisaCowden | SoilModel::PisaBothkennar | SoilModel::PisaDunkirk => {
            Pisa::of(layer).map_or(f64::NAN, |pisa| {
                let depth = pile.depth_m(height_m) / pile.diameter_m(height_m);
                pisa.lateral.positive_at(depth) * shear_modulus_pa(pile, index, height_m)
            })
        }
        SoilModel::Api
        | SoilModel::Dnv
        | SoilModel::ReeseStiffClay
        | SoilModel::Kallehave
        | SoilModel::Sorensen
        | SoilModel::WeakRock
        | SoilModel::Table => f64::NAN,
    }
}

fn of_sand(pile: &Pile<'_>, index: usize, sand: &Sand, height_m: f64) -> f64 {
    let (depth_m, diameter_m) = (pile.overburden_depth_m(height_m), pile.diameter_m(height_m));
    let modulus_n_per_m3 = || subgrade_modulus_n_per_m3(sand, pile.ground);
    match pile.ground.layers[index].model {
        SoilModel::Api | SoilModel::Dnv => modulus_n_per_m3() * depth_m,
        SoilModel::Kallehave => kallehave(modulus_n_per_m3(), depth_m, diameter_m),
        SoilModel::Sorensen => {
            let angle_deg = sand.friction_angle_deg.unwrap_or(f64::NAN);
            sorensen(angle_deg, depth_m, diameter_m)
        }
        SoilModel::PisaDunkirk
        | SoilModel::PisaCowden
        | SoilModel::PisaBothkennar
        | SoilModel::Winkler
        | SoilModel::Vesic
        | SoilModel::ReeseStiffClay
        | SoilModel::WeakRock
        | SoilModel::Table => of_elastic(pile, index, height_m),
    }
}

fn of_clay(pile: &Pile<'_>, index: usize, clay: &Clay, height_m: f64) -> f64 {
    let diameter_m = pile.diameter_m(height_m);
    let strain = clay.strain_at_half_strength.unwrap_or(f64::NAN);
    let strength_n_per_m = || resistance(pile, index, height_m).map_or(f64::NAN, Resistance::least);
    match pile.ground.layers[index].model {
        SoilModel::Api => api_secant(strength_n_per_m(), strain, diameter_m),
        SoilModel::Dnv => {
            let factor = clay.stiffness_factor.unwrap_or(f64::NAN);
            dnv_stiffness(factor, strength_n_per_m(), strain, diameter_m)
        }
        SoilModel::ReeseStiffClay => reese_stiff_clay(strength_n_per_m(), strain, diameter_m),
        SoilModel::PisaCowden
        | SoilModel::PisaBothkennar
        | SoilModel::PisaDunkirk
        | SoilModel::Winkler
        | SoilModel::Vesic
        | SoilModel::Kallehave
        | SoilModel::Sorensen
        | SoilModel::WeakRock
        | SoilModel::Table => of_elastic(pile, index, height_m),
    }
}

/// The lateral resistance of clay at a height; none if the model of the layer has none.
pub(super) fn resistance(pile: &Pile<'_>, index: usize, height_m: f64) -> Option<Resistance> {
    let (layer, share) = pile.layer(index, height_m);
    let LayerSoil::Clay(clay) = &layer.soil else {
        return None;
    };
    let strength_pa = || {
        clay.undrained_strength_pa
            .map_or(f64::NAN, |pair| at(pair, share))
    };
    let (stress_pa, depth_m, diameter_m) = (
        pile.effective_stress_pa(height_m),
        pile.depth_m(height_m),
        pile.diameter_m(height_m),
    );
    match layer.model {
        SoilModel::Api | SoilModel::Dnv => {
            let factor = clay.strength_factor.unwrap_or(f64::NAN);
            let strength_pa = strength_pa();
            Some(Resistance::matlock(
                strength_pa,
                stress_pa,
                factor,
                depth_m,
                diameter_m,
            ))
        }
        SoilModel::ReeseStiffClay => {
            let mean_pa = pile.mean_strength_pa(index, height_m);
            let strength_pa = strength_pa();
            Some(Resistance::reese(
                mean_pa,
                strength_pa,
                stress_pa,
                depth_m,
                diameter_m,
            ))
        }
        SoilModel::Kallehave
        | SoilModel::Sorensen
        | SoilModel::PisaCowden
        | SoilModel::PisaBothkennar
        | SoilModel::PisaDunkirk
        | SoilModel::Winkler
        | SoilModel::Vesic
        | SoilModel::WeakRock
        | SoilModel::Table => None,
    }
}

fn rotation_n(pile: &Pile<'_>, index: usize, height_m: f64) -> f64 {
    let Some(pisa) = Pisa::of(&pile.ground.layers[index]) else {
        return 0.0;
    };
    let diameter_m = pile.diameter_m(height_m);
    let factor = pisa
        .rotation
        .positive_at(pile.depth_m(height_m) / diameter_m);
    match factor > 0.0 {
        true => factor * shear_modulus_pa(pile, index, height_m) * diameter_m * diameter_m,
        false => 0.0,
    }
}

/// Young's modulus (Pa) and Poisson's ratio of a layer at a height.
fn elastic(pile: &Pile<'_>, index: usize, layer: &GroundLayer, height_m: f64) -> (f64, f64) {
    let poissons_ratio = layer.poissons_ratio.unwrap_or(f64::NAN);
    let shear_pa = shear_modulus_pa(pile, index, height_m);
    (youngs_modulus_pa(shear_pa, poissons_ratio), poissons_ratio)
}

/// The value at a fraction of the way from the top to the bottom of a layer.
pub(super) fn at([top, bottom]: [f64; 2], share: f64) -> f64 {
    top + share * (bottom - top)
}
