//! The centre of mass and the inertia of rigid bodies.

use towermodes::{Inertia, Place};

use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, list, number};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// `[x, y, z]`; the hint gives the reference point.
pub(crate) fn center(
    value: &Value<'_>,
    hint: &str,
    place: Place,
    reading: &mut Reading,
) -> Option<[f64; 3]> {
    reading.remember(place, value.span());
    let values = list(value, "center", reading)?;
    if values.len() != 3 {
        let kind = DiagnosticKind::wrong_count("center", values.len(), 3);
        return reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint));
    }
    let mut coordinate =
        |index: usize| number(&values[index], "a coordinate of the centre", reading);
    let (x, y, z) = (coordinate(0), coordinate(1), coordinate(2));
    Some([x?, y?, z?])
}

/// The table of an inertia; entries that are left out and not required are zero.
pub(crate) fn inertia(
    value: &Value<'_>,
    required: &[&str],
    place: Place,
    reading: &mut Reading,
) -> Option<Inertia> {
    reading.remember(place, value.span());
    let table = Table::of(value, "inertia", &schema::INERTIA, reading)?;
    let entry = |key: &str| {
        let value = match required.contains(&key) {
            true => Some(table.require(key, "kg m2, about the centre of mass", reading)?),
            false => table.get(key),
        };
        value.map_or(Some(0.0), |value| {
            number(value, &format!("inertia {key}"), reading)
        })
    };
    let [xx, yy, zz, xy, xz, yz] = ["xx", "yy", "zz", "xy", "xz", "yz"].map(entry);
    Some([xx?, yy?, zz?, xy?, xz?, yz?].into())
}

/// The inertia of a table that may have one.
pub(crate) fn inertia_if_any(
    table: &Table<'_>,
    place: Place,
    reading: &mut Reading,
) -> Option<Inertia> {
    match table.get("inertia") {
        Some(value) => inertia(value, &[], place, reading),
        None => Some(Inertia::default()),
    }
}
