//! A comparison of methods, and the convergence of one method, as CSV.

use std::io::Write;

use towermodes_analysis::study::{Column, Comparison, Convergence, FollowedMode, Level};

use super::{ResultError, write_records_csv};

const COMPARISON: [&str; 11] = [
    "method",
    "segments",
    "degree",
    "degrees_of_freedom",
    "seconds_per_solve",
    "family",
    "order",
    "label",
    "is_pair",
    "frequency_hz",
    "relative_difference",
];

const CONVERGENCE: [&str; 12] = [
    "method",
    "segments",
    "degree",
    "degrees_of_freedom",
    "family",
    "order",
    "label",
    "is_pair",
    "frequency_hz",
    "limit_hz",
    "relative_error",
    "observed_order",
];

/// Writes a comparison as CSV: one line per method and mode.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_comparison_csv(
    comparison: &Comparison,
    writer: impl Write,
) -> Result<(), ResultError> {
    let row = |column: &Column, index: usize| {
        let [family, order, label, is_pair] = identity(&comparison.modes[index]);
        [
            column.method.name().to_owned(),
            column.segments.to_string(),
            or_empty(column.degree),
            column.degrees_of_freedom.to_string(),
            scientific(column.seconds_per_solve),
            family,
            order,
            label,
            is_pair,
            or_empty(column.frequencies_hz[index]),
            scientific(column.relative_differences[index]),
        ]
    };
    let modes = comparison.modes.len();
    let columns = comparison.columns.iter();
    let rows = columns.flat_map(|column| (0..modes).map(move |index| row(column, index)));
    write_records_csv(COMPARISON, rows, writer)
}

/// Writes the convergence of a method as CSV: one line per level and mode.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_convergence_csv(
    convergence: &Convergence,
    writer: impl Write,
) -> Result<(), ResultError> {
    let row = |level: &Level, index: usize| {
        let mode = &convergence.modes[index];
        let [family, order, label, is_pair] = identity(mode);
        [
            convergence.method.name().to_owned(),
            level.segments.to_string(),
            or_empty(level.asked.degree()),
            level.degrees_of_freedom.to_string(),
            family,
            order,
            label,
            is_pair,
            or_empty(level.frequencies_hz[index]),
            mode.frequency_hz.to_string(),
            scientific(level.errors[index]),
            or_empty(level.orders[index]),
        ]
    };
    let modes = convergence.modes.len();
    let levels = convergence.levels.iter();
    let rows = levels.flat_map(|level| (0..modes).map(move |index| row(level, index)));
    write_records_csv(CONVERGENCE, rows, writer)
}

/// Family, order, label and whether the mode is a pair.
fn identity(mode: &FollowedMode) -> [String; 4] {
    [
        mode.family.name().to_owned(),
        mode.order.to_string(),
        mode.label.clone(),
        mode.is_pair.to_string(),
    ]
}

fn or_empty(value: Option<impl ToString>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn scientific(value: Option<f64>) -> String {
    or_empty(value.map(|value| format!("{value:e}")))
}
