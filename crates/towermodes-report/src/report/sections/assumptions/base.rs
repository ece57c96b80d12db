//! The assumptions on the foundation.

use towermodes::{FloatingPlatform, ReferredMatrix, StiffnessFoundation, Support, Tower};

use super::super::super::content::ReportContent;
use super::super::substructure;

/// The degrees of freedom of the base.
const MOTIONS: [&str; 6] = [
    "x",
    "y",
    "z",
    "rotation about x",
    "rotation about y",
    "rotation about z",
];
const NONE: [[f64; 6]; 6] = [[0.0; 6]; 6];

/// Stiffness and inertia of the foundation, and the effects they neglect.
pub(super) fn foundation(content: &ReportContent) -> String {
    match content.description.foundation.support() {
        Support::Clamped => "The base is clamped: all six degrees of freedom are fixed.".to_owned(),
        Support::Springs(_) => springs(content),
        Support::Stiffness(foundation) => {
            format!("{}{}", springs(content), inertia(foundation))
        }
        Support::Floating(platform) => floating(platform, &content.tower),
        Support::Frame(foundation) => substructure::assumption(foundation),
        Support::Form(form) => format!("{}{}", form.assumption(), held(content)),
    }
}

fn springs(content: &ReportContent) -> String {
    let base = content.tower.base();
    if base.is_clamped() {
        return "The base is clamped: every spring of the foundation is rigid.".to_owned();
    }
    let rigidly = held(content);
    let what = if base.stiffness == NONE {
        "The free motions of the base have no foundation stiffness."
    } else {
        "The base rests on linear springs, independent of frequency and without damping."
    };
    format!("{what}{rigidly}")
}

/// The text on the degrees of freedom that are fixed.
fn held(content: &ReportContent) -> String {
    let moves = content.tower.base().moves;
    let held = |(name, moves): (&&'static str, &bool)| (!moves).then_some(*name);
    let held: Vec<&str> = MOTIONS.iter().zip(&moves).filter_map(held).collect();
    match held.len() {
        0 => String::new(),
        _ => format!(" Fixed degrees of freedom: {}.", held.join(", ")),
    }
}

fn inertia(foundation: &StiffnessFoundation) -> &'static str {
    if foundation.inertia == NONE {
        return "";
    }
    " The inertia of the foundation moves with the base and does not depend on frequency."
}

fn floating(given_platform: &FloatingPlatform, tower: &Tower) -> String {
    let linear = tower.linear_platform();
    let platform = &linear.unwrap_or_else(|| given_platform.clone());
    let given = |matrix: &ReferredMatrix| matrix.matrix != NONE;
    let is_moored = given(&platform.mooring);
    let by_frequency = platform.added_mass_by_frequency.is_some();
    let added_mass = match by_frequency {
        true => "added mass by frequency",
        false => "constant added mass",
    };
    let parts = [
        (by_frequency || given(&platform.added_mass), added_mass),
        (given(&platform.hydrostatic), "hydrostatic stiffness"),
        (is_moored, "linear moorings"),
    ];
    let of = |is_there: bool| {
        let those = parts.iter().filter(|(given, _)| *given == is_there);
        those.map(|(_, name)| *name).collect::<Vec<&str>>()
    };
    let with = match of(true)[..] {
        [] => String::new(),
        ref there => format!(" with {}", there.join(", ")),
    };
    let without = match of(false)[..] {
        [] => String::new(),
        ref absent => format!(" The input has no {}.", absent.join(", no ")),
    };
    let frequency = if by_frequency || platform.added_mass.matrix == NONE {
        " is neglected"
    } else {
        " and the frequency dependence of the added mass are neglected"
    };
    let lines = match (&given_platform.mooring_lines, given_platform.at_equilibrium) {
        (Some(_), false) => {
            " The mooring lines are quasi-static: their stiffness applies to the reference position, and their mass is neglected."
        }
        (Some(_), true) => {
            " The mooring lines are quasi-static: their stiffness applies to the equilibrium of weights, buoyancy and lines without wind, and their mass is neglected."
        }
        (None, _) => "",
    };
    format!(
        "The base is a rigid floating platform{with}; radiation damping{frequency}.{without}{lines}"
    )
}
