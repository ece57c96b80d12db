//! `[[wires]]`.

use towermodes::{Place, Wires};

use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::{Table, every_table, with_names};
use super::super::text::values::{Value, number};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::places::TABLE;

/// All `[[wires]]` with their names.
pub(crate) fn wires(root: &Table<'_>, reading: &mut Reading) -> Option<(Vec<Wires>, Vec<String>)> {
    with_names(every_table(
        root,
        "wires",
        "set of wires",
        reading,
        set_of_wires,
    ))
}

fn set_of_wires(index: usize, value: &Value<'_>, reading: &mut Reading) -> Option<(Wires, String)> {
    let at = |key| Place::Wires { index, key };
    reading.remember(at(TABLE), value.span());
    let table = Table::of(value, "[[wires]]", &schema::WIRES, reading)?;
    let name = table.name_of("a name of wires", reading);
    let hint = "height of their upper ends in m, in the datum of the stations";
    let height = table.required_number("height", hint, at("height"), reading);
    let count = table
        .require("count", "number of equally spaced wires", reading)
        .and_then(|value| count(value, at("count"), reading));
    let hint = "EA/L of each wire in N/m";
    let stiffness = table.required_number("stiffness", hint, at("stiffness"), reading);
    let hint = "angle from the horizontal in degrees";
    let angle = table.required_number("angle_deg", hint, at("angle"), reading);
    // The stiffness of three or more equally spaced wires does not depend on their azimuth.
    table.number_or(0.0, "azimuth_deg", at("azimuth"), reading)?;
    let wires = Wires {
        height_m: height?,
        count: count?,
        stiffness_n_per_m: stiffness?,
        angle_deg: angle?,
    };
    Some((wires, name?))
}

/// A number of wires; the checks of the tower limit it.
fn count(value: &Value<'_>, place: Place, reading: &mut Reading) -> Option<usize> {
    reading.remember(place, value.span());
    let count = number(value, "count", reading)?;
    if count.fract() == 0.0 && (1.0..=1e9).contains(&count) {
        return Some(count as usize);
    }
    let kind = DiagnosticKind::out_of_range("count", count, "a whole number of at least 3");
    reading.refuse(Diagnostic::new(value.span(), kind))
}
