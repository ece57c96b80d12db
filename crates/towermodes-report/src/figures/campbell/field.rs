//! The fields of a Campbell diagram: operating band, excitations, modes, marks, labels.

use towermodes_analysis::resonance::Campbell;

use crate::figures::chart::end_labels;
use crate::figures::chart::legend::Legend;
use crate::svg::{Anchor, Axes, Colour, Dash, Drawing, Frame, Stroke, TextStyle, text_width};

use super::key::entries;
use super::layout::{ASIDE, Layout, SIZE, TICKS, WIDTH, end_labels};
use super::lines::Shown;
use super::marks::{self, Cluster, clusters};
use super::rays;
use super::shades::{self, operation_places};
use crate::wording::speed_range;

/// Room below the fields for the numbers and the name of the axis.
const BELOW: f64 = 46.0;
/// Radius of the circle at a change of names.
const CHANGE: f64 = 3.0;
/// The approximate number of numbers along the axis of the upper field.
const UPPER_TICKS: usize = 4;

pub(super) fn drawing(campbell: &Campbell, shown: &Shown) -> Drawing {
    let layout = Layout::new(campbell, shown);
    let fields = &layout.fields;
    let clusters: Vec<Vec<Cluster>> = (0..)
        .zip(fields)
        .map(|field| clusters(campbell, shown, field))
        .collect();
    let is_counted = clusters.iter().any(|clusters| marks::are_counted(clusters));
    let entries = entries(campbell, shown, layout.without_label(shown), is_counted);
    let Frame { left, bottom, .. } = fields[0].frame;
    let legend = Legend {
        left_top: (left, bottom + BELOW),
        room: WIDTH - left - 10.0,
        entries,
    };
    let mut drawing = legend.sheet();
    for (index, axes) in fields.iter().enumerate() {
        draw_field(&mut drawing, (campbell, shown), index, axes);
        marks::draw(&mut drawing, &clusters[index]);
        let range = [axes.frame.top, axes.frame.bottom - 4.0];
        let labels = end_labels(campbell, &layout.labels[index], shown, axes);
        end_labels::draw(&mut drawing, axes.frame.right, range, &labels);
    }
    operation(&mut drawing, campbell, fields);
    if let Some(top) = fields.last() {
        rays::upper_ends(&mut drawing, &layout.above, (campbell, shown), top);
    }
    draw_aside(&mut drawing, fields, &layout.aside);
    legend.draw(&mut drawing);
    drawing
}

/// Draws the shades, axes, rays and modes of a field.
fn draw_field(
    drawing: &mut Drawing,
    (campbell, shown): (&Campbell, &Shown),
    index: usize,
    axes: &Axes,
) {
    let frame = axes.frame;
    let (corner, size) = (frame.left_top(), frame.size());
    drawing.clipped(&format!("shades{index}"), corner, size, |drawing| {
        shades::draw(drawing, campbell, shown, axes);
    });
    if index == 0 {
        axes.draw_x(drawing, "rotor speed (rpm)", TICKS);
        axes.draw_y(drawing, "frequency (Hz)", TICKS);
    } else {
        for rpm in axes.x.ticks(TICKS) {
            let x = axes.x.at(rpm);
            let grid = Stroke::new(Colour::Grid, 1.0);
            drawing.line((x, frame.top), (x, frame.bottom), &grid);
        }
        axes.draw_y(drawing, "frequency (Hz)", UPPER_TICKS);
        // Where it ends the scale changes.
        let end = Stroke::new(Colour::Muted, 0.8).dashed(Dash::Dotted);
        drawing.line(
            (frame.left, frame.bottom),
            (frame.right, frame.bottom),
            &end,
        );
    }
    drawing.clipped(&format!("field{index}"), corner, size, |drawing| {
        rays::draw(drawing, campbell, shown, axes);
        modes(drawing, shown, axes);
    });
    if index == 0 {
        shades::name_window(drawing, campbell, shown, axes);
    }
}

/// Writes the number of modes outside the fields, above and below.
fn draw_aside(drawing: &mut Drawing, fields: &[Axes], [above, below]: &[Option<String>; 2]) {
    let style = TextStyle::new(SIZE).colour(Colour::Muted);
    let (Some(lower), Some(upper)) = (fields.first(), fields.last()) else {
        return;
    };
    let x = lower.frame.right + ASIDE;
    let heights = [upper.frame.top - 10.0, lower.frame.bottom + 14.0];
    for (text, y) in [above, below].into_iter().zip(heights) {
        if let Some(text) = text {
            drawing.text((x, y), text, &style);
        }
    }
}

/// Writes the operating speeds above the fields, with a bracket over the operating band.
fn operation(drawing: &mut Drawing, campbell: &Campbell, fields: &[Axes]) {
    let Some(axes) = fields.last() else {
        return;
    };
    if !campbell.speeds_are_known() {
        let place = (axes.frame.left, axes.frame.top - 32.0);
        drawing.text(place, "operating speeds unknown", &TextStyle::new(SIZE));
        return;
    }
    let [from, to] = operation_places(campbell, axes);
    let stroke = Stroke::new(Colour::Muted, 1.0);
    let (above, edge) = (axes.frame.top - 26.0, axes.frame.top - 21.0);
    drawing.polyline(
        &[(from, edge), (from, above), (to, above), (to, edge)],
        &stroke,
    );
    let dashed = stroke.dashed(Dash::Dashed);
    for Frame { top, bottom, .. } in fields.iter().map(|axes| axes.frame) {
        for x in [from, to] {
            drawing.line((x, top), (x, bottom), &dashed);
        }
    }
    let text = format!("operation: {} rpm", speed_range(&campbell.rotor));
    let half = 0.5 * text_width(&text, SIZE, false);
    let middle = (0.5 * (from + to)).clamp(half + 4.0, WIDTH - half - 4.0);
    let style = TextStyle::new(SIZE).anchor(Anchor::Middle);
    drawing.text((middle, above - 6.0), &text, &style);
}

/// Draws the lines of the modes, and circles where curves change their names.
fn modes(drawing: &mut Drawing, shown: &Shown, axes: &Axes) {
    for group in &shown.groups {
        let places: Vec<(f64, f64)> = group
            .points
            .iter()
            .map(|[rpm, hz]| axes.at(*rpm, *hz))
            .collect();
        drawing.polyline(&places, &group.kind.stroke());
        if let Some((marker, colour)) = group.kind.marker() {
            let every = places.len().div_ceil(8).max(1);
            // Not at the ends, where they would be cut.
            for place in places.iter().skip(every.div_ceil(2)).step_by(every) {
                drawing.marker(marker, *place, 3.2, colour);
            }
        }
    }
    for [rpm, hz] in &shown.changes {
        change(drawing, axes.at(*rpm, *hz));
    }
}

/// Draws the circle at a change of names.
fn change(drawing: &mut Drawing, place: (f64, f64)) {
    drawing.disc(
        place,
        CHANGE,
        Colour::Paper,
        Some(&Stroke::new(Colour::Ink, 1.0)),
    );
}
