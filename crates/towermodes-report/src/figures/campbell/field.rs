//! The fields of a Campbell diagram: band of operation, excitations, modes, marks, labels.

use towermodes::rotor::Campbell;

use crate::figures::end_labels::{self, EndLabel, GAP};
use crate::figures::legend;
use crate::svg::{
    Anchor, Axes, Colour, Dash, Drawing, Frame, Marker, Stroke, TextStyle, text_width,
};

use super::above::{above_text, unresisted_text};
use super::key::{BLADE, entries, stroke};
use super::lines::{Group, Shown};
use super::marks::{self, Cluster, clusters};
use super::rays::{self, Labelled, end_hz};
use super::shades::{self, operation_places};
use super::speeds;

const WIDTH: f64 = 900.0;
/// Height of the field, of the lower one of two, and the least and most of the upper one.
const ALONE: f64 = 400.0;
const LOWER: f64 = 340.0;
const UPPER: [f64; 2] = [130.0, 240.0];
/// Between two fields.
const BETWEEN: f64 = 14.0;
/// Above the fields: the speeds of operation, and excitations that end there.
const TOP: f64 = 52.0;
/// Below the fields: numbers and name of the axis.
const BELOW: f64 = 46.0;
/// Below the legend.
const FOOT: f64 = 6.0;
const SIZE: f64 = 11.0;
/// About so many numbers along an axis, and along that of the upper field.
const TICKS: usize = 8;
const UPPER_TICKS: usize = 4;

/// The labels beside a field.
struct Labels<'a> {
    groups: Vec<&'a Group>,
    multiples: Vec<usize>,
}

pub(super) fn drawing(campbell: &Campbell, shown: &Shown) -> Drawing {
    let margins = shown
        .ends_hz
        .iter()
        .map(|end_hz| Axes::left_margin([0.0, *end_hz], false, TICKS));
    let left = margins.fold(0.0, f64::max);
    let aside = [above_text(campbell, shown), unresisted_text(shown)];
    let all_labels = labels(campbell, shown, WIDTH - left);
    let widths = all_labels.iter().map(|labels| {
        // What the labels say does not depend on where they are.
        let axes = axes(
            Frame {
                left,
                top: 0.0,
                right: WIDTH,
                bottom: 1.0,
            },
            0,
            shown,
        );
        end_labels::column_width(&end_labels(campbell, labels, shown, &axes))
    });
    let right = WIDTH - widths.fold(aside_width(&aside), f64::max);
    let fields = fields(&all_labels, [left, right], shown);
    let clusters: Vec<Vec<Cluster>> = (0..)
        .zip(&fields)
        .map(|field| clusters(campbell, shown, field))
        .collect();
    let is_counted = clusters.iter().any(|clusters| marks::are_counted(clusters));
    let labelled: usize = all_labels.iter().map(|labels| labels.groups.len()).sum();
    let above = Labelled::new(campbell, shown, right - left).above;
    let rays: usize = all_labels.iter().map(|labels| labels.multiples.len()).sum();
    let without_label = [
        shown.groups.len() - labelled,
        shown.multiples.len() - rays - above.len(),
    ];
    let entries = entries(campbell, shown, without_label, is_counted);
    let bottom = fields[0].frame.bottom + BELOW;
    let legend_room = WIDTH - left - 10.0;
    let height = bottom + legend::height(&entries, legend_room) + FOOT;
    let mut drawing = Drawing::new(WIDTH, height);
    for (index, axes) in fields.iter().enumerate() {
        draw_field(&mut drawing, (campbell, shown), index, axes);
        marks::draw(&mut drawing, &clusters[index]);
        let range = [axes.frame.top, axes.frame.bottom - 4.0];
        let labels = end_labels(campbell, &all_labels[index], shown, axes);
        end_labels::draw(&mut drawing, right, range, &labels);
    }
    operation(&mut drawing, campbell, &fields);
    if let Some(top) = fields.last() {
        rays::upper_ends(&mut drawing, &above, (campbell, shown), top);
    }
    draw_aside(&mut drawing, &fields, &aside);
    legend::draw(&mut drawing, (left, bottom), legend_room, &entries);
    drawing
}

