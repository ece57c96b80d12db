//! The convergence of a method in braille dots.

use towermodes_analysis::study::{Convergence, Fineness, Level};

use super::chart::{Series, XAxis, chart};
use crate::figures::error_axis::ROUNDING;

/// The relative errors of the modes against the number of segments on logarithmic axes (for the
/// method spectral against its degree), as wide as a terminal of `width` columns permits. `marks`
/// are the characters of the modes in the table beside it. Empty if there is no room or no error.
pub fn convergence(
    convergence: &Convergence,
    marks: impl Iterator<Item = char>,
    width: usize,
) -> String {
    let is_spectral = convergence
        .levels
        .first()
        .is_some_and(|level| matches!(level.asked, Fineness::Degree(_)));
    let x_axis = XAxis {
        name: if is_spectral { "degree" } else { "segments" },
        is_logarithmic: !is_spectral,
    };
    let series: Vec<Series> = (0..convergence.modes.len())
        .zip(marks)
        .map(|(mode, mark)| Series {
            mark,
            name: convergence.modes[mode].label.clone(),
            points: points(convergence, mode),
        })
        .collect();
    chart(&series, &x_axis, width)
}

/// Segments, or degree, and error of each level at which a mode has one, by rising number.
fn points(convergence: &Convergence, mode: usize) -> Vec<(f64, f64)> {
    let point = |level: &Level| {
        let error = level.errors.get(mode).copied().flatten()?.abs();
        let number = match level.asked {
            Fineness::Degree(degree) => degree,
            Fineness::Segments(_) => level.segments,
        };
        (error.is_finite() && error > 0.0).then_some((number as f64, error))
    };
    let mut points: Vec<(f64, f64)> = convergence.levels.iter().filter_map(point).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points.dedup_by_key(|point| point.0);
    // Of the levels with rounding errors only, the first is shown.
    let last = points.iter().rposition(|(_, error)| *error >= ROUNDING);
    points.truncate(last.map_or(1, |last| last + 2));
    points
}
