//! `[foundation]`.

use super::Reading;
use super::table::{Keys, Table};
use super::values::{Value, text};
use crate::diagnostic::Diagnostic;

const FOUNDATION: Keys = Keys {
    known: &["type"],
    planned: &[
        "matrix",
        "mass",
        "lateral",
        "rocking",
        "coupling",
        "vertical",
        "torsion",
        "radius",
        "embedment",
        "soil_shear_modulus",
        "soil_poissons_ratio",
    ],
};

/// The base is clamped; anything else is refused until it is computed with.
pub(super) fn check_foundation(root: &Table<'_>, reading: &mut Reading) {
    if let Some(value) = root.get("foundation") {
        check_type(value, reading);
    }
}

fn check_type(value: &Value<'_>, reading: &mut Reading) -> Option<()> {
    let table = Table::of(value, "[foundation]", &FOUNDATION, reading)?;
    let value = table.require("type", "type = \"clamped\"", reading)?;
    let name = text(value, "the foundation's type", reading)?;
    if name == "clamped" {
        return Some(());
    }
    let planned = ["stiffness", "springs", "half-space", "floating"].contains(&name);
    let message = if planned {
        format!("this version does not compute with a foundation of type `{name}`")
    } else {
        format!("there is no foundation of type `{name}`")
    };
    reading.mistake(
        Diagnostic::new(value.span(), message).with_hint("this version knows \"clamped\""),
    );
    None
}
