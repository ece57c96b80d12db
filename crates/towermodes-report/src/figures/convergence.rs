//! Convergence of a method with the number of segments or the polynomial degree.

use towermodes_analysis::study::{Convergence, Fineness, Level};

use super::end_labels::{self, EndLabel};
use super::error::hidden_text;
use super::error_axis::{ErrorAxis, ROUNDING, signed};
use super::slope;
use crate::svg::{
    Axes, Colour, Dash, DataTable, Drawing, Figure, Frame, Marker, Stroke, TextStyle, text_width,
};

const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 520.0;
const TOP: f64 = 18.0;
/// Below the field: numbers and name of the axis.
const BELOW: f64 = 46.0;
/// More modes cannot be distinguished.
const MODES: usize = 14;
/// Numbers along the axis are at least so far apart.
const BETWEEN: f64 = 8.0;

/// The curve of a mode: number of segments and error of each level that has the mode.
struct Series {
    mode: usize,
    label: String,
    points: Vec<[f64; 2]>,
}

/// The relative errors of the modes against the number of segments on logarithmic axes; for the
/// method spectral against its degree.
pub fn convergence(convergence: &Convergence) -> Figure {
    let series = series(convergence);
    let title = format!(
        "Convergence of {}: error against {}",
        convergence.method.name(),
        if is_spectral(convergence) {
            "degree"
        } else {
            "number of segments"
        }
    );
    Figure {
        name: "convergence".to_owned(),
        title,
        description: description(convergence, series.len()),
        drawing: drawing(convergence, &series),
        table: table(convergence),
    }
}

fn is_spectral(convergence: &Convergence) -> bool {
    let first = convergence.levels.first();
    matches!(first.map(|level| level.asked), Some(Fineness::Degree(_)))
}

fn number(level: &Level) -> f64 {
    level.asked.number() as f64
}

fn series(convergence: &Convergence) -> Vec<Series> {
    let of_mode = |mode: usize| {
        let point = |level: &Level| {
            let error = level.errors.get(mode).copied().flatten()?.abs();
            error.is_finite().then_some([number(level), error])
        };
        let mut points: Vec<[f64; 2]> = convergence.levels.iter().filter_map(point).collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        // Of the levels with rounding errors only, the first is shown.
        let last = points.iter().rposition(|[_, error]| *error >= ROUNDING);
        points.truncate(last.map_or(1, |last| last + 2));
        Series {
            mode,
            label: label(convergence, mode),
            points,
        }
    };
    let all = (0..convergence.modes.len()).map(of_mode);
    let drawn = all.filter(|series| !series.points.is_empty());
    drawn.take(MODES).collect()
}

/// The last observed order of a mode.
fn last_order(convergence: &Convergence, mode: usize) -> Option<f64> {
    let mut levels = convergence.levels.iter().rev();
    levels.find_map(|level| level.orders.get(mode).copied().flatten())
}

/// "1st fore-aft bending, order 2.00".
fn label(convergence: &Convergence, mode: usize) -> String {
    let name = convergence.modes[mode].label.clone();
    match last_order(convergence, mode) {
        None => name,
        Some(digits) if is_spectral(convergence) => {
            format!("{name}, {digits:.2} digits per degree")
        }
        Some(order) => format!("{name}, order {order:.2}"),
    }
}

fn beam(convergence: &Convergence) -> &'static str {
    if convergence.rotary_inertia {
        "the reference solution"
    } else {
        "the reference solution without rotary inertia"
    }
}

fn description(convergence: &Convergence, drawn: usize) -> String {
    let spectral = is_spectral(convergence);
    let numbers = convergence.levels.iter().map(|level| level.asked.number());
    let (least, most) = (numbers.clone().min(), numbers.max());
    let mut text = format!(
        "Relative errors of the {} frequencies with respect to {}, for {} {} to {}, on {} axes.",
        convergence.method.name(),
        beam(convergence),
        if spectral { "degrees" } else { "segments" },
        least.unwrap_or(0),
        most.unwrap_or(0),
        if spectral {
            "one logarithmic and one linear"
        } else {
            "logarithmic"
        },
    );
    let orders = (0..convergence.modes.len()).filter_map(|mode| last_order(convergence, mode));
    let (low, high) = orders.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), order| {
        (low.min(order), high.max(order))
    });
    if low <= high {
        text.push_str(&match spectral {
            true => {
                format!(" The last steps gain {low:.2} to {high:.2} decimal digits per degree.")
            }
            false => format!(" The last observed orders are {low:.2} to {high:.2}."),
        });
    }
    match convergence.modes.len() - drawn {
        0 => {}
        1 => text.push_str(" 1 further mode is not shown."),
        hidden => text.push_str(&format!(" {hidden} further modes are not shown.")),
    }
    text
}

