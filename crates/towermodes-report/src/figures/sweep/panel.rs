//! A panel: a field with axes, one above the other on a sheet.

use crate::figures::end_labels::{self, EndLabel};
use crate::svg::{Axes, Colour, Dash, Drawing, Frame, Marker, Stroke, TextStyle};

/// Width of the sheet.
pub(super) const WIDTH: f64 = 900.0;
/// Height of a panel.
pub(super) const HEIGHT: f64 = 300.0;
/// Height of the only panel.
pub(super) const HEIGHT_ALONE: f64 = 480.0;
/// Above the field, with the title of the panel.
const ABOVE: f64 = 30.0;
/// Below the field: numbers and name of the axis.
const BELOW: f64 = 46.0;
/// Numbers along an axis.
const TICKS: usize = 6;
/// Markers are drawn on curves with at most so many points.
const MARKED: usize = 24;

/// A curve in a panel.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curve {
    pub(super) label: String,
    /// By rising x; NaN interrupts the curve.
    pub(super) points: Vec<(f64, f64)>,
}

/// A panel with curves.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Panel<'a> {
    /// Above the field; may be empty.
    pub(super) title: &'a str,
    pub(super) x_name: &'a str,
    pub(super) curves: Vec<Curve>,
}

/// Panels one below the other.
pub(super) fn stacked(panels: &[Panel<'_>]) -> Drawing {
    let height = height(panels.len());
    let mut drawing = Drawing::new(WIDTH, height * panels.len().max(1) as f64);
    for (index, panel) in panels.iter().enumerate() {
        let top = height * index as f64;
        draw(&mut drawing, panel, [top, top + height]);
    }
    drawing
}

/// The height of each of several panels.
pub(super) fn height(panels: usize) -> f64 {
    if panels <= 1 { HEIGHT_ALONE } else { HEIGHT }
}

/// The frame of a panel between two heights of the sheet, and its title.
pub(super) fn frame(
    drawing: &mut Drawing,
    title: &str,
    [top, bottom]: [f64; 2],
    left: f64,
    right: f64,
) -> Frame {
    let style = TextStyle::new(13.0).bold();
    drawing.text((left, top + 0.65 * ABOVE), title, &style);
    Frame {
        left,
        top: top + ABOVE,
        right,
        bottom: bottom - BELOW,
    }
}

fn draw(drawing: &mut Drawing, panel: &Panel<'_>, rows: [f64; 2]) {
    let points = || panel.curves.iter().flat_map(|curve| &curve.points);
    let shown = || points().filter(|(x, y)| x.is_finite() && y.is_finite());
    let x = range(shown().map(|(x, _)| *x), 0.0);
    let y = range(shown().map(|(_, y)| *y), 0.06);
    let left = Axes::left_margin(y, false, TICKS);
    let sketch = Frame {
        left,
        top: rows[0] + ABOVE,
        right: WIDTH,
        bottom: rows[1] - BELOW,
    };
    let heights = Axes::new(sketch, x, y, [false, false]);
    let labels: Vec<EndLabel> = end_labels_of(&panel.curves, &heights);
    let right = WIDTH - end_labels::column_width(&labels);
    let frame = frame(drawing, panel.title, rows, left, right);
    let axes = Axes::new(frame, x, y, [false, false]);
    axes.draw_x(drawing, panel.x_name, TICKS);
    axes.draw_y(drawing, "natural frequency (Hz)", TICKS);
    for (index, curve) in panel.curves.iter().enumerate() {
        draw_curve(drawing, index, curve, &axes);
    }
    end_labels::draw(drawing, right, [frame.top, frame.bottom], &labels);
}

fn draw_curve(drawing: &mut Drawing, index: usize, curve: &Curve, axes: &Axes) {
    let places: Vec<(f64, f64)> = curve.points.iter().map(|(x, y)| axes.at(*x, *y)).collect();
    let stroke = Stroke::new(Colour::Series(index), 1.6).dashed(Dash::of_series(index));
    drawing.polyline(&places, &stroke);
    if places.len() <= MARKED {
        for place in places {
            drawing.marker(Marker::of_series(index), place, 3.5, Colour::Series(index));
        }
    }
}

fn end_labels_of(curves: &[Curve], axes: &Axes) -> Vec<EndLabel> {
    let label = |(index, curve): (usize, &Curve)| {
        let last = curve.points.iter().rev().find(|(_, y)| y.is_finite())?;
        Some(EndLabel {
            y: axes.y.at(last.1),
            text: curve.label.clone(),
            colour: Colour::Series(index),
            marker: Some(Marker::of_series(index)),
            is_bold: false,
        })
    };
    curves.iter().enumerate().filter_map(label).collect()
}

/// From the smallest to the largest value, with a share of the difference on both sides; never
/// empty.
pub(super) fn range(values: impl Iterator<Item = f64>, share: f64) -> [f64; 2] {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low > high {
        return [0.0, 1.0];
    }
    if high - low <= 1e-12 * high.abs().max(low.abs()) {
        let half = if high == 0.0 { 0.5 } else { 0.05 * high.abs() };
        return [low - half, high + half];
    }
    let room = share * (high - low);
    [low - room, high + room]
}
