//! A comparison of methods as JSON and as CSV.

use std::io::Write;
use std::time::Duration;

use schemars::JsonSchema;
use serde::Serialize;
use towermodes_analysis::study::{Column, Comparison, FollowedMode};

use super::{ResultError, write_pretty};

/// The result of `towermodes compare --format json`. Keys are stable: new ones may be added, none
/// is renamed.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "towermodes comparison")]
pub(super) struct ComparisonJson {
    /// The modes, each an entry of every method's lists; of a repeated pair the fore-aft one stands
    /// for both.
    modes: Vec<FollowedModeJson>,
    /// What each method makes of them.
    methods: Vec<MethodJson>,
}

/// A mode that is followed from method to method.
#[derive(Serialize, JsonSchema)]
pub(super) struct FollowedModeJson {
    /// `fore-aft`, `side-side`, `torsion` or `axial`.
    family: &'static str,
    /// Order within the family, from 1.
    order: usize,
    /// What it is called, as "1st bending".
    label: String,
    /// Whether the side-side mode of this order has the same frequency.
    is_pair: bool,
    /// The frequency of the spectral beam, Hz.
    frequency_hz: f64,
}

/// What one method makes of the tower.
#[derive(Serialize, JsonSchema)]
struct MethodJson {
    /// The method, by its name on the command line.
    method: &'static str,
    /// Number of segments, or of elements.
    segments: usize,
    /// Polynomial degree of the elements of the spectral beam; null for other methods.
    degree: Option<usize>,
    /// Degrees of freedom of the whole tower.
    degrees_of_freedom: usize,
    /// The fastest of several solves with all that `solve` gives, s.
    seconds_per_solve: f64,
    /// The frequency of each mode, Hz; null where so few segments do not have it.
    frequencies_hz: Vec<Option<f64>>,
    /// f/f_spectral − 1 of each mode.
    relative_differences: Vec<Option<f64>>,
}

pub(super) fn followed(mode: &FollowedMode) -> FollowedModeJson {
    FollowedModeJson {
        family: mode.family.name(),
        order: mode.order,
        label: mode.label(),
        is_pair: mode.is_pair,
        frequency_hz: mode.frequency_hz,
    }
}

/// Writes a comparison, with the time a solve of each column takes, as indented JSON.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_comparison_json(
    comparison: &Comparison,
    times: &[Duration],
    writer: impl Write,
) -> Result<(), ResultError> {
    let method = |(column, time): (&Column, &Duration)| MethodJson {
        method: column.method.name(),
        segments: column.segments,
        degree: column.degree,
        degrees_of_freedom: column.degrees_of_freedom,
        seconds_per_solve: time.as_secs_f64(),
        frequencies_hz: column.frequencies_hz.clone(),
        relative_differences: (0..comparison.modes.len())
            .map(|mode| comparison.relative_difference(column, mode))
            .collect(),
    };
    let json = ComparisonJson {
        modes: comparison.modes.iter().map(followed).collect(),
        methods: comparison.columns.iter().zip(times).map(method).collect(),
    };
    write_pretty(&json, writer)
}

/// Writes a comparison as CSV: one line a method and mode.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_comparison_csv(
    comparison: &Comparison,
    times: &[Duration],
    writer: impl Write,
) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record([
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
    ])?;
    let or_empty = |value: Option<String>| value.unwrap_or_default();
    for (column, time) in comparison.columns.iter().zip(times) {
        for (index, mode) in comparison.modes.iter().enumerate() {
            let difference = comparison.relative_difference(column, index);
            csv.write_record([
                column.method.name().to_owned(),
                column.segments.to_string(),
                or_empty(column.degree.map(|degree| degree.to_string())),
                column.degrees_of_freedom.to_string(),
                format!("{:e}", time.as_secs_f64()),
                mode.family.name().to_owned(),
                mode.order.to_string(),
                mode.label(),
                mode.is_pair.to_string(),
                or_empty(column.frequencies_hz[index].map(|f| f.to_string())),
                or_empty(difference.map(|difference| format!("{difference:e}"))),
            ])?;
        }
    }
    csv.flush()?;
    Ok(())
}
