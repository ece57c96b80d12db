//! Frequency differences of several methods from the reference beam solution.

use towermodes::Method;
use towermodes_analysis::study::{Column, Comparison};

use super::chart::WIDTH;
use super::chart::error_axis::{ErrorAxis, signed};
use super::chart::legend::{Entry, Legend, words};
use crate::svg::{
    Anchor, Axes, Colour, DataTable, Drawing, Figure, Frame, Marker, Stroke, TextStyle, widest,
};
use crate::wording::counted;

/// Height of the field.
const FIELD: f64 = 360.0;
const TOP: f64 = 18.0;
/// Distance from the field to the names of the modes.
const SPACE: f64 = 10.0;
const SIZE: f64 = 11.0;
/// Largest number of modes; there is no room for more names.
const MODES: usize = 40;
/// Largest number of methods, because more cannot be distinguished.
const METHODS: usize = 12;
/// Distance of neighbouring dots of a mode, if there is room.
const APART: f64 = 9.0;

/// The relative frequency differences of the methods from the reference solution, a group of dots
/// per mode.
pub fn error(comparison: &Comparison) -> Figure {
    let methods = drawn(comparison);
    Figure {
        name: "error".to_owned(),
        title: "Frequency differences of the methods from the reference solution".to_owned(),
        description: description(comparison, &methods),
        drawing: drawing(comparison, &methods),
        table: table(comparison),
    }
}

/// The columns that are drawn. The reference solution is drawn only if there is no other column.
fn drawn(comparison: &Comparison) -> Vec<&Column> {
    let others = comparison
        .columns
        .iter()
        .filter(|c| c.method != Method::Spectral);
    let others: Vec<&Column> = others.take(METHODS).collect();
    if others.is_empty() {
        comparison.columns.iter().take(1).collect()
    } else {
        others
    }
}

/// The relative difference of a column from the reference for a mode, if the column has this mode.
fn difference(column: &Column, mode: usize) -> Option<f64> {
    let difference = column.relative_differences[mode]?;
    difference.is_finite().then_some(difference)
}

/// "rmje-exact (60 segments)", "spectral (degree 17)".
fn name(column: &Column) -> String {
    match column.degree {
        Some(degree) => format!("{} (degree {degree})", column.method.name()),
        None => format!(
            "{} ({})",
            column.method.name(),
            counted(column.segments, column.method.unit())
        ),
    }
}

fn modes(comparison: &Comparison) -> std::ops::Range<usize> {
    0..comparison.modes.len().min(MODES)
}

/// Number of modes that are not drawn.
fn hidden(comparison: &Comparison) -> usize {
    comparison.modes.len() - modes(comparison).len()
}

/// "20 more modes"; `None` if there are none.
pub(super) fn hidden_text(hidden: usize) -> Option<String> {
    (hidden > 0).then(|| counted(hidden, "more mode"))
}

fn description(comparison: &Comparison, methods: &[&Column]) -> String {
    let names: Vec<String> = methods.iter().map(|column| name(column)).collect();
    let mut text = format!(
        "Relative frequency differences of {} from the reference solution, for {}, on a logarithmic axis.",
        names.join(", "),
        counted(comparison.modes.len(), "mode")
    );
    let largest = |column: &&Column| {
        let all = (0..comparison.modes.len()).filter_map(|mode| difference(column, mode));
        all.map(f64::abs).fold(0.0, f64::max)
    };
    let worst = methods
        .iter()
        .max_by(|a, b| largest(a).total_cmp(&largest(b)));
    text.extend(worst.map(|column| {
        format!(
            " The largest difference is {:.1e} (method {}).",
            largest(column),
            column.method.name()
        )
    }));
    match hidden(comparison) {
        0 => {}
        1 => text.push_str(" The last mode is not shown."),
        hidden => text.push_str(&format!(" The last {hidden} modes are not shown.")),
    }
    text
}

