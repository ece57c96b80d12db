//! Draws the bar: shaded ranges, and a row for each mode with its distances.

use towermodes_analysis::Verdict;

use super::Bar;
use super::numbers::distance;
use super::ranges::{Lane, Range};
use crate::figures::chart::WIDTH;
use crate::number::four_digits;
use crate::svg::{
    Anchor, Axes, Colour, Dash, Drawing, Frame, Marker, Stroke, TextStyle, spread, text_width,
    widest,
};
use crate::wording::verdict_word;

/// Height of the row of a mode.
const LANE: f64 = 66.0;
/// Room above the field for the names of the ranges.
const ABOVE: f64 = 32.0;
/// Room below the field for its axis and the explanation.
const BELOW: f64 = 66.0;
/// Room for the verdicts on the right.
const VERDICTS: f64 = 62.0;
/// Size of most letters.
const SIZE: f64 = 12.0;
/// Size of the explanation.
const SMALL: f64 = 10.5;
/// Distance from the middle of a mode's mark to its edge.
const RADIUS: f64 = 6.5;
/// The axis extends to this multiple of the highest value.
const BEYOND: f64 = 1.06;

/// The picture of a bar.
pub(super) fn drawing(bar: &Bar) -> Drawing {
    let height = ABOVE + LANE * bar.lanes.len() as f64 + BELOW;
    let mut drawing = Drawing::new(WIDTH, height);
    let axes = axes(bar, height);
    draw_ranges(&mut drawing, &axes, &bar.ranges);
    axes.draw_x(&mut drawing, "natural frequency (Hz)", 8);
    for (index, lane) in bar.lanes.iter().enumerate() {
        let y = ABOVE + LANE * (index as f64 + 0.5);
        draw_lane(&mut drawing, &axes, lane, (index, y));
    }
    name_verdicts(&mut drawing, &axes, &bar.ranges);
    draw_note(&mut drawing, height);
    drawing
}

fn axes(bar: &Bar, height: f64) -> Axes {
    let names = bar.lanes.iter().map(|lane| lane.label.as_str());
    let left = (widest(names, SIZE, true) + 26.0).min(0.4 * WIDTH);
    let frame = Frame {
        left,
        top: ABOVE,
        right: WIDTH - VERDICTS,
        bottom: height - BELOW,
    };
    let ends = bar.ranges.iter().map(|range| range.kept_free_hz[1]);
    let modes = bar.lanes.iter().map(|lane| lane.frequency_hz);
    let highest_hz = ends.chain(modes).fold(0.0, f64::max);
    Axes::new(frame, [0.0, BEYOND * highest_hz], [0.0, 1.0], [false; 2])
}

/// Shades the ranges, the range with margin lighter and the range in operation darker, and names
/// each range above.
fn draw_ranges(drawing: &mut Drawing, axes: &Axes, ranges: &[Range]) {
    let Frame { top, bottom, .. } = axes.frame;
    let fill = |drawing: &mut Drawing, [low, high]: [f64; 2], colour| {
        let (from, to) = (axes.x.at(low), axes.x.at(high));
        drawing.rectangle((from, top), (to - from, bottom - top), colour, None);
    };
    let edges = |drawing: &mut Drawing, ends: [f64; 2], stroke: &Stroke| {
        for x in ends.map(|hz| axes.x.at(hz)) {
            drawing.line((x, top), (x, bottom), stroke);
        }
    };
    // Ranges may overlap: no fill covers an edge.
    for range in ranges {
        fill(drawing, range.kept_free_hz, Colour::Band);
    }
    for range in ranges {
        fill(drawing, range.operation_hz, Colour::Grid);
    }
    let margin = Stroke::new(Colour::Muted, 1.0).dashed(Dash::Dashed);
    let operation = Stroke::new(Colour::Ink, 1.4);
    for range in ranges {
        edges(drawing, range.kept_free_hz, &margin);
        edges(drawing, range.operation_hz, &operation);
    }
    name_ranges(drawing, axes, ranges);
}

fn name_ranges(drawing: &mut Drawing, axes: &Axes, ranges: &[Range]) {
    let texts: Vec<String> = ranges.iter().map(range_name).collect();
    let middles = ranges.iter().map(|range| {
        let [low, high] = range.operation_hz;
        axes.x.at(0.5 * (low + high))
    });
    let middles: Vec<f64> = middles.collect();
    let style = TextStyle::new(SIZE).bold().anchor(Anchor::Middle);
    let places = beside(&texts, &middles, axes.frame, (SIZE, true));
    for (text, x) in texts.iter().zip(places) {
        drawing.text((x, axes.frame.top - 10.0), text, &style);
    }
}

/// "1P, 3P:" above the verdicts, which are on these excitations alone.
fn name_verdicts(drawing: &mut Drawing, axes: &Axes, ranges: &[Range]) {
    let multiples: Vec<String> = ranges
        .iter()
        .map(|of| format!("{}P", of.multiple))
        .collect();
    let place = (axes.frame.right + 12.0, axes.frame.top - 10.0);
    let style = TextStyle::new(SMALL).colour(Colour::Muted);
    drawing.text(place, &format!("{}:", multiples.join(", ")), &style);
}

