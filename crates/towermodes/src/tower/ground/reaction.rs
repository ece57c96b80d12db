//! The springs of one layer of soil at a height, by its model.

use super::axial::axial;
use super::clay::{api_secant, dnv_stiffness, matlock_strength, reese_stiff_clay};
use super::description::AxialModel;
use super::elastic::{vesic, winkler, youngs_modulus_pa};
use super::layer::{Clay, GroundLayer, LayerSoil, Sand};
use super::model::SoilModel;
use super::pile::Pile;
use super::pisa::Pisa;
use super::rock::weak_rock;
use super::sand::{kallehave, sorensen, subgrade_modulus_n_per_m3};
use super::table::secant_n_per_m2;
use crate::tower::surroundings::SoilStiffness;

/// The springs of a layer at a height of the pile, with the factor on the soil.
pub(super) fn springs(pile: &Pile<'_>, index: usize, height_m: f64) -> SoilStiffness {
    let factor = pile.ground.factor;
    let lateral = factor * lateral_n_per_m2(pile, index, height_m);
    let rotation = factor * rotation_n(pile, index, height_m);
    let [vertical, torsion] = axial(pile, index, height_m).map(|spring| factor * spring);
    SoilStiffness {
        x_n_per_m2: lateral,
        y_n_per_m2: lateral,
        z_n_per_m2: vertical,
        torsion_n: torsion,
        rotation_x_n: rotation,
        rotation_y_n: rotation,
    }
}

/// Shear modulus G₀ of a layer at a height, Pa.
pub(super) fn shear_modulus_pa(pile: &Pile<'_>, index: usize, height_m: f64) -> f64 {
    let (layer, share) = pile.layer(index, height_m);
    let modulus = layer.shear_modulus.as_ref();
    modulus.map_or(f64::NAN, |modulus| modulus.at(layer, share, pile, height_m))
}

fn lateral_n_per_m2(pile: &Pile<'_>, index: usize, height_m: f64) -> f64 {
    let (layer, share) = pile.layer(index, height_m);
    let diameter_m = pile.diameter_m(height_m);
    match (&layer.soil, layer.model) {
        (LayerSoil::Table(rows), _) => secant_n_per_m2(rows, height_m),
        (LayerSoil::Rock(rock), _) => {
            let modulus_pa = rock
                .youngs_modulus_pa
                .map_or(f64::NAN, |pair| at(pair, share));
            let depth_m = pile.rock_surface_m(index) - height_m;
            weak_rock(modulus_pa, depth_m, diameter_m)
        }
        (_, SoilModel::Winkler) => winkler(elastic(pile, index, layer, height_m).0),
        (_, SoilModel::Vesic) => {
            let (modulus_pa, poissons_ratio) = elastic(pile, index, layer, height_m);
            let bending_n_m2 = pile.bending_n_m2(height_m);
            vesic(modulus_pa, poissons_ratio, diameter_m, bending_n_m2)
        }
        _ => match (Pisa::of(layer), &layer.soil) {
            (Some(pisa), _) => {
                let depth = pile.depth_m(height_m) / diameter_m;
                pisa.lateral(depth) * shear_modulus_pa(pile, index, height_m)
            }
            (None, LayerSoil::Sand(sand)) => of_sand(layer.model, sand, pile, height_m),
            (None, LayerSoil::Clay(clay)) => {
                let strength_n_per_m = clay_strength_n_per_m(pile, clay, share, height_m);
                of_clay(layer.model, clay, strength_n_per_m, diameter_m)
            }
            _ => f64::NAN,
        },
    }
}

fn of_sand(model: SoilModel, sand: &Sand, pile: &Pile<'_>, height_m: f64) -> f64 {
    let (depth_m, diameter_m) = (pile.overburden_depth_m(height_m), pile.diameter_m(height_m));
    let modulus_n_per_m3 = || subgrade_modulus_n_per_m3(sand, pile.ground.submerged);
    match model {
        SoilModel::Kallehave => kallehave(modulus_n_per_m3(), depth_m, diameter_m),
        SoilModel::Sorensen => {
            let angle_deg = sand.friction_angle_deg.unwrap_or(f64::NAN);
            sorensen(angle_deg, depth_m, diameter_m)
        }
        _ => modulus_n_per_m3() * depth_m,
    }
}

fn rotation_n(pile: &Pile<'_>, index: usize, height_m: f64) -> f64 {
    let Some(pisa) = Pisa::of(&pile.ground.layers[index]) else {
        return 0.0;
    };
    let diameter_m = pile.diameter_m(height_m);
    let factor = pisa.rotation(pile.depth_m(height_m) / diameter_m);
    match factor > 0.0 {
        true => factor * shear_modulus_pa(pile, index, height_m) * diameter_m * diameter_m,
        false => 0.0,
    }
}

fn clay_strength_n_per_m(pile: &Pile<'_>, clay: &Clay, share: f64, height_m: f64) -> f64 {
    let strength_pa = clay.undrained_strength_pa;
    matlock_strength(
        strength_pa.map_or(f64::NAN, |pair| at(pair, share)),
        pile.effective_stress_pa(height_m),
        clay.strength_factor.unwrap_or(f64::NAN),
        pile.depth_m(height_m),
        pile.diameter_m(height_m),
    )
}

fn of_clay(model: SoilModel, clay: &Clay, strength_n_per_m: f64, diameter_m: f64) -> f64 {
    let strain = clay.strain_at_half_strength.unwrap_or(f64::NAN);
    match model {
        SoilModel::Dnv => {
            let factor = clay.stiffness_factor.unwrap_or(f64::NAN);
            dnv_stiffness(factor, strength_n_per_m, strain, diameter_m)
        }
        SoilModel::ReeseStiffClay => reese_stiff_clay(strength_n_per_m, strain, diameter_m),
        _ => api_secant(strength_n_per_m, strain, diameter_m),
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

/// Whether the springs of a layer are linear in height between the knees of its model, for a pile
/// of constant diameter.
pub(super) fn are_linear(layer: &GroundLayer, axial: Option<AxialModel>) -> bool {
    let modulus = layer.shear_modulus.as_ref();
    let modulus_is_linear = modulus.is_some_and(|modulus| modulus.is_linear());
    let modulus_is_constant = modulus.is_some_and(|modulus| modulus.is_constant());
    let lateral = match (&layer.soil, layer.model) {
        (LayerSoil::Table(_), _) => true,
        (LayerSoil::Sand(_), SoilModel::Api | SoilModel::Dnv) => true,
        (LayerSoil::Rock(rock), _) => rock.youngs_modulus_pa.is_some_and(|[a, b]| a == b),
        (_, SoilModel::Winkler) => modulus_is_linear,
        _ => Pisa::of(layer).is_some() && modulus_is_constant,
    };
    let vertical = match axial {
        None | Some(AxialModel::Api) => true,
        Some(AxialModel::Kraft | AxialModel::RandolphWroth) => modulus_is_linear,
    };
    lateral && vertical
}

/// Whether the lateral springs of a layer do not depend on the diameter of the pile.
pub(super) fn ignore_diameter(layer: &GroundLayer, axial: Option<AxialModel>) -> bool {
    let is_sand = matches!(layer.soil, LayerSoil::Sand(Sand { .. }));
    let is_api = is_sand && matches!(layer.model, SoilModel::Api | SoilModel::Dnv);
    let is_table = matches!(layer.soil, LayerSoil::Table(_));
    axial.is_none() && (is_api || is_table || layer.model == SoilModel::Winkler)
}
