//! What the tower's base is taken to stand on.

use towermodes::{FloatingPlatform, Foundation, StiffnessFoundation, TowerDescription};

use super::super::super::content::ReportContent;

/// The motions of a base, as they are held.
const MOTIONS: [&str; 6] = [
    "x",
    "y",
    "z",
    "rotation about x",
    "rotation about y",
    "rotation about z",
];
const NONE: [[f64; 6]; 6] = [[0.0; 6]; 6];

/// What holds the base, what moves with it and what is left out of both.
pub(super) fn foundation(content: &ReportContent) -> String {
    let description: &TowerDescription = &content.description;
    match &description.foundation {
        Foundation::Clamped => "The base is clamped: it neither moves nor turns.".to_owned(),
        Foundation::Springs(_) => springs(content),
        Foundation::Stiffness(foundation) => {
            format!("{}{}", springs(content), inertia(foundation))
        }
        Foundation::HalfSpace(_) => {
            "The base stands on a rigid circular footing on an elastic half-space: static, uncoupled springs (Arya, O'Neill & Pincus, 1979), \
             without damping and without soil that moves along."
                .to_owned()
        }
        Foundation::Floating(platform) => floating(platform),
    }
}

fn springs(content: &ReportContent) -> String {
    let base = content.tower.base();
    if base.is_clamped() {
        return "The base is clamped: every spring of the foundation is rigid.".to_owned();
    }
    let held = |(name, moves): (&&'static str, &bool)| (!moves).then_some(*name);
    let held: Vec<&str> = MOTIONS.iter().zip(&base.moves).filter_map(held).collect();
    let rigidly = match held.len() {
        0 => String::new(),
        _ => format!(" It is rigidly held in {}.", held.join(", ")),
    };
    let what = if base.stiffness == NONE {
        "The foundation has no springs against the motions of the base that are possible."
    } else {
        "The base stands on linear springs without damping that do not depend on frequency."
    };
    format!("{what}{rigidly}")
}

fn inertia(foundation: &StiffnessFoundation) -> &'static str {
    if foundation.inertia == NONE {
        return "";
    }
    " The foundation's own inertia moves with the base, constant at all frequencies."
}

fn floating(platform: &FloatingPlatform) -> String {
    let parts = [
        (&platform.added_mass, "constant added mass"),
        (&platform.hydrostatic, "hydrostatic stiffness"),
        (&platform.mooring, "linear moorings"),
    ];
    let of = |is_there: bool| {
        let those = parts.iter().filter(|(m, _)| (m.matrix != NONE) == is_there);
        those.map(|(_, name)| *name).collect::<Vec<&str>>()
    };
    let with = match of(true)[..] {
        [] => String::new(),
        ref there => format!(" with {}", there.join(", ")),
    };
    let without = match of(false)[..] {
        [] => String::new(),
        ref absent => format!(" The input gives it no {}.", absent.join(", no ")),
    };
    let frequency = if platform.added_mass.matrix == NONE {
        " is left out"
    } else {
        " and the dependence of added mass on frequency are left out"
    };
    format!(
        "The base stands on a rigid floating platform{with}; radiation damping{frequency}.{without}"
    )
}
