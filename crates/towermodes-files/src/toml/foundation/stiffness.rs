//! `[foundation] type = "stiffness"`: matrices at the base.

use towermodes::{Foundation, StiffnessFoundation};

use super::{Kind, at};
use crate::diagnostic::Diagnostic;
use crate::toml::Reading;
use crate::toml::matrix::matrix;
use crate::toml::table::{Keys, Table};
use crate::toml::values::{Value, infinity, number};

pub(super) const KIND: Kind = Kind {
    name: "stiffness",
    keys: Keys {
        known: &["type", "matrix", "mass"],
        planned: &[],
    },
    nature: "here the matrix says all",
    read,
};

fn read(table: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let hint =
        "six rows of six: the stiffness against x, y, z, rotation about x, y, z in N/m, N, N m";
    let stiffness = table.require("matrix", hint, reading).and_then(|value| {
        reading.remember(at("matrix"), value.span());
        matrix(value, "matrix", reading, stiffness_entry)
    });
    let inertia = table.get("mass").map_or(Some([[0.0; 6]; 6]), |value| {
        reading.remember(at("mass"), value.span());
        matrix(value, "mass", reading, number)
    });
    Some(Foundation::Stiffness(Box::new(StiffnessFoundation {
        stiffness: stiffness?,
        inertia: inertia?,
    })))
}

/// A rigid base is another type: a matrix does not say how infinite entries are coupled.
fn stiffness_entry(value: &Value<'_>, what: &str, reading: &mut Reading) -> Option<f64> {
    if infinity(value).is_none() {
        return number(value, what, reading);
    }
    let message = format!("{what} is infinite");
    let hint = "type = \"springs\" has springs that may be inf, and type = \"clamped\" is rigid";
    reading.mistake(Diagnostic::new(value.span(), message).with_hint(hint));
    None
}