fn drawing(comparison: &Comparison, methods: &[&Column]) -> Drawing {
    let differences = modes(comparison).flat_map(|mode| {
        methods
            .iter()
            .filter_map(move |column| difference(column, mode))
    });
    let errors = ErrorAxis::of(differences);
    let y = errors.axis("relative difference from the reference (−)");
    let frame = Frame {
        left: y.left_margin(),
        top: TOP,
        right: WIDTH - 14.0,
        bottom: TOP + FIELD,
    };
    let count = modes(comparison).len().max(1) as f64;
    let axes = Axes::new(frame, [0.0, count], errors.range, [false, true]);
    let labels = modes(comparison).map(|mode| comparison.modes[mode].label.as_str());
    let labels: Vec<&str> = labels.collect();
    let mut entries: Vec<Entry> = methods.iter().enumerate().map(entry).collect();
    entries.extend(hidden_text(hidden(comparison)).map(words));
    let below = SPACE + names_height(&labels, &axes) + SPACE;
    let legend = Legend::below(&frame, frame.bottom + below, entries);
    let mut drawing = legend.sheet();
    axes.draw_y(&mut drawing, &y.name, y.numbers);
    names(&mut drawing, &labels, &axes);
    dots(&mut drawing, comparison, methods, &errors, &axes);
    legend.draw(&mut drawing);
    drawing
}

/// The methods drawn beside the reference must not share a marker.
const _: () = assert!(Method::ALL.len() <= Marker::SERIES.len() + 1);

fn marker(index: usize) -> (Marker, Colour) {
    (Marker::of_series(index), Colour::Series(index))
}

fn entry((index, column): (usize, &&Column)) -> Entry {
    (marker(index).into(), name(column))
}

/// The middle of the room for a mode.
fn middle(mode: usize) -> f64 {
    mode as f64 + 0.5
}

fn column_width(axes: &Axes) -> f64 {
    axes.x.at(1.0) - axes.x.at(0.0)
}

fn are_turned(labels: &[&str], axes: &Axes) -> bool {
    widest(labels.iter().copied(), SIZE, false) + 8.0 > column_width(axes)
}

fn names_height(labels: &[&str], axes: &Axes) -> f64 {
    match are_turned(labels, axes) {
        true => widest(labels.iter().copied(), SIZE, false),
        false => SIZE,
    }
}

/// Writes the names of the modes below the field, rotated if they are too long, and draws a line
/// upwards from each.
fn names(drawing: &mut Drawing, labels: &[&str], axes: &Axes) {
    let frame = axes.frame;
    let (style, dx, dy) = match are_turned(labels, axes) {
        true => (
            TextStyle::new(SIZE).anchor(Anchor::End).turned(),
            0.35 * SIZE,
            0.0,
        ),
        false => (TextStyle::new(SIZE).anchor(Anchor::Middle), 0.0, 0.8 * SIZE),
    };
    for (mode, label) in labels.iter().enumerate() {
        let x = axes.x.at(middle(mode));
        let grid = Stroke::new(Colour::Grid, 1.0);
        drawing.line((x, frame.top), (x, frame.bottom), &grid);
        drawing.text((x + dx, frame.bottom + SPACE + dy), label, &style);
    }
    let (from, to) = ((frame.left, frame.bottom), (frame.right, frame.bottom));
    drawing.line(from, to, &Stroke::new(Colour::Muted, 1.0));
}

/// Draws the dots of each mode side by side, in the order of the legend.
fn dots(
    drawing: &mut Drawing,
    comparison: &Comparison,
    methods: &[&Column],
    errors: &ErrorAxis,
    axes: &Axes,
) {
    let count = methods.len() as f64;
    let apart = APART.min(0.8 * column_width(axes) / count);
    let radius = (0.55 * apart).clamp(2.0, 4.2);
    for mode in modes(comparison) {
        for (index, column) in methods.iter().enumerate() {
            let Some(difference) = difference(column, mode) else {
                continue;
            };
            let (x, y) = axes.at(middle(mode), errors.value(difference));
            let (marker, colour) = marker(index);
            let x = x + (index as f64 - 0.5 * (count - 1.0)) * apart;
            drawing.marker(marker, (x, y), radius, colour);
        }
    }
}

/// One row per mode: its frequency and the signed difference of each method.
fn table(comparison: &Comparison) -> DataTable {
    let first = ["mode".to_owned(), "frequency (Hz)".to_owned()];
    let row = |mode: usize| {
        let followed = &comparison.modes[mode];
        let first = [
            followed.label.clone(),
            format!("{:.6}", followed.frequency_hz),
        ];
        let cells = comparison.columns.iter().map(|column| {
            let difference = column.relative_differences[mode];
            difference.map_or_else(String::new, signed)
        });
        first.into_iter().chain(cells).collect()
    };
    DataTable {
        header: first
            .into_iter()
            .chain(comparison.columns.iter().map(name))
            .collect(),
        rows: (0..comparison.modes.len()).map(row).collect(),
    }
}
