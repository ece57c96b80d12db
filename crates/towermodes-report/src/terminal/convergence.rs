//! The convergence of a method in braille dots.

use towermodes_analysis::study::{Convergence, Level};

use super::chart::{Series, XAxis, chart};
use crate::figures::convergence::{errors, is_spectral};

/// The relative errors of the modes against the number of segments on logarithmic axes (for the
/// method spectral against its degree), as wide as a terminal of `width` columns permits. `marks`
/// are the characters of the modes in the table beside it. Empty if there is no room or no error.
pub fn convergence(
    convergence: &Convergence,
    marks: impl Iterator<Item = char>,
    width: usize,
) -> String {
    let is_spectral = is_spectral(convergence);
    let x_axis = XAxis {
        name: if is_spectral { "degree" } else { "segments" },
        is_logarithmic: !is_spectral,
    };
    let number = |level: &Level| level.asked.degree().unwrap_or(level.segments);
    let series = |(mode, mark): (usize, char)| {
        let mut points = errors(convergence, mode, number);
        points.retain(|[_, error]| *error > 0.0);
        points.dedup_by_key(|[number, _]| *number);
        Series {
            mark,
            name: convergence.modes[mode].label.clone(),
            points: points.into_iter().map(|[x, y]| (x, y)).collect(),
        }
    };
    let modes = (0..convergence.modes.len()).zip(marks);
    chart(&modes.map(series).collect::<Vec<Series>>(), &x_axis, width)
}
