//! Errors of the library in the values of a turbine, at the place of the value in the file.

use towermodes::BladeError;
use towermodes::turbine::{TurbineDescription, TurbineError};

use super::spans::Spans;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// The quantities of the library and the keys with their values.
const QUANTITIES: [(&str, &str); 18] = [
    ("the overhang", "overhang"),
    ("the height of the shaft", "tower_to_shaft"),
    ("the tilt of the shaft", "tilt_deg"),
    ("the cone of the blades", "cone_deg"),
    ("the stiffness of the yaw drive", "yaw_stiffness"),
    ("the stiffness of the shaft", "shaft_stiffness"),
    ("the mass of the yaw bearing", "yaw_bearing_mass"),
    ("the inertia of the generator", "generator_inertia"),
    ("the inertia of a free generator", "generator_inertia"),
    ("the gear ratio", "gear_ratio"),
    ("the mass of the nacelle", "nacelle.mass"),
    ("a coordinate of the nacelle's centre", "nacelle.center"),
    ("an inertia of the nacelle", "nacelle.inertia"),
    (
        "the least principal inertia of the nacelle",
        "nacelle.inertia",
    ),
    ("the mass of the hub", "hub.mass"),
    ("the distance of the hub's centre", "hub.offset"),
    ("the hub's inertia about the shaft", "hub.polar_inertia"),
    (
        "the hub's inertia across the shaft",
        "hub.transverse_inertia",
    ),
];

/// The quantities of a blade section and their keys.
const OF_SECTIONS: [(&str, &str); 8] = [
    ("the mass per length", "blade.mass_kg_per_m"),
    ("the flap stiffness", "blade.ei_flap_n_m2"),
    ("the edge stiffness", "blade.ei_edge_n_m2"),
    ("the axial stiffness", "blade.ea_n"),
    ("the torsional stiffness", "blade.gj_n_m2"),
    ("the sum of both inertias", "blade.flap_inertia_kg_m"),
    ("the flap inertia", "blade.flap_inertia_kg_m"),
    ("the edge inertia", "blade.edge_inertia_kg_m"),
];

/// An error of the library at the place of the value that it is about.
pub(super) fn mistake(
    error: TurbineError,
    turbine: &TurbineDescription,
    spans: &Spans,
) -> Diagnostic {
    let (name, index) = place(&error, turbine);
    Diagnostic::new(
        spans.find(name, index),
        DiagnosticKind::Turbine(Box::new(error)),
    )
}

/// The key of a value and its index in a list.
fn place(error: &TurbineError, turbine: &TurbineDescription) -> (&'static str, Option<usize>) {
    match error {
        TurbineError::Rotor(_) => ("blades", None),
        TurbineError::Generator { .. } => ("generator_inertia", None),
        TurbineError::Blade(error) => in_blade(error, turbine),
        TurbineError::NotFinite { quantity, .. }
        | TurbineError::Negative { quantity, .. }
        | TurbineError::NotPositive { quantity, .. }
        | TurbineError::Angle { quantity, .. } => (key_of(&QUANTITIES, quantity, ""), None),
        _ => ("", None),
    }
}

fn in_blade(error: &BladeError, turbine: &TurbineDescription) -> (&'static str, Option<usize>) {
    match error {
        BladeError::NotPositive {
            quantity, section, ..
        }
        | BladeError::Negative {
            quantity, section, ..
        }
        | BladeError::RigidInSomeSections {
            quantity, section, ..
        } => (key_of(&OF_SECTIONS, quantity, "blade"), Some(*section)),
        BladeError::CenterOfMass {
            section,
            edge_inertia_kg_m,
            ..
        } => {
            // Without a list of inertias the offset is what is there.
            let key = match *edge_inertia_kg_m == 0.0 {
                true => "blade.center_of_mass_m",
                false => "blade.edge_inertia_kg_m",
            };
            (key, Some(*section))
        }
        BladeError::TensionCenter { section, .. } => ("blade.tension_center_m", Some(*section)),
        BladeError::NoLength { .. } => ("blade.tip_radius", None),
        BladeError::NegativeTip { .. } => ("blade.tip_mass", None),
        BladeError::NotWhole { .. } => ("blade.span", None),
        BladeError::NotRising { span, .. } => {
            let pairs = turbine.blade.sections.windows(2);
            let mut falls = pairs.map(|pair| pair[1].span < pair[0].span && pair[1].span == *span);
            (
                "blade.span",
                falls.position(|falls| falls).map(|index| index + 1),
            )
        }
        _ => ("blade", None),
    }
}

fn key_of(keys: &[(&str, &'static str)], quantity: &str, otherwise: &'static str) -> &'static str {
    let mut keys = keys.iter();
    let found = keys.find(|(of_library, _)| *of_library == quantity);
    found.map_or(otherwise, |(_, key)| key)
}
