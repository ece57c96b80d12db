//! Rigid bodies: RNA and point masses, their centres and inertias.

use std::f64::consts::PI;

use super::Given;
use super::usual::{Usual, check_inputs};
use crate::tower::Warning;
use crate::tower::{Ineffective, Quantity, Site};
use crate::tower::{Inertia, Place, PointMass, Tower};

/// Largest distance of the centre of mass from the tower top along one axis, m: the largest
/// turbines have 15.
const CENTRE: Usual = Usual::at_most(Quantity::CentreDistance, 25.0);
/// The RNA has at least this fraction of the mass of the tower: with a wrong unit it has less than
/// a hundredth.
const RNA_SHARE: Usual = Usual::at_least(Quantity::RnaShare, 0.01);
/// A smaller point mass has no effect on a tower of [`LARGE_KG`]: its value is probably in t.
const POINT_MASS: Usual = Usual::at_least(Quantity::PointMass, 10.0);
/// A mass at a clamped base of at most this fraction of the mass of the tower is a base flange,
/// which lists of masses contain; a larger one is probably at another height.
const BASE_FLANGE: f64 = 0.05;
/// The mass of a large tower, kg.
const LARGE_KG: f64 = 20e3;
/// The mass of the RNA is at most this many times that of the tower.
const TOWERS: f64 = 5.0;
/// An RNA above this mass, kg, has inertias that affect second bending and torsion.
const HEAVY_KG: f64 = 50e3;
/// Radii of gyration are at most this fraction of the tower height: a rotor's is a third of its
/// radius, which is less than the height.
const REACH: f64 = 0.6;
/// No body has a larger mean density than lead, kg/m³.
const DENSEST_KG_PER_M3: f64 = 12e3;
/// A principal moment may exceed the sum of the others by this fraction: inertias are given with
/// two or three digits.
const ROUNDED: f64 = 0.01;

pub(super) fn check(tower: &Tower, given: &Given<'_>, warnings: &mut Vec<Warning>) {
    rna(tower, given, warnings);
    for (index, mass) in tower.point_masses().iter().enumerate() {
        point_mass(tower, index, mass, warnings);
    }
}

fn rna(tower: &Tower, given: &Given<'_>, warnings: &mut Vec<Warning>) {
    let rna = tower.rna();
    let at = |key| Site::at(Place::Rna { key });
    check_inputs(rna, |key| Place::Rna { key }, warnings);
    if rna.mass_kg == 0.0 {
        if rna.center_m != [0.0; 3] {
            let (site, what) = (at("center"), Ineffective::CentreOfNothing);
            warnings.push(Warning::NoEffect { site, what });
        }
        return;
    }
    RNA_SHARE.check(rna.mass_kg / tower.mass_kg(), at("mass"), warnings);
    let furthest_m = rna.center_m.iter().fold(0.0_f64, |a, x| a.max(x.abs()));
    CENTRE.check(furthest_m, at("center"), warnings);
    if rna.mass_kg > TOWERS * tower.mass_kg() {
        warnings.push(Warning::HeavyRna {
            site: at("mass"),
            rna_kg: rna.mass_kg,
            tower_kg: tower.mass_kg(),
        });
    }
    let has_inertia = rna.inertia_kg_m2 != Inertia::default();
    if rna.mass_kg > HEAVY_KG && !has_inertia && !given.rna_is_point {
        warnings.push(Warning::RnaWithoutInertia {
            site: at("inertia"),
            mass_kg: rna.mass_kg,
        });
    }
    let reach_m = REACH * tower.height_m();
    let first = warnings.len();
    inertia(
        rna.mass_kg,
        &rna.inertia_kg_m2,
        reach_m,
        at("inertia"),
        warnings,
    );
    if given.rna_inertia_is_partial {
        let of_inertia = warnings.split_off(first).into_iter();
        warnings.extend(of_inertia.filter(|w| !matches!(w, Warning::TriangleInequality { .. })));
    }
}

fn point_mass(tower: &Tower, index: usize, mass: &PointMass, warnings: &mut Vec<Warning>) {
    let at = |key| Site::at(Place::PointMass { index, key });
    check_inputs(mass, |key| Place::PointMass { index, key }, warnings);
    let has_inertia = mass.inertia_kg_m2 != Inertia::default();
    let moves = &tower.base().moves;
    let moves = if has_inertia { &moves[..] } else { &moves[..3] };
    let is_flange = (f64::MIN_POSITIVE..=BASE_FLANGE * tower.mass_kg()).contains(&mass.mass_kg);
    if mass.mass_kg == 0.0 && !has_inertia {
        let (site, what) = (at("mass"), Ineffective::EmptyPointMass);
        warnings.push(Warning::NoEffect { site, what });
    } else if mass.height_m == tower.base_m() && !moves.contains(&true) && !is_flange {
        let (site, what) = (at("height"), Ineffective::MassAtClampedBase);
        warnings.push(Warning::NoEffect { site, what });
    } else if mass.mass_kg == 0.0 {
        let site = at("mass");
        warnings.push(Warning::InertiaWithoutMass { site });
    }
    if mass.mass_kg > 0.0 && !has_inertia && tower.mass_kg() > LARGE_KG {
        POINT_MASS.check(mass.mass_kg, at("mass"), warnings);
    }
    let reach_m = REACH * tower.height_m();
    inertia(
        mass.mass_kg,
        &mass.inertia_kg_m2,
        reach_m,
        at("inertia"),
        warnings,
    );
}

/// Whether a body of this mass (kg) and size (m) can have an inertia.
pub(crate) fn inertia(
    mass_kg: f64,
    inertia: &Inertia,
    reach_m: f64,
    site: Site,
    warnings: &mut Vec<Warning>,
) {
    if *inertia == Inertia::default() {
        return;
    }
    let [least_kg_m2, middle_kg_m2, largest_kg_m2] = inertia.principal_kg_m2();
    let others_kg_m2 = least_kg_m2 + middle_kg_m2;
    // For a flat disc both sides are equal.
    if largest_kg_m2 > others_kg_m2 * (1.0 + ROUNDED) {
        warnings.push(Warning::TriangleInequality {
            site,
            largest_kg_m2,
            others_kg_m2,
        });
    }
    if mass_kg == 0.0 {
        return;
    }
    let ball_m = radius_of_ball_m(mass_kg);
    // A body that is heavier than a ball of lead of its size gets another warning; then there is no
    // range.
    let usual = match ball_m < reach_m {
        true => Usual::new(Quantity::RadiusOfBody, ball_m, reach_m),
        false => Usual::at_least(Quantity::RadiusOfBody, ball_m),
    };
    // Of all bodies of one mass and density a ball has the smallest sum of principal moments.
    let mean_m = ((least_kg_m2 + middle_kg_m2 + largest_kg_m2) / (3.0 * mass_kg)).sqrt();
    let largest_m = (largest_kg_m2 / mass_kg).sqrt();
    let value_m = if mean_m < ball_m { mean_m } else { largest_m };
    usual.check(value_m, site, warnings);
}

/// Radius of gyration of a ball of lead of a mass (kg), m: √(2/5) R with m = ρ 4π/3 R³.
fn radius_of_ball_m(mass_kg: f64) -> f64 {
    let radius_m = (3.0 * mass_kg / (4.0 * PI * DENSEST_KG_PER_M3)).cbrt();
    0.4_f64.sqrt() * radius_m
}
