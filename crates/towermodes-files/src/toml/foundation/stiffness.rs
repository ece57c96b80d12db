//! `[foundation] type = "stiffness"`: matrices at the base.

use towermodes::{Foundation, StiffnessFoundation};

use super::super::tables::matrix::matrix;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, infinity, number};
use super::{Kind, Read, at};
use crate::toml::schema;

pub(super) const KIND: Kind = Kind {
    name: "stiffness",
    schema: &schema::STIFFNESS,
    nature: "the matrix contains the whole stiffness",
    read: Read::By(read),
};

fn read(table: &Table<'_>, reading: &mut Reading) -> Option<Foundation> {
    let hint = "six rows of six: the stiffness against x, y, z, rotation about x, y, z in N/m, N, N m; inf on the diagonal is rigid";
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

/// A finite number, or an infinite one for a fixed motion; the checks of the tower limit where it
/// is allowed.
fn stiffness_entry(value: &Value<'_>, what: &str, reading: &mut Reading) -> Option<f64> {
    infinity(value).or_else(|| number(value, what, reading))
}
