//! One chart: a field with two axes, shaded bands, and lines with markers and a label at the end of
//! each.

pub(super) mod end_labels;
pub(crate) mod error_axis;
pub(super) mod legend;
mod slope;

use crate::svg::{
    Axes, Colour, Dash, DataTable, Drawing, Frame, Marker, Numbers, Stroke, TextStyle, extent,
    text_width,
};
use end_labels::EndLabel;
use towermodes::number::Plain;

/// Width of the sheet.
pub(super) const WIDTH: f64 = 900.0;
/// Room above the field without a title, and with one.
const ABOVE: [f64; 2] = [18.0, 30.0];
/// Room below the field for the numbers and the name of the axis.
const BELOW: f64 = 46.0;
/// Markers are drawn on lines with at most this number of points.
const MARKED: usize = 24;
/// Size of the note and of the names of bands.
const SIZE: f64 = 11.0;

/// A chart on a sheet of [`WIDTH`]; default values are parts that it does not have.
#[derive(Debug, Clone, Default)]
pub(super) struct Chart {
    /// The title above the field.
    pub title: Option<String>,
    pub x: Axis,
    pub y: Axis,
    /// The shaded bands, which are drawn first so that the lines are visible.
    pub bands: Vec<Band>,
    /// The observed orders; a triangle in a corner of logarithmic axes shows them.
    pub orders: Vec<f64>,
    pub series: Vec<Series>,
    /// The note below the labels.
    pub note: Option<String>,
}

/// A range of y that is shaded.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Band {
    pub range: [f64; 2],
    pub name: String,
    pub colour: Colour,
    /// Values in it that are marked.
    pub marked: Vec<f64>,
}

/// An axis: its name with the unit, and its values.
#[derive(Debug, Clone)]
pub(super) struct Axis {
    pub name: String,
    pub range: [f64; 2],
    pub is_logarithmic: bool,
    pub numbers: Numbers,
}

/// A line through points.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Series {
    /// Its index in the order of colours, dash patterns and markers.
    pub index: usize,
    pub label: String,
    /// x and y; the line is interrupted where y is NaN.
    pub points: Vec<[f64; 2]>,
}

impl Default for Axis {
    fn default() -> Self {
        Self::linear("", [0.0, 1.0])
    }
}

impl Axis {
    /// A linear axis with about six numbers.
    pub fn linear(name: &str, range: [f64; 2]) -> Self {
        Self {
            name: name.to_owned(),
            range,
            is_logarithmic: false,
            numbers: Numbers::About(6),
        }
    }

    pub fn left_margin(&self) -> f64 {
        Axes::left_margin(self.range, self.is_logarithmic, self.numbers.clone())
    }
}

impl Chart {
    /// The chart on a sheet of its own.
    pub fn drawing(&self, height: f64) -> Drawing {
        let mut drawing = Drawing::new(WIDTH, height);
        self.draw(&mut drawing, [0.0, height]);
        drawing
    }

    /// Draws the chart between two heights of the sheet.
    pub fn draw(&self, drawing: &mut Drawing, rows: [f64; 2]) {
        let title = self.title.as_deref();
        let left = self.y.left_margin();
        let labels = self.labels(&self.axes(frame(title, rows, [left, WIDTH])));
        let right = WIDTH - end_labels::column_width(&labels);
        let axes = self.axes(frame(title, rows, [left, right]));
        draw_title(drawing, title, &axes.frame);
        for band in &self.bands {
            band.draw(drawing, &axes);
        }
        axes.draw_x(drawing, &self.x.name, self.x.numbers.clone());
        axes.draw_y(drawing, &self.y.name, self.y.numbers.clone());
        for band in &self.bands {
            band.write_name(drawing, &axes);
        }
        let places = |series: &Series| series.points.iter().map(|[x, y]| axes.at(*x, *y)).collect();
        let lines: Vec<Vec<(f64, f64)>> = self.series.iter().map(places).collect();
        slope::draw(drawing, &axes, &self.orders, &lines);
        for (series, places) in self.series.iter().zip(&lines) {
            series.draw(drawing, places);
        }
        let Frame { top, bottom, .. } = axes.frame;
        end_labels::draw(drawing, right, [top, bottom], &labels);
        if let Some(note) = &self.note {
            let style = TextStyle::new(SIZE).colour(Colour::Muted);
            let last_x = WIDTH - 10.0 - text_width(note, SIZE, false);
            drawing.text((last_x.min(right + 22.0), bottom + 16.0), note, &style);
        }
    }

    fn axes(&self, frame: Frame) -> Axes {
        let are_logarithmic = [self.x.is_logarithmic, self.y.is_logarithmic];
        Axes::new(frame, self.x.range, self.y.range, are_logarithmic)
    }

