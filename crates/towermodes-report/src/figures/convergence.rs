//! Convergence of a method with the number of segments or the polynomial degree.

use towermodes_analysis::study::{Convergence, Fineness, Level};

use super::chart::error_axis::{ErrorAxis, ROUNDING, signed};
use super::chart::{Axis, Chart, Series};
use super::error::hidden_text;
use crate::svg::{DataTable, Figure, Numbers, extent};

const HEIGHT: f64 = 520.0;
/// Largest number of modes, because more cannot be distinguished.
const MODES: usize = 14;

/// The relative errors of the modes against the number of segments on logarithmic axes; for the
/// method spectral against its degree.
pub fn convergence(convergence: &Convergence) -> Figure {
    let chart = chart(convergence);
    let against = match is_spectral(convergence) {
        true => "degree",
        false => "number of segments",
    };
    let method = convergence.method.name();
    Figure {
        name: "convergence".to_owned(),
        title: format!("Convergence of {method}: error against {against}"),
        description: description(convergence, chart.series.len()),
        drawing: chart.drawing(HEIGHT),
        table: table(convergence),
    }
}

/// Whether the degree is refined instead of the mesh.
pub(crate) fn is_spectral(convergence: &Convergence) -> bool {
    let first = convergence.levels.first();
    matches!(first.map(|level| level.asked), Some(Fineness::Degree(_)))
}

/// The numbers (of segments, or the degree) and errors of a mode, by increasing number; of the
/// levels with only rounding errors, the first.
pub(crate) fn errors(
    convergence: &Convergence,
    mode: usize,
    number: impl Fn(&Level) -> usize,
) -> Vec<[f64; 2]> {
    let point = |level: &Level| {
        let error = level.errors.get(mode).copied().flatten()?.abs();
        error.is_finite().then(|| [number(level) as f64, error])
    };
    let mut points: Vec<[f64; 2]> = convergence.levels.iter().filter_map(point).collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let last = points.iter().rposition(|[_, error]| *error >= ROUNDING);
    points.truncate(last.map_or(1, |last| last + 2));
    points
}

fn chart(convergence: &Convergence) -> Chart {
    let spectral = is_spectral(convergence);
    let of_mode = |mode: usize| Series {
        index: mode,
        label: label(convergence, mode),
        points: errors(convergence, mode, |level| level.asked.number()),
    };
    let all = (0..convergence.modes.len()).map(of_mode);
    let drawn = all.filter(|series| !series.points.is_empty());
    let mut series: Vec<Series> = drawn.take(MODES).collect();
    let points = series.iter().flat_map(|series| &series.points);
    let errors = ErrorAxis::of(points.map(|[_, error]| *error));
    for [_, error] in series.iter_mut().flat_map(|series| &mut series.points) {
        *error = errors.value(*error);
    }
    let orders = series
        .iter()
        .filter_map(|s| last_order(convergence, s.index));
    Chart {
        x: x_axis(convergence),
        y: errors.axis("relative error against the reference (−)"),
        orders: orders.filter(|_| !spectral).collect(),
        note: hidden_text(convergence.modes.len() - series.len()),
        series,
        ..Chart::default()
    }
}

/// The axis from the smallest to the largest number, with room for the markers.
fn x_axis(convergence: &Convergence) -> Axis {
    let mut numbers: Vec<usize> = convergence
        .levels
        .iter()
        .map(|l| l.asked.number())
        .collect();
    numbers.sort_unstable();
    numbers.dedup();
    let ends = extent(numbers.iter().map(|number| *number as f64));
    let [low, high] = ends.unwrap_or([1.0; 2]).map(|end| end.max(1.0));
    let spectral = is_spectral(convergence);
    let (name, range) = match spectral {
        true => ("polynomial degree (−)", [low - 0.5, high + 0.5]),
        false => ("segments (−)", [low / 1.2, high * 1.1]),
    };
    let text = |number: usize| (number as f64, number.to_string());
    Axis {
        is_logarithmic: !spectral,
        numbers: Numbers::At(numbers.into_iter().map(text).collect()),
        ..Axis::linear(name, range)
    }
}

/// The last observed order of a mode.
fn last_order(convergence: &Convergence, mode: usize) -> Option<f64> {
    let mut levels = convergence.levels.iter().rev();
    levels.find_map(|level| level.orders.get(mode).copied().flatten())
}

/// "1st fore-aft bending, order 2.00".
fn label(convergence: &Convergence, mode: usize) -> String {
    let name = &convergence.modes[mode].label;
    match last_order(convergence, mode) {
        None => name.clone(),
        Some(digits) if is_spectral(convergence) => {
            format!("{name}, {digits:.2} digits per degree")
        }
        Some(order) => format!("{name}, order {order:.2}"),
    }
}

fn description(convergence: &Convergence, drawn: usize) -> String {
    let (noun, axes) = match is_spectral(convergence) {
        true => ("degrees", "one logarithmic and one linear"),
        false => ("segments", "logarithmic"),
    };
    let numbers = convergence.levels.iter().map(|level| level.asked.number());
    let mut text = format!(
        "Relative errors of the {} frequencies with respect to the reference solution{}, for {noun} {} to {}, on {axes} axes.",
        convergence.method.name(),
        if convergence.rotary_inertia {
            ""
        } else {
            " without rotary inertia"
        },
        numbers.clone().min().unwrap_or(0),
        numbers.max().unwrap_or(0),
    );
    let orders = (0..convergence.modes.len()).filter_map(|mode| last_order(convergence, mode));
    text.extend(
        extent(orders).map(|[low, high]| match is_spectral(convergence) {
            true => {
                format!(" In the last steps the error decreases by {low:.2} to {high:.2} decimal digits per degree.")
            }
            false => format!(" The last observed orders are {low:.2} to {high:.2}."),
        }),
    );
    match convergence.modes.len() - drawn {
        0 => {}
        1 => text.push_str(" 1 further mode is not shown."),
        hidden => text.push_str(&format!(" {hidden} further modes are not shown.")),
    }
    text
}

/// One row per mode and level: error and order.
fn table(convergence: &Convergence) -> DataTable {
    let (number, order) = match is_spectral(convergence) {
        true => ("degree", "digits per degree"),
        false => ("segments", "order"),
    };
    let header = ["mode", "frequency (Hz)", number, "relative error", order];
    let of_mode = |mode: usize| {
        let followed = &convergence.modes[mode];
        convergence.levels.iter().map(move |level| {
            let at = |values: &[Option<f64>]| values.get(mode).copied().flatten();
            vec![
                followed.label.clone(),
                format!("{:.6}", followed.frequency_hz),
                level.asked.number().to_string(),
                at(&level.errors).map_or_else(String::new, signed),
                at(&level.orders).map_or_else(String::new, |order| format!("{order:.2}")),
            ]
        })
    };
    DataTable::new(header, (0..convergence.modes.len()).flat_map(of_mode))
}
