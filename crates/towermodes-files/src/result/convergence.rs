//! How a method converges, as JSON and as CSV.

use std::io::Write;

use schemars::JsonSchema;
use serde::Serialize;
use towermodes_analysis::study::{Convergence, Fineness, Level};

use super::comparison::{FollowedModeJson, followed};
use super::{ResultError, write_pretty};

/// The result of `towermodes converge --format json`. Keys are stable: new ones may be added, none
/// is renamed.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "towermodes convergence")]
pub(super) struct ConvergenceJson {
    /// The method, by its name on the command line.
    method: &'static str,
    /// Whether the beam it converges to has rotary inertia in bending.
    limit_has_rotary_inertia: bool,
    /// The modes with the frequencies they converge to, each an entry of every level's lists.
    modes: Vec<FollowedModeJson>,
    /// From the first number of segments, or degree, to the last.
    levels: Vec<LevelJson>,
}

/// The errors at one number of segments or degree.
#[derive(Serialize, JsonSchema)]
struct LevelJson {
    /// Number of segments, or of elements, used.
    segments: usize,
    /// Polynomial degree of the elements of the spectral beam; null for other methods.
    degree: Option<usize>,
    /// Degrees of freedom of the whole tower.
    degrees_of_freedom: usize,
    /// The frequency of each mode, Hz; null where it is not there yet.
    frequencies_hz: Vec<Option<f64>>,
    /// f/f_limit − 1 of each mode.
    relative_errors: Vec<Option<f64>>,
    /// Observed order from the level before, p in n⁻ᵖ; of the spectral beam decimal digits gained a
    /// degree; null where only rounding is left.
    observed_orders: Vec<Option<f64>>,
}

fn degree(level: &Level) -> Option<usize> {
    match level.asked {
        Fineness::Segments(_) => None,
        Fineness::Degree(degree) => Some(degree),
    }
}

/// Writes how a method converges as indented JSON.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_convergence_json(
    convergence: &Convergence,
    writer: impl Write,
) -> Result<(), ResultError> {
    let level = |level: &Level| LevelJson {
        segments: level.segments,
        degree: degree(level),
        degrees_of_freedom: level.degrees_of_freedom,
        frequencies_hz: level.frequencies_hz.clone(),
        relative_errors: level.errors.clone(),
        observed_orders: level.orders.clone(),
    };
    let json = ConvergenceJson {
        method: convergence.method.name(),
        limit_has_rotary_inertia: convergence.rotary_inertia,
        modes: convergence.modes.iter().map(followed).collect(),
        levels: convergence.levels.iter().map(level).collect(),
    };
    write_pretty(&json, writer)
}

/// Writes how a method converges as CSV: one line a level and mode.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_convergence_csv(
    convergence: &Convergence,
    writer: impl Write,
) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record([
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
    ])?;
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for level in &convergence.levels {
        for (index, mode) in convergence.modes.iter().enumerate() {
            let error = level.errors[index].map(|error| format!("{error:e}"));
            csv.write_record([
                convergence.method.name().to_owned(),
                level.segments.to_string(),
                degree(level).map_or_else(String::new, |degree| degree.to_string()),
                level.degrees_of_freedom.to_string(),
                mode.family.name().to_owned(),
                mode.order.to_string(),
                mode.label(),
                mode.is_pair.to_string(),
                number(level.frequencies_hz[index]),
                mode.frequency_hz.to_string(),
                error.unwrap_or_default(),
                number(level.orders[index]),
            ])?;
        }
    }
    csv.flush()?;
    Ok(())
}
