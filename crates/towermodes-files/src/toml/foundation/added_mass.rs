//! Added mass by frequency of a floating platform: a row for each frequency, from 0 to inf.

use std::sync::Arc;

use towermodes::AddedMassTable;
use towermodes::space::SpatialMatrix;

use super::super::text::reading::Reading;
use super::super::text::values::{Value, every_row, list, number, number_or_infinity, row_of};
use super::at;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// The key of the rows.
pub(super) const KEY: &str = "added_mass_by_frequency";

const HINT: &str = "a row has the angular frequency in rad/s and the upper triangle of the matrix row by row (21 numbers): [frequency, xx, xy, ...]; the first row is for the frequency 0, the last for inf";

/// The table made from some rows.
pub(super) fn table(value: &Value<'_>, reading: &mut Reading) -> Option<Arc<AddedMassTable>> {
    reading.remember(at(KEY), value.span());
    let rows = list(value, KEY, reading)?;
    let mut rows = every_row(rows, |index, row| {
        let what = format!("row {} of {KEY}", index + 1);
        let expected = |count| (count != 22).then(|| "22".to_owned());
        let values = row_of(row, &what, HINT, expected, reading)?;
        let frequency = number_or_infinity(&values[0], "the frequency", reading);
        let mut entries = values.iter().skip(1);
        let entries: Vec<Option<f64>> = entries
            .by_ref()
            .map(|entry| number(entry, "an entry of the added mass", reading))
            .collect();
        let entries: Vec<f64> = entries.into_iter().collect::<Option<_>>()?;
        Some((frequency?, of_triangle(&entries)))
    })?;
    let ends = rows.first().zip(rows.last());
    let has_both = ends.is_some_and(|(first, last)| first.0 == 0.0 && last.0 == f64::INFINITY);
    if !has_both || rows.len() < 2 {
        let what = "the added mass at frequency 0 and at frequency inf".to_owned();
        let missing = Diagnostic::new(value.span(), DiagnosticKind::Missing { what });
        return reading.refuse(missing.with_hint(HINT));
    }
    let (_, infinite) = rows.pop()?;
    let (_, zero) = rows.remove(0);
    Some(Arc::new(AddedMassTable {
        zero,
        rows,
        infinite,
    }))
}

/// The symmetric matrix from the entries on and above its diagonal.
fn of_triangle(entries: &[f64]) -> SpatialMatrix {
    let mut matrix = [[0.0; 6]; 6];
    let places = (0..6).flat_map(|i| (i..6).map(move |j| (i, j)));
    for ((i, j), entry) in places.zip(entries) {
        (matrix[i][j], matrix[j][i]) = (*entry, *entry);
    }
    matrix
}