/// The fields from the lowest.
fn fields(labels: &[Labels<'_>], [left, right]: [f64; 2], shown: &Shown) -> Vec<Axes> {
    let field = |index: usize, top: f64, height: f64| {
        let bottom = top + height;
        axes(
            Frame {
                left,
                top,
                right,
                bottom,
            },
            index,
            shown,
        )
    };
    match labels {
        [_, upper] => {
            let height = (count(upper) as f64 * GAP).clamp(UPPER[0], UPPER[1]);
            let lower = field(0, TOP + height + BETWEEN, LOWER);
            vec![lower, field(1, TOP, height)]
        }
        _ => vec![field(0, TOP, ALONE)],
    }
}

fn count(labels: &Labels<'_>) -> usize {
    labels.groups.len() + labels.multiples.len()
}

/// The axes of a field, counted from the lowest: where it ends the next begins.
fn axes(frame: Frame, index: usize, shown: &Shown) -> Axes {
    let end = |index: Option<usize>| index.and_then(|index| shown.ends_hz.get(index).copied());
    let from_hz = end(index.checked_sub(1)).unwrap_or(0.0);
    let to_hz = end(Some(index)).unwrap_or(1.0);
    Axes::new(
        frame,
        [0.0, shown.last_rpm],
        [from_hz, to_hz],
        [false, false],
    )
}

/// Shades, axes, rays and modes of a field.
fn draw_field(
    drawing: &mut Drawing,
    (campbell, shown): (&Campbell, &Shown),
    index: usize,
    axes: &Axes,
) {
    let frame = axes.frame;
    let corner = (frame.left, frame.top);
    let size = (frame.right - frame.left, frame.bottom - frame.top);
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

/// From the field to what is said of modes that are not in it.
const ASIDE: f64 = 20.0;

fn aside_width(aside: &[Option<String>; 2]) -> f64 {
    let texts = aside.iter().flatten();
    let widths = texts.map(|text| ASIDE + text_width(text, SIZE, false) + 6.0);
    widths.fold(0.0, f64::max)
}

/// Says of modes that are not in the fields how many there are, above and below.
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

/// The speeds of operation above the fields, with a bracket over the band.
fn operation(drawing: &mut Drawing, campbell: &Campbell, fields: &[Axes]) {
    let Some(axes) = fields.last() else {
        return;
    };
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
    let text = format!("operation: {}", speeds(&campbell.rotor));
    let half = 0.5 * text_width(&text, SIZE, false);
    let middle = (0.5 * (from + to)).clamp(half + 4.0, WIDTH - half - 4.0);
    let style = TextStyle::new(SIZE).anchor(Anchor::Middle);
    drawing.text((middle, above - 6.0), &text, &style);
}

fn modes(drawing: &mut Drawing, shown: &Shown, axes: &Axes) {
    for group in &shown.groups {
        let places: Vec<(f64, f64)> = group
            .points
            .iter()
            .map(|[rpm, hz]| axes.at(*rpm, *hz))
            .collect();
        drawing.polyline(&places, &stroke(group));
        if group.is_blade {
            let every = places.len().div_ceil(8).max(1);
            // Not at the ends, where they would be cut.
            for place in places.iter().skip(every.div_ceil(2)).step_by(every) {
                drawing.marker(Marker::Disc, *place, 3.2, BLADE);
            }
        }
    }
}

/// The labels beside each field, as many as it has room for.
fn labels<'a>(campbell: &Campbell, shown: &'a Shown, width: f64) -> Vec<Labels<'a>> {
    let right = Labelled::new(campbell, shown, width).right;
    let of_field = |field: usize| {
        let room = match (shown.ends_hz.len(), field) {
            (1, _) => ALONE,
            (_, 0) => LOWER,
            _ => UPPER[1],
        };
        let room = (room / GAP) as usize;
        let end = |multiple: &usize| shown.field_of(end_hz(*multiple, shown)) == field;
        let multiples: Vec<usize> = right.iter().copied().filter(end).take(room).collect();
        let last_hz = |group: &Group| group.points.last().map_or(0.0, |[_, hz]| *hz);
        let groups = shown.groups.iter();
        let groups = groups.filter(|group| shown.field_of(last_hz(group)) == field);
        Labels {
            groups: foremost(campbell, groups.collect(), room - multiples.len()),
            multiples,
        }
    };
    (0..shown.ends_hz.len()).map(of_field).collect()
}

/// So many groups: all, or those that are not passed over in silence, and of the others the lowest.
fn foremost<'a>(campbell: &Campbell, mut groups: Vec<&'a Group>, most: usize) -> Vec<&'a Group> {
    let rank = |group: &&Group| {
        let own = campbell.margins.iter();
        let own = own.filter(|margin| group.members.contains(&margin.line));
        std::cmp::Reverse(own.map(|margin| margin.verdict).max())
    };
    if groups.len() > most {
        groups.sort_by_cached_key(rank);
        groups.truncate(most);
    }
    groups
}

/// The labels beside the right end of a field: modes, and excitations that end there.
fn end_labels(
    campbell: &Campbell,
    labels: &Labels<'_>,
    shown: &Shown,
    axes: &Axes,
) -> Vec<EndLabel> {
    let of_group = |group: &&Group| EndLabel {
        y: axes.y.at(group.points.last().map_or(0.0, |[_, hz]| *hz)),
        text: group.label.clone(),
        colour: stroke(group).colour,
        marker: group.is_blade.then_some(Marker::Disc),
        is_bold: false,
    };
    let of_multiple = |multiple: &usize| {
        let is_strong = rays::is_strong(campbell, *multiple);
        EndLabel {
            y: axes.y.at(end_hz(*multiple, shown)),
            text: rays::text(*multiple),
            colour: rays::stroke(shown, is_strong).colour,
            marker: None,
            is_bold: is_strong,
        }
    };
    let groups = labels.groups.iter().map(of_group);
    groups
        .chain(labels.multiples.iter().map(of_multiple))
        .collect()
}