    fn labels(&self, axes: &Axes) -> Vec<EndLabel> {
        let label = |series: &Series| {
            let [_, last] = series.finite().last()?;
            Some(EndLabel {
                y: axes.y.at(last),
                text: series.label.clone(),
                colour: Colour::Series(series.index),
                marker: Some(Marker::of_series(series.index)),
                is_bold: false,
            })
        };
        self.series.iter().filter_map(label).collect()
    }

    /// A row for each x of the first series, a column for each series in a unit.
    pub fn table(&self, unit: &str) -> DataTable {
        let names = self
            .series
            .iter()
            .map(|series| format!("{} ({unit})", series.label));
        let first = self.series.first().map_or(&[][..], |series| &series.points);
        let row = |(place, [x, _]): (usize, &[f64; 2])| {
            let y = |series: &Series| six_decimals(series.points[place][1]);
            let own = std::iter::once(Plain(*x).to_string());
            own.chain(self.series.iter().map(y)).collect()
        };
        DataTable {
            header: std::iter::once(self.x.name.clone()).chain(names).collect(),
            rows: first.iter().enumerate().map(row).collect(),
        }
    }
}

impl Series {
    /// The points whose y is finite.
    pub fn finite(&self) -> impl DoubleEndedIterator<Item = [f64; 2]> {
        self.points.iter().copied().filter(|[_, y]| y.is_finite())
    }

    fn draw(&self, drawing: &mut Drawing, places: &[(f64, f64)]) {
        let colour = Colour::Series(self.index);
        let stroke = Stroke::new(colour, 1.6).dashed(Dash::of_series(self.index));
        drawing.polyline(places, &stroke);
        for place in places.iter().take_while(|_| places.len() <= MARKED) {
            drawing.marker(Marker::of_series(self.index), *place, 4.0, colour);
        }
    }
}

/// A number of a table; empty for NaN.
pub(super) fn six_decimals(value: f64) -> String {
    match value.is_finite() {
        true => format!("{value:.6}"),
        false => String::new(),
    }
}

/// The field between two heights of the sheet, with room for a title above.
pub(super) fn frame(title: Option<&str>, rows: [f64; 2], [left, right]: [f64; 2]) -> Frame {
    Frame {
        left,
        top: rows[0] + ABOVE[usize::from(title.is_some())],
        right,
        bottom: rows[1] - BELOW,
    }
}

/// Writes a title above a field.
pub(super) fn draw_title(drawing: &mut Drawing, title: Option<&str>, frame: &Frame) {
    if let Some(title) = title {
        let at = (frame.left, frame.top - 0.35 * ABOVE[1]);
        drawing.text(at, title, &TextStyle::new(13.0).bold());
    }
}

impl Band {
    /// The part of the band that is in the field.
    fn within(&self, axes: &Axes) -> Option<[f64; 2]> {
        let [low, high] = self.range;
        let (low, high) = (low.max(axes.y.low), high.min(axes.y.high));
        (low < high).then(|| [high, low].map(|value| axes.y.at(value)))
    }

    fn draw(&self, drawing: &mut Drawing, axes: &Axes) {
        let Some([top, bottom]) = self.within(axes) else {
            return;
        };
        let Frame { left, right, .. } = axes.frame;
        let size = (right - left, bottom - top);
        drawing.rectangle((left, top), size, self.colour, None);
        let stroke = Stroke::new(Colour::Fail, 1.2).dashed(Dash::Dotted);
        let is_visible = |value: &&f64| axes.y.low < **value && **value < axes.y.high;
        for value in self.marked.iter().filter(is_visible) {
            let y = axes.y.at(*value);
            drawing.line((left, y), (right, y), &stroke);
        }
    }

    /// Writes the name at the edge of the band, on a background that hides the grid.
    fn write_name(&self, drawing: &mut Drawing, axes: &Axes) {
        let Some([top, bottom]) = self.within(axes) else {
            return;
        };
        let left = axes.frame.left + 6.0;
        let y = match self.range[1] > axes.y.high {
            true => bottom - 6.0,
            false => top + 14.0,
        };
        let size = (text_width(&self.name, SIZE, false) + 4.0, 1.3 * SIZE);
        drawing.rectangle((left - 2.0, y - SIZE), size, self.colour, None);
        drawing.text((left, y), &self.name, &TextStyle::new(SIZE));
    }
}

/// From the smallest to the largest value, extended by a share of the difference on both sides;
/// never empty.
pub(super) fn range(values: impl Iterator<Item = f64>, share: f64) -> [f64; 2] {
    let Some([low, high]) = extent(values) else {
        return [0.0, 1.0];
    };
    let room = match high - low <= 1e-12 * high.abs().max(low.abs()) {
        true if high == 0.0 => 0.5,
        true => 0.05 * high.abs(),
        false => share * (high - low),
    };
    [low - room, high + room]
}
