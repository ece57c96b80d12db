//! `[rotor]`.

use towermodes::tower::MOST_BLADES;
use towermodes::{Place, Rotor};

use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, list, number, wrong_kind};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::places::TABLE;

const HINT: &str =
    "lowest and highest operating speed, rpm = [6.9, 12.1], or one number for a constant speed";

/// The rotor: `Some(None)` if there is none, `None` after a mistake.
pub(crate) fn rotor(root: &Table<'_>, reading: &mut Reading) -> Option<Option<Rotor>> {
    let Some(value) = root.get("rotor") else {
        return Some(None);
    };
    let at = |key| Place::Rotor { key };
    reading.remember(at(TABLE), value.span());
    let table = Table::of(value, "[rotor]", &schema::ROTOR, reading)?;
    let blades = table
        .require("blades", "number of blades, for example 3", reading)
        .and_then(|value| {
            reading.remember(at("blades"), value.span());
            blades(value, 1, reading)
        });
    let speeds = table.require("rpm", HINT, reading).and_then(|value| {
        reading.remember(at("rpm"), value.span());
        speeds_rpm(value, reading)
    });
    let (blades, [lowest_rpm, highest_rpm]) = (blades?, speeds?);
    Some(Some(Rotor {
        blades,
        lowest_rpm,
        highest_rpm,
    }))
}

/// An integer number of blades; its limits are checked by the tower, and by the turbine, whose
/// rotor has at least `least` blades.
pub(crate) fn blades(value: &Value<'_>, least: usize, reading: &mut Reading) -> Option<usize> {
    let count = number(value, "blades", reading)?;
    if count.fract() == 0.0 && (0.0..=1e9).contains(&count) {
        return Some(count as usize);
    }
    let rule = format!("a whole number from {least} to {MOST_BLADES}");
    let kind = DiagnosticKind::out_of_range("blades", count, rule);
    reading.refuse(Diagnostic::new(value.span(), kind))
}

/// One number, or a list of the lowest and the highest speed.
fn speeds_rpm(value: &Value<'_>, reading: &mut Reading) -> Option<[f64; 2]> {
    if value.get_ref().as_array().is_none() {
        if value.get_ref().is_table() {
            let diagnostic = wrong_kind(value, "rpm", "a number or a list of two");
            return reading.refuse(diagnostic.with_hint(HINT));
        }
        return number(value, "rpm", reading).map(|rpm| [rpm, rpm]);
    }
    let speeds = list(value, "rpm", reading)?;
    let [lowest, highest] = &speeds[..] else {
        let kind = DiagnosticKind::wrong_count("rpm", speeds.len(), 2);
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(HINT));
    };
    let lowest = number(lowest, "the lowest rpm", reading);
    let highest = number(highest, "the highest rpm", reading);
    Some([lowest?, highest?])
}
