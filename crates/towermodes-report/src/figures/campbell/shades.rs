//! The shaded areas of a Campbell diagram: the operating speeds, the soft-stiff range, and the
//! margins around 1P and the blade passing frequency.

use towermodes_analysis::resonance::Campbell;

use super::lines::Shown;
use super::rays::strong;
use crate::svg::{Axes, Colour, Dash, Drawing, Stroke, TextStyle, text_width};

/// The width of the band and of the margins for a rotor of one speed.
const NARROWEST: f64 = 8.0;
/// Size of the text that names the soft-stiff range.
const SIZE: f64 = 11.0;
/// Distance around that text.
const AROUND: f64 = 4.0;
/// Distance from the operating band to that text: marks on the border of the band extend this far.
const FROM_BAND: f64 = 26.0;

/// The soft-stiff range without the margins, Hz: the frequencies above 1P at the highest speed and
/// below the blade passing frequency at the lowest speed that do not fail with these; none if these
/// ranges overlap, and if nothing is checked.
pub(super) fn window_hz(campbell: &Campbell) -> Option<[f64; 2]> {
    if !campbell.not_checked.is_empty() {
        return None;
    }
    let rotor = &campbell.rotor;
    let from_hz = rotor.highest_rpm / 60.0 / (1.0 - campbell.margin);
    let to_hz = rotor.blades as f64 * rotor.lowest_rpm / 60.0 / (1.0 + campbell.margin);
    (from_hz < to_hz).then_some([from_hz, to_hz])
}

/// The positions of the lowest and the highest operating speed.
pub(super) fn operation_places(campbell: &Campbell, axes: &Axes) -> [f64; 2] {
    [campbell.rotor.lowest_rpm, campbell.rotor.highest_rpm].map(|rpm| axes.x.at(rpm))
}

/// The edges of the operating band, wide enough to be visible.
fn band_edges(campbell: &Campbell, axes: &Axes) -> [f64; 2] {
    let [from, to] = operation_places(campbell, axes);
    let more = 0.5 * (NARROWEST - (to - from)).max(0.0);
    [from - more, to + more]
}

/// The stroke of the borders of the soft-stiff range.
pub(super) fn window_edge() -> Stroke {
    Stroke::new(Colour::Pass, 0.9).dashed(Dash::Long)
}

/// The stroke of the borders of the margin and of twice the margin.
pub(super) fn ribbon_edge(is_margin: bool) -> Stroke {
    match is_margin {
        true => Stroke::new(Colour::Fail, 0.9),
        false => Stroke::new(Colour::Warn, 0.9).dashed(Dash::Dotted),
    }
}

/// Draws all shades of a field.
pub(super) fn draw(drawing: &mut Drawing, campbell: &Campbell, shown: &Shown, axes: &Axes) {
    let frame = axes.frame;
    if !campbell.speeds_are_known() {
        return;
    }
    let [from, to] = band_edges(campbell, axes);
    let size = (to - from, frame.bottom - frame.top);
    drawing.rectangle((from, frame.top), size, Colour::Band, None);
    if let Some(window_hz) = window_hz(campbell) {
        let [bottom, top] = window_hz.map(|hz| axes.y.at(hz));
        let size = (frame.right - frame.left, bottom - top);
        drawing.rectangle((frame.left, top), size, Colour::Window, None);
        for y in [top, bottom] {
            drawing.line((frame.left, y), (frame.right, y), &window_edge());
        }
    }
    if !campbell.not_checked.is_empty() {
        return;
    }
    for is_margin in [false, true] {
        for multiple in strong(campbell, shown) {
            ribbon(drawing, campbell, multiple, is_margin, axes);
        }
    }
}

/// Draws the area around the ray of a multiple, in operation, in which the distance |d| is below
/// the margin, or below twice the margin.
fn ribbon(
    drawing: &mut Drawing,
    campbell: &Campbell,
    multiple: usize,
    is_margin: bool,
    axes: &Axes,
) {
    let margin = campbell.margin * if is_margin { 1.0 } else { 2.0 };
    let [left, right] = band_edges(campbell, axes);
    let ends = [
        (left, campbell.rotor.lowest_rpm),
        (right, campbell.rotor.highest_rpm),
    ];
    let edge = |factor: f64| -> Vec<(f64, f64)> {
        let place = |(x, rpm): &(f64, f64)| {
            // Far above the field is as good as infinite.
            let y = axes.y.at(factor * multiple as f64 * rpm / 60.0);
            (*x, y.max(axes.frame.top - 1e4))
        };
        ends.iter().map(place).collect()
    };
    let upper = edge(if margin < 1.0 {
        1.0 / (1.0 - margin)
    } else {
        f64::INFINITY
    });
    let lower = edge(1.0 / (1.0 + margin));
    let (fill, stroke) = match is_margin {
        true => (Colour::TooNear, ribbon_edge(true)),
        false => (Colour::Near, ribbon_edge(false)),
    };
    let around: Vec<(f64, f64)> = upper.iter().chain(lower.iter().rev()).copied().collect();
    drawing.polygon(&around, fill, None);
    drawing.polyline(&upper, &stroke);
    drawing.polyline(&lower, &stroke);
}

/// Writes the name of the soft-stiff range beside the operating band and between the lines of
/// modes, if there is room.
pub(super) fn name_window(drawing: &mut Drawing, campbell: &Campbell, shown: &Shown, axes: &Axes) {
    let Some(window_hz) = window_hz(campbell) else {
        return;
    };
    let (text, frame) = ("soft-stiff", axes.frame);
    let style = TextStyle::new(SIZE).bold();
    let width = text_width(text, SIZE, true) + 2.0 * AROUND;
    let [from, to] = band_edges(campbell, axes);
    let places = [
        [frame.left + AROUND, from - FROM_BAND],
        [to + FROM_BAND, frame.right - AROUND],
    ];
    let place = places.iter().find(|[left, right]| right - left >= width);
    let (Some([left, right]), Some(middle)) = (place, free_height(window_hz, shown, axes)) else {
        return;
    };
    let left = 0.5 * (left + right - width);
    let height = 1.2 * SIZE;
    let corner = (left, middle - 0.5 * height);
    drawing.rectangle(corner, (width, height), Colour::Window, None);
    drawing.text((left + AROUND, middle + 0.35 * SIZE), text, &style);
}

/// The middle of the widest gap between lines of modes in the range; none if no gap has room.
fn free_height(window_hz: [f64; 2], shown: &Shown, axes: &Axes) -> Option<f64> {
    let frame = axes.frame;
    let [bottom, top] = window_hz.map(|hz| axes.y.at(hz).clamp(frame.top, frame.bottom));
    let points = shown.groups.iter().flat_map(|group| group.points.iter());
    let lines = points.map(|[_, hz]| axes.y.at(*hz));
    let mut edges: Vec<f64> = lines.filter(|y| (top..=bottom).contains(y)).collect();
    edges.extend([top, bottom]);
    edges.sort_by(f64::total_cmp);
    let gaps = edges.windows(2).map(|pair| [pair[0], pair[1]]);
    let widest = gaps.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
    let [above, below] = widest;
    (below - above >= 1.5 * SIZE).then_some(0.5 * (above + below))
}
