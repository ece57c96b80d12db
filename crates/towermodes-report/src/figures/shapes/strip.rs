//! A row of the figure: the tower and the panels beside it with a common axis of heights.

use super::layout::{HEADING, LEGEND, Placed, SAMPLE, Strip, TICKS, entries};
use crate::figures::parts::Parts;
use crate::figures::tower::{View, draw_small, levels, small_view};
use crate::svg::{Anchor, Axes, Colour, Dash, Drawing, Frame, Stroke, TextStyle, text_width};

/// If there are more point masses, no lines are drawn across the panels.
pub(super) const MOST_MASSES: usize = 40;
/// Largest width of the tower.
const WIDEST: f64 = 40.0;
/// Room below a field for the numbers and the name of its axis.
const BELOW: f64 = 42.0;
/// Panels wider than this have more numbers.
const WIDE: f64 = 140.0;
/// Text size of the names of water and ground.
const SMALL: f64 = 10.0;

/// Draws a row; returns the view of its tower.
pub(super) fn draw_strip<'a>(
    drawing: &mut Drawing,
    strip: &Strip<'_>,
    parts: Parts<'a>,
    index: usize,
) -> View<'a> {
    let note = if strip.has_notes() { LEGEND.1 } else { 0.0 };
    let legend = LEGEND.1 * strip.legend_lines() as f64;
    let frame = Frame {
        left: strip.column[0],
        top: strip.edges[0] + 26.0 + note + legend,
        right: strip.column[1],
        bottom: strip.edges[1] - BELOW,
    };
    let view = small_view(frame, parts, WIDEST);
    let name = format!("strip{index}");
    draw_small(drawing, &view, (&name, TICKS));
    draw_levels(drawing, &view, strip);
    for placed in &strip.panels {
        draw_head(drawing, placed, (strip.edges[0] + 16.0, note));
        draw_field(drawing, placed, &view);
    }
    if strip.panels.is_empty() {
        let at = (strip.column[1] + 20.0, 0.5 * (frame.top + frame.bottom));
        let style = TextStyle::new(HEADING).colour(Colour::Muted);
        drawing.text(at, "no modes", &style);
    }
    view
}

/// Lines across all panels at the water level, the ground and the point masses.
fn draw_levels(drawing: &mut Drawing, view: &View<'_>, strip: &Strip<'_>) {
    let across = |drawing: &mut Drawing, height_m: f64, stroke: &Stroke| {
        for [left, right] in strip.panels.iter().map(|placed| placed.edges) {
            let y = view.y(height_m);
            drawing.line((left, y), (right, y), stroke);
        }
    };
    let style = TextStyle::new(SMALL).anchor(Anchor::End);
    for level in levels(&view.parts) {
        if !view.shows(level.height_m) {
            continue;
        }
        across(drawing, level.height_m, &Stroke::new(level.colour, 1.2));
        let y = view.y(level.height_m);
        let baseline = if level.name == "water" {
            y - 5.0
        } else {
            y + 17.0
        };
        let within = baseline.clamp(view.frame.top + SMALL, view.frame.bottom - 3.0);
        drawing.text((view.frame.right - 3.0, within), level.name, &style);
    }
    let masses = view.parts.tower.point_masses();
    if masses.len() <= MOST_MASSES {
        let dotted = Stroke::new(Colour::Muted, 0.9).dashed(Dash::Dotted);
        for mass in masses {
            across(drawing, mass.height_m, &dotted);
        }
    }
}

/// The heading, the note and the legend above a panel.
fn draw_head(drawing: &mut Drawing, placed: &Placed<'_>, (top, note): (f64, f64)) {
    let panel = placed.panel;
    let [left, right] = placed.edges;
    drawing.text((left, top), panel.heading, &TextStyle::new(HEADING).bold());
    let style = TextStyle::new(LEGEND.0);
    let muted = style.colour(Colour::Muted);
    if let Some(text) = panel.note {
        drawing.text((left, top + LEGEND.1), text, &muted);
    }
    let lines = entries(panel).div_ceil(placed.columns);
    let column = (right - left) / placed.columns as f64;
    let more = (panel.more > 0).then(|| (None, format!("{} more", panel.more)));
    let curves = panel.curves.iter().enumerate();
    let labels = curves.flat_map(|(curve, of)| {
        let labels = of.labels.iter();
        labels.map(move |label| (Some(curve), label.clone()))
    });
    for (k, (curve, label)) in labels.chain(more).enumerate() {
        let x = left + column * (k / lines) as f64;
        let y = top + note + LEGEND.1 * (k % lines + 1) as f64;
        if let Some(curve) = curve {
            let sample = [(x, y - 4.0), (x + SAMPLE - 5.0, y - 4.0)];
            drawing.polyline(&sample, &stroke(curve));
        }
        let style = if curve.is_some() { &style } else { &muted };
        drawing.text((x + SAMPLE, y), &label, style);
    }
}

/// The axes and the curves of a panel.
fn draw_field(drawing: &mut Drawing, placed: &Placed<'_>, view: &View<'_>) {
    let tower = view.parts.tower;
    let [left, right] = placed.edges;
    let frame = Frame {
        left,
        right,
        ..view.frame
    };
    let panel = placed.panel;
    let [low, high] = panel.range;
    let margin = 0.06 * (high - low);
    let axes = Axes::new(
        frame,
        [low - margin, high + margin],
        [view.low_m(), view.high_m],
        [false, false],
    );
    for height_m in axes.y.ticks(TICKS) {
        let y = axes.y.at(height_m);
        drawing.line((left, y), (right, y), &Stroke::new(Colour::Grid, 1.0));
    }
    let fits = |name: &&&str| text_width(name, 12.0, false) <= right - left;
    let name = panel.axis.iter().find(fits).unwrap_or(&panel.axis[1]);
    axes.draw_x(drawing, name, panel.ticks[usize::from(right - left > WIDE)]);
    let at = |(height_m, value): &(f64, f64)| axes.at(*value, *height_m);
    let zero = [(tower.base_m(), 0.0), (tower.top_m(), 0.0)];
    let zero: Vec<(f64, f64)> = zero.iter().map(at).collect();
    drawing.polyline(&zero, &Stroke::new(Colour::Muted, 1.0));
    // The lowest mode last, so that it lies on top.
    for (k, curve) in panel.curves.iter().enumerate().rev() {
        let points: Vec<(f64, f64)> = curve.points.iter().map(at).collect();
        drawing.polyline(&points, &stroke(k));
    }
}

fn stroke(index: usize) -> Stroke {
    Stroke::new(Colour::Series(index), 1.9).dashed(Dash::of_series(index))
}
