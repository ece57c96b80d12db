//! Matrices for motions (x, y, z, rotation about x, y, z) of a point.

use towermodes::space::SpatialMatrix;

use super::super::text::reading::Reading;
use super::super::text::values::{Value, every_row, list};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

const HINT: &str =
    "a matrix is six rows of six numbers, in the order x, y, z, rotation about x, y, z";

/// Six rows of six entries; `entry` reads one entry, whose name in messages is given.
pub(crate) fn matrix(
    value: &Value<'_>,
    what: &str,
    reading: &mut Reading,
    entry: fn(&Value<'_>, &str, &mut Reading) -> Option<f64>,
) -> Option<SpatialMatrix> {
    let rows = list(value, what, reading)?;
    if rows.len() != 6 {
        let kind = DiagnosticKind::wrong_count_of("rows", what, rows.len(), 6);
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(HINT));
    }
    let rows = every_row(rows, |index, row| {
        let what = format!("row {} of {what}", index + 1);
        self::row(row, &what, reading, entry)
    });
    rows?.try_into().ok()
}

fn row(
    value: &Value<'_>,
    what: &str,
    reading: &mut Reading,
    entry: fn(&Value<'_>, &str, &mut Reading) -> Option<f64>,
) -> Option<[f64; 6]> {
    let entries = list(value, what, reading)?;
    if entries.len() != 6 {
        let kind = DiagnosticKind::wrong_count(what, entries.len(), 6);
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(HINT));
    }
    let entries = every_row(entries, |index, value| {
        entry(value, &format!("{what}, column {},", index + 1), reading)
    });
    entries?.try_into().ok()
}
