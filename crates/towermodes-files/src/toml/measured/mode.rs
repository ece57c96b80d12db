//! `[[measured]]`: one measured frequency with its mode.

use super::super::study::mode_name;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, every_row, list, number, row_of};
use super::schema::MEASURED;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::measured::MeasuredMode;

const SHAPE: &str = "a row of a shape is [height in m, fore-aft displacement, side-side displacement], with any common factor";

/// One measurement.
pub(super) fn mode(_: usize, value: &Value<'_>, reading: &mut Reading) -> Option<MeasuredMode> {
    let table = Table::of(value, MEASURED.name, &MEASURED, reading)?;
    let mode = match table.get("mode") {
        None => Some(None),
        Some(mode) => mode_name(mode, reading).map(Some),
    };
    let hint = "give the measured frequency in Hz, for example frequency = 0.2585";
    let frequency = positive(&table, "frequency", hint, reading);
    let hint = "give the standard deviation of the frequency in Hz, for example deviation = 0.002";
    let deviation = positive(&table, "deviation", hint, reading);
    let shape = match table.get("shape") {
        None => Some(Vec::new()),
        Some(value) => shape(value, reading),
    };
    Some(MeasuredMode {
        mode: mode?,
        frequency_hz: frequency?,
        deviation_hz: deviation?,
        shape: shape?,
        span: value.span(),
    })
}

/// A required positive number.
fn positive(table: &Table<'_>, key: &str, hint: &str, reading: &mut Reading) -> Option<f64> {
    let value = table.require(key, hint, reading)?;
    let found = number(value, key, reading)?;
    if found > 0.0 {
        return Some(found);
    }
    let kind = DiagnosticKind::out_of_range(key, found, "positive");
    reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
}

/// The displacements at some heights.
fn shape(value: &Value<'_>, reading: &mut Reading) -> Option<Vec<[f64; 3]>> {
    let rows = list(value, "shape", reading)?;
    let rows: Vec<[f64; 3]> = every_row(rows, |index, row| {
        let what = format!("row {} of the shape", index + 1);
        let expected = |count| (count != 3).then(|| "3".to_owned());
        let values = row_of(row, &what, SHAPE, expected, reading)?;
        let numbers = every_row(values, |_, value| number(value, &what, reading))?;
        numbers.try_into().ok()
    })?;
    let is_moved = |row: &[f64; 3]| row[1] != 0.0 || row[2] != 0.0;
    if rows.iter().any(is_moved) {
        return Some(rows);
    }
    let what = "a displacement other than 0 in the shape".to_owned();
    let mistake = Diagnostic::new(value.span(), DiagnosticKind::Missing { what });
    reading.refuse(mistake.with_hint(SHAPE))
}
