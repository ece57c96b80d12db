//! The assumptions on the foundation.

use towermodes::{
    BeamFormula, CircularFooting, FloatingPlatform, Foundation, RectangularFooting,
    StiffnessFoundation, SuctionCaisson, TowerDescription, WinklerPile,
};

use super::super::super::content::ReportContent;

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
    let description: &TowerDescription = &content.description;
    match &description.foundation {
        Foundation::Clamped => "The base is clamped: all six degrees of freedom are fixed.".to_owned(),
        Foundation::Springs(_) => springs(content),
        Foundation::Stiffness(foundation) => {
            format!("{}{}", springs(content), inertia(foundation))
        }
        Foundation::HalfSpace(_) => {
            "The base is a rigid circular footing on an elastic half-space, modelled by static, uncoupled springs (Arya, O'Neill & Pincus, 1979) \
             without damping and soil mass."
                .to_owned()
        }
        Foundation::CircularFooting(footing) => of_circular(footing),
        Foundation::RectangularFooting(footing) => of_rectangular(footing),
        Foundation::SuctionCaisson(_) => format!(
            "The base is the lid of a rigid suction caisson in elastic soil; its static stiffness follows from {}, without damping and inertia of \
             caisson and soil.{}",
            SuctionCaisson::FORMULA,
            held(content)
        ),
        Foundation::Monopile(pile) => format!(
            "The base is the head of a monopile in elastic soil; its static stiffness follows from {}, without damping and inertia of pile and soil.{}",
            pile.formula.name(),
            held(content)
        ),
        Foundation::WinklerPile(pile) => format!("{}{}", of_winkler_pile(pile), held(content)),
        Foundation::Floating(platform) => floating(platform),
    }
}

fn of_circular(footing: &CircularFooting) -> String {
    let soil = match (
        footing.stratum_thickness_m.is_finite(),
        footing.is_over_stratum(),
    ) {
        (false, _) => "an elastic half-space",
        (true, false) => "an elastic stratum over rock",
        (true, true) => "an elastic stratum over another one",
    };
    format!(
        "The base is a rigid circular footing on {soil}, modelled by static{} springs ({}) without damping and soil mass.",
        coupling(footing.is_coupled),
        CircularFooting::FORMULA
    )
}

fn of_rectangular(footing: &RectangularFooting) -> String {
    format!(
        "The base is a rigid rectangular footing on an elastic half-space, modelled by static{} springs ({}) without damping and soil mass.",
        coupling(footing.is_coupled),
        footing.formula.name()
    )
}

fn coupling(is_coupled: bool) -> &'static str {
    match is_coupled {
        true => ", coupled",
        false => ", uncoupled",
    }
}

fn of_winkler_pile(pile: &WinklerPile) -> String {
    let stiffness = match pile.formula {
        BeamFormula::Exact => "exact for the static beam without shear deformation".to_owned(),
        BeamFormula::PoulosDavis => format!("by {}", pile.formula.name()),
    };
    let springs = pile.soil_spring.formula_name();
    let springs = springs.map_or_else(String::new, |name| {
        format!("; the springs follow from Young's modulus of the soil by {name}")
    });
    format!(
        "The base is the head of an elastic pile on springs along its length, {stiffness}{springs}; damping and inertia of pile and soil are neglected."
    )
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

/// The degrees of freedom that are fixed.
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
        ref absent => format!(" The input has no {}.", absent.join(", no ")),
    };
    let frequency = if platform.added_mass.matrix == NONE {
        " is neglected"
    } else {
        " and the frequency dependence of the added mass are neglected"
    };
    format!("The base is a rigid floating platform{with}; radiation damping{frequency}.{without}")
}
