//! The influence of the input values of a tower on its lowest frequency, as a tornado diagram.

use towermodes::TowerDescription;
use towermodes::number::digits;
use towermodes_analysis::influence::{Influence, Influences, Tolerance, Tolerances};

use super::chart::WIDTH;
use super::chart::legend::{Entry, Legend};
use crate::svg::{
    Anchor, Axes, Colour, DataTable, Drawing, Figure, Frame, Marker, Stroke, TextStyle, widest,
};

const TOP: f64 = 18.0;
/// Height of a bar with the gap below it.
const ROW: f64 = 22.0;
const BAR: f64 = 14.0;
const SIZE: f64 = 12.0;
/// Distance from the field to the legend, with room for the numbers and the name of the axis.
const BELOW: f64 = 52.0;
/// Largest number of bars.
const MOST: usize = 24;
/// Room for the number at the end of a bar.
const ROOM: f64 = 0.16;
/// Effects that are smaller than this, relative to the largest, get no bar.
const SMALLEST: f64 = 1e-3;

/// An input value and its effect on the mode.
struct Bar<'a> {
    number: &'a Influence,
    /// Change of the frequency in percent for an increase of the input value.
    percent: f64,
}

/// The influence of the input values on the lowest mode: a bar per input value, the largest at the
/// top, for an increase and a decrease by one percent, or by the tolerance.
pub fn tornado(
    description: &TowerDescription,
    influences: &Influences,
    tolerances: &Tolerances,
) -> Figure {
    let bars = bars(description, influences, tolerances);
    let mode = influences.modes.first().map_or("", |mode| &mode.label);
    let cause = match tolerances.is_empty() {
        true => "one percent of each input value",
        false => "the tolerance of each input value",
    };
    let largest = bars.first().map_or(String::new(), |bar| {
        format!(
            " The largest change is caused by {}: {} %.",
            bar.number.name,
            signed(bar.percent)
        )
    });
    Figure {
        name: "tornado".to_owned(),
        title: format!("Influence of the input values on the frequency of the {mode}"),
        description: format!(
            "Change of the frequency of the {mode} by {cause}, one bar per input value, the largest on top.{largest}"
        ),
        drawing: drawing(&bars, mode, cause),
        table: table(&bars, influences),
    }
}

/// The input values that change the lowest mode, by decreasing effect.
fn bars<'a>(
    description: &TowerDescription,
    influences: &'a Influences,
    tolerances: &Tolerances,
) -> Vec<Bar<'a>> {
    let percent = |number: &Influence| {
        let tolerance = match tolerances.is_empty() {
            true => Some(Tolerance::Percent(1.0)),
            false => tolerances.of(&number.name, description),
        };
        let size = number.percent(tolerance?, 0)?;
        let derivative = number.derivatives.first()?.as_ref().ok()?;
        // A percent more of a negative number is less of it.
        let grows = match (tolerances.is_empty(), number.elasticities[0]) {
            (true, Some(elasticity)) => elasticity,
            _ => derivative.hz_per_unit,
        };
        Some(size.copysign(grows))
    };
    let bar = |number| percent(number).map(|percent| Bar { number, percent });
    let mut bars: Vec<Bar<'a>> = influences.numbers.iter().filter_map(bar).collect();
    bars.sort_by(|a, b| b.percent.abs().total_cmp(&a.percent.abs()));
    let largest = bars.first().map_or(0.0, |bar| bar.percent.abs());
    bars.retain(|bar| bar.percent != 0.0 && bar.percent.abs() >= SMALLEST * largest);
    bars.truncate(MOST);
    bars
}

fn signed(percent: f64) -> String {
    let sign = if percent < 0.0 { "−" } else { "+" };
    format!("{sign}{}", digits(percent.abs(), 3))
}

fn drawing(bars: &[Bar<'_>], mode: &str, cause: &str) -> Drawing {
    let names = bars.iter().map(|bar| bar.number.name.as_str());
    let frame = Frame {
        left: widest(names, SIZE, false) + 24.0,
        top: TOP,
        right: WIDTH - 14.0,
        bottom: TOP + ROW * bars.len().max(1) as f64,
    };
    let largest = bars.first().map_or(1.0, |bar| bar.percent.abs());
    let end = (1.0 + ROOM) * largest;
    let axes = Axes::new(frame, [-end, end], [0.0, 1.0], [false, false]);
    let legend = Legend::below(&frame, frame.bottom + BELOW, entries());
    let mut drawing = legend.sheet();
    let name = format!("change of the frequency of the {mode} by {cause} (%)");
    axes.draw_x(&mut drawing, &name, 8);
    for (row, bar) in bars.iter().enumerate() {
        draw(&mut drawing, bar, row, &axes);
    }
    let middle = axes.x.at(0.0);
    let line = Stroke::new(Colour::Muted, 1.0);
    drawing.line((middle, frame.top), (middle, frame.bottom), &line);
    legend.draw(&mut drawing);
    drawing
}

/// Draws both halves of a bar, the name of the input value on the left and the effect at its end.
fn draw(drawing: &mut Drawing, bar: &Bar<'_>, row: usize, axes: &Axes) {
    let top = axes.frame.top + ROW * row as f64 + 0.5 * (ROW - BAR);
    let middle = axes.x.at(0.0);
    for (percent, series) in [(bar.percent, 0), (-bar.percent, 1)] {
        let end = axes.x.at(percent);
        let (left, right) = (middle.min(end), middle.max(end));
        let bottom = top + BAR;
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        drawing.polygon(&corners, Colour::Series(series), None);
    }
    let base = top + 0.5 * BAR + 0.35 * SIZE;
    let name = TextStyle::new(SIZE).anchor(Anchor::End);
    drawing.text((axes.frame.left - 8.0, base), &bar.number.name, &name);
    let effect = format!("±{}", digits(bar.percent.abs(), 3));
    let end = axes.x.at(bar.percent.abs()) + 5.0;
    drawing.text((end, base), &effect, &TextStyle::new(SIZE));
}

fn entries() -> Vec<Entry> {
    let entry = |(series, text): (usize, &str)| {
        let marker = (Marker::of_series(series), Colour::Series(series));
        (marker.into(), text.to_owned())
    };
    [(0, "input value larger"), (1, "input value smaller")]
        .map(entry)
        .to_vec()
}

fn table(bars: &[Bar<'_>], influences: &Influences) -> DataTable {
    let mode = influences.modes.first().map_or("", |mode| &mode.label);
    let row = |bar: &Bar<'_>| vec![bar.number.name.clone(), signed(bar.percent)];
    DataTable::new(["input", &format!("{mode} (%)")], bars.iter().map(row))
}