/// "3P: 0.345 to 0.605 Hz".
fn range_name(range: &Range) -> String {
    let [low, high] = range.operation_hz.map(four_digits);
    match low == high {
        true => format!("{}P: {low} Hz", range.multiple),
        false => format!("{}P: {low} to {high} Hz", range.multiple),
    }
}

/// Positions for the middles of texts near the desired positions, without overlaps and within the
/// frame.
fn beside(
    texts: &[String],
    wished: &[f64],
    frame: Frame,
    (size, is_bold): (f64, bool),
) -> Vec<f64> {
    let widest = widest(texts.iter().map(String::as_str), size, is_bold);
    let range = [frame.left + 0.5 * widest, frame.right - 0.5 * widest];
    spread(wished, widest + 10.0, range)
}

/// Draws the label, mark, distances and verdict of a mode; `place` is its number and the middle of
/// its row.
fn draw_lane(drawing: &mut Drawing, axes: &Axes, lane: &Lane, place: (usize, f64)) {
    let (index, y) = place;
    let Frame { left, right, .. } = axes.frame;
    let name = TextStyle::new(SIZE).bold().anchor(Anchor::End);
    drawing.text((left - 12.0, y + 0.35 * SIZE), &lane.label, &name);
    drawing.line((left, y), (right, y), &Stroke::new(Colour::Muted, 0.7));
    let x = axes.x.at(lane.frequency_hz);
    for margin in &lane.margins {
        draw_distance(drawing, (x, y), axes.x.at(margin.excitation_hz));
    }
    draw_error(drawing, axes, lane, y);
    drawing.marker(
        Marker::of_series(index),
        (x, y),
        RADIUS,
        Colour::Series(index),
    );
    write_frequency(drawing, axes, lane, (x, y));
    write_distances(drawing, axes, lane, (x, y));
    if let Some(verdict) = lane.verdict() {
        let style = TextStyle::new(SIZE).bold().colour(colour(verdict));
        drawing.text(
            (right + 12.0, y + 0.35 * SIZE),
            verdict_word(verdict),
            &style,
        );
    }
}

fn colour(verdict: Verdict) -> Colour {
    match verdict {
        Verdict::Pass => Colour::Pass,
        Verdict::Warn => Colour::Warn,
        Verdict::Fail => Colour::Fail,
        Verdict::Undecided => Colour::Muted,
    }
}

/// Draws the line from the mode to the closest excitation in operation.
fn draw_distance(drawing: &mut Drawing, (x, y): (f64, f64), end: f64) {
    let line = Stroke::new(Colour::Ink, 1.3);
    drawing.line((x, y), (end, y), &line);
    drawing.line((end, y - 7.0), (end, y + 7.0), &line);
}

/// Draws the range of the error, if it is wider than the mark.
fn draw_error(drawing: &mut Drawing, axes: &Axes, lane: &Lane, y: f64) {
    let ends = [-1.0, 1.0].map(|side| {
        axes.x
            .at((lane.frequency_hz + side * lane.error_hz).max(0.0))
    });
    if ends[1] - ends[0] > 2.0 * RADIUS {
        let wide = Stroke::new(Colour::Ink, 3.0);
        drawing.line((ends[0], y), (ends[1].min(axes.frame.right), y), &wide);
    }
}

fn write_frequency(drawing: &mut Drawing, axes: &Axes, lane: &Lane, (x, y): (f64, f64)) {
    let texts = [format!("{} Hz", four_digits(lane.frequency_hz))];
    let style = TextStyle::new(SIZE).anchor(Anchor::Middle);
    for x in beside(&texts, &[x], axes.frame, (SIZE, false)) {
        write_on_paper(drawing, (x, y - 13.0), &texts[0], &style);
    }
}

/// Writes each distance in percent below the middle of its line.
fn write_distances(drawing: &mut Drawing, axes: &Axes, lane: &Lane, (x, y): (f64, f64)) {
    let texts: Vec<String> = lane.distances().map(distance).collect();
    let middles = lane.margins.iter();
    let middles = middles.map(|margin| 0.5 * (x + axes.x.at(margin.excitation_hz)));
    let middles: Vec<f64> = middles.collect();
    let style = TextStyle::new(SIZE).anchor(Anchor::Middle);
    for (text, x) in texts
        .iter()
        .zip(beside(&texts, &middles, axes.frame, (SIZE, false)))
    {
        write_on_paper(drawing, (x, y + 21.0), text, &style);
    }
}

/// Writes a text, anchored in its middle, on a background that hides the lines behind it.
fn write_on_paper(drawing: &mut Drawing, (x, y): (f64, f64), text: &str, style: &TextStyle) {
    let width = text_width(text, style.size, style.is_bold) + 4.0;
    let left_top = (x - 0.5 * width, y - 0.9 * style.size);
    drawing.rectangle(left_top, (width, 1.2 * style.size), Colour::Paper, None);
    drawing.text((x, y), text, style);
}

fn draw_note(drawing: &mut Drawing, height: f64) {
    let note = "Between solid lines: excitation range in operation. Between dashed lines: the same with the margin. Percentages: smallest distance of excitation and frequency.";
    let style = TextStyle::new(SMALL).colour(Colour::Muted);
    drawing.text((12.0, height - 10.0), note, &style);
}