fn drawing(convergence: &Convergence, series: &[Series]) -> Drawing {
    let mut drawing = Drawing::new(WIDTH, HEIGHT);
    let errors = series
        .iter()
        .flat_map(|s| s.points.iter().map(|[_, error]| *error));
    let errors = ErrorAxis::of(errors);
    let (axes, labels) = axes_with_labels(convergence, series, &errors);
    draw_axes(&mut drawing, convergence, &axes, &errors);
    let places: Vec<Vec<(f64, f64)>> = series.iter().map(|s| places(s, &errors, &axes)).collect();
    if !is_spectral(convergence) {
        let orders = series
            .iter()
            .filter_map(|s| last_order(convergence, s.mode));
        slope::draw(&mut drawing, &axes, &orders.collect::<Vec<f64>>(), &places);
    }
    for (series, places) in series.iter().zip(&places) {
        draw_series(&mut drawing, series.mode, places);
    }
    let Frame {
        top, right, bottom, ..
    } = axes.frame;
    end_labels::draw(&mut drawing, right, [top, bottom], &labels);
    if let Some(text) = hidden_text(convergence.modes.len() - series.len()) {
        let style = TextStyle::new(11.0).colour(Colour::Muted);
        let last_x = WIDTH - 10.0 - text_width(&text, 11.0, false);
        drawing.text((last_x.min(right + 22.0), bottom + 16.0), &text, &style);
    }
    drawing
}

/// The axes of a field that leaves room for the labels on its right, and these labels.
fn axes_with_labels(
    convergence: &Convergence,
    series: &[Series],
    errors: &ErrorAxis,
) -> (Axes, Vec<EndLabel>) {
    let mut frame = Frame {
        left: Axes::left_margin_at(&errors.ticks()),
        top: TOP,
        right: WIDTH,
        bottom: HEIGHT - BELOW,
    };
    let is_logarithmic = [!is_spectral(convergence), true];
    let axes = |frame| Axes::new(frame, x_range(convergence), errors.range, is_logarithmic);
    let label = |s: &Series| end_label(s, errors, &axes(frame));
    let labels: Vec<EndLabel> = series.iter().map(label).collect();
    frame.right -= end_labels::column_width(&labels);
    (axes(frame), labels)
}

fn draw_axes(drawing: &mut Drawing, convergence: &Convergence, axes: &Axes, errors: &ErrorAxis) {
    let name = match is_spectral(convergence) {
        true => "polynomial degree (–)",
        false => "segments (–)",
    };
    axes.draw_x_at(drawing, name, &x_ticks(convergence, axes));
    axes.draw_y_at(drawing, "relative error |f / f∞ − 1| (–)", &errors.ticks());
}

fn draw_series(drawing: &mut Drawing, mode: usize, places: &[(f64, f64)]) {
    drawing.polyline(places, &stroke(mode));
    let (marker, colour) = (Marker::of_series(mode), Colour::Series(mode));
    for place in places {
        drawing.marker(marker, *place, 4.0, colour);
    }
}

fn stroke(mode: usize) -> Stroke {
    Stroke::new(Colour::Series(mode), 1.6).dashed(Dash::of_series(mode))
}

fn places(series: &Series, errors: &ErrorAxis, axes: &Axes) -> Vec<(f64, f64)> {
    let place = |[number, error]: &[f64; 2]| axes.at(*number, errors.value(*error));
    series.points.iter().map(place).collect()
}

fn end_label(series: &Series, errors: &ErrorAxis, axes: &Axes) -> EndLabel {
    EndLabel {
        y: places(series, errors, axes).last().map_or(0.0, |(_, y)| *y),
        text: series.label.clone(),
        colour: Colour::Series(series.mode),
        marker: Some(Marker::of_series(series.mode)),
        is_bold: false,
    }
}

/// From the smallest to the largest number, with room for the markers.
fn x_range(convergence: &Convergence) -> [f64; 2] {
    let numbers = convergence.levels.iter().map(number);
    let (low, high) = numbers.fold((f64::INFINITY, 0.0_f64), |(low, high), n| {
        (low.min(n), high.max(n))
    });
    let low = low.min(high).max(1.0);
    if is_spectral(convergence) {
        [low - 0.5, high.max(low) + 0.5]
    } else {
        [low / 1.2, high.max(low) * 1.1]
    }
}

/// The requested numbers, as many as there is room for.
fn x_ticks(convergence: &Convergence, axes: &Axes) -> Vec<(f64, String)> {
    let mut numbers: Vec<usize> = convergence
        .levels
        .iter()
        .map(|l| l.asked.number())
        .collect();
    numbers.sort_unstable();
    numbers.dedup();
    let mut ticks: Vec<(f64, String)> = Vec::new();
    let mut free = f64::NEG_INFINITY;
    for number in numbers {
        let (value, text) = (number as f64, number.to_string());
        let half = 0.5 * text_width(&text, 11.0, false);
        if axes.x.at(value) - half >= free {
            free = axes.x.at(value) + half + BETWEEN;
            ticks.push((value, text));
        }
    }
    ticks
}

/// One row per mode and level: error and order.
fn table(convergence: &Convergence) -> DataTable {
    let spectral = is_spectral(convergence);
    let header = [
        "mode",
        "frequency (Hz)",
        if spectral { "degree" } else { "segments" },
        "relative error",
        if spectral {
            "digits per degree"
        } else {
            "order"
        },
    ];
    let of_mode = |mode: usize| {
        let followed = &convergence.modes[mode];
        let levels = convergence.levels.iter();
        levels.map(move |level| {
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
    DataTable {
        header: header.map(str::to_owned).to_vec(),
        rows: (0..convergence.modes.len()).flat_map(of_mode).collect(),
    }
}
