//! The field of a Campbell diagram: band of operation, excitations, modes, marks, labels.

use towermodes::Verdict;
use towermodes::rotor::Campbell;

use crate::figures::end_labels::{self, EndLabel};
use crate::figures::legend::{self, Entry, Sample, words};
use crate::svg::{
    Anchor, Axes, Colour, Dash, Drawing, Frame, Marker, Stroke, TextStyle, text_width,
};

use super::above::{above_text, unresisted_text};
use super::lines::{Group, Shown};
use super::marks::{self, clusters};
use super::rays::{self, Labelled, end_hz};
use super::speeds;

const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 560.0;
/// Above the field: the speeds of operation, and excitations that end there.
const TOP: f64 = 52.0;
/// Below the field: numbers and name of the axis.
const BELOW: f64 = 46.0;
const SIZE: f64 = 11.0;
/// The colour of the tower's modes.
const TOWER: Colour = Colour::Series(0);
/// The colour of the blade's modes.
const BLADE: Colour = Colour::Series(1);

/// Most labels of lines of modes beside the diagram.
const LABELS: usize = 20;

pub(super) fn drawing(campbell: &Campbell, shown: &Shown) -> Drawing {
    let mut drawing = Drawing::new(WIDTH, HEIGHT);
    let left = Axes::left_margin([0.0, shown.highest_hz], false, 8);
    let legend_room = WIDTH - left - 10.0;
    let mut frame = Frame {
        left,
        top: TOP,
        right: WIDTH,
        bottom: HEIGHT - BELOW - 6.0,
    };
    let axes = |frame| {
        let (x, y) = ([0.0, shown.last_rpm], [0.0, shown.highest_hz]);
        Axes::new(frame, x, y, [false, false])
    };
    let named = named(campbell, shown);
    let aside = [above_text(campbell, shown), unresisted_text(shown)];
    // What the labels say does not depend on where they are.
    let widths = labels(&named, &shown.multiples, shown, &axes(frame));
    frame.right -= end_labels::column_width(&widths).max(aside_width(&aside));
    let labelled = Labelled::new(campbell, shown, frame.right - left);
    let without_label = [shown.groups.len() - named.len(), labelled.missing(shown)];
    let entries = |is_counted| entries(campbell, shown, without_label, is_counted);
    let above_legend = |is_counted| {
        let height = legend::height(&entries(is_counted), legend_room);
        let bottom = frame.bottom - height;
        Frame { bottom, ..frame }
    };
    // The lowest field has the nearest marks.
    let is_counted = marks::are_counted(&clusters(campbell, shown, &axes(above_legend(true))));
    let frame = above_legend(is_counted);
    let axes = axes(frame);
    let clusters = clusters(campbell, shown, &axes);
    let entries = entries(is_counted);
    let labels = labels(&named, &labelled.right, shown, &axes);
    band(&mut drawing, campbell, &axes);
    axes.draw_x(&mut drawing, "rotor speed (rpm)", 8);
    axes.draw_y(&mut drawing, "frequency (Hz)", 8);
    let size = (frame.right - frame.left, frame.bottom - frame.top);
    drawing.clipped("field", (frame.left, frame.top), size, |drawing| {
        rays::draw(drawing, shown, &axes);
        modes(drawing, shown, &axes);
    });
    marks::draw(&mut drawing, &clusters);
    operation(&mut drawing, campbell, &axes);
    rays::upper_ends(&mut drawing, &labelled.above, shown, &axes);
    let range = [frame.top, frame.bottom - 4.0];
    end_labels::draw(&mut drawing, frame.right, range, &labels);
    draw_aside(&mut drawing, frame, &aside);
    legend::draw(
        &mut drawing,
        (left, frame.bottom + BELOW),
        legend_room,
        &entries,
    );
    drawing
}

/// From the field to what is said of modes that are not in it.
const ASIDE: f64 = 20.0;

fn aside_width(aside: &[Option<String>; 2]) -> f64 {
    let texts = aside.iter().flatten();
    let widths = texts.map(|text| ASIDE + text_width(text, SIZE, false) + 6.0);
    widths.fold(0.0, f64::max)
}

/// Says of modes that are not in the field how many there are, above it and below.
fn draw_aside(drawing: &mut Drawing, frame: Frame, [above, below]: &[Option<String>; 2]) {
    let style = TextStyle::new(SIZE).colour(Colour::Muted);
    let x = frame.right + ASIDE;
    for (text, y) in [(above, frame.top - 10.0), (below, frame.bottom + 14.0)] {
        if let Some(text) = text {
            drawing.text((x, y), text, &style);
        }
    }
}

/// The band of operation; of a rotor of one speed a line.
fn band(drawing: &mut Drawing, campbell: &Campbell, axes: &Axes) {
    let [from, to] = operation_places(campbell, axes);
    let Frame { top, bottom, .. } = axes.frame;
    drawing.rectangle(
        (from, top),
        ((to - from).max(3.0), bottom - top),
        Colour::Band,
        None,
    );
}

fn operation_places(campbell: &Campbell, axes: &Axes) -> [f64; 2] {
    [campbell.rotor.lowest_rpm, campbell.rotor.highest_rpm].map(|rpm| axes.x.at(rpm))
}

/// The speeds of operation above the field, with a bracket over the band.
fn operation(drawing: &mut Drawing, campbell: &Campbell, axes: &Axes) {
    let [from, to] = operation_places(campbell, axes);
    let stroke = Stroke::new(Colour::Muted, 1.0);
    let (above, edge) = (axes.frame.top - 26.0, axes.frame.top - 21.0);
    drawing.polyline(
        &[(from, edge), (from, above), (to, above), (to, edge)],
        &stroke,
    );
    let dashed = stroke.dashed(Dash::Dashed);
    for x in [from, to] {
        drawing.line((x, axes.frame.top), (x, axes.frame.bottom), &dashed);
    }
    let text = format!("operation: {}", speeds(&campbell.rotor));
    let half = 0.5 * text_width(&text, SIZE, false);
    let middle = (0.5 * (from + to)).clamp(half + 4.0, WIDTH - half - 4.0);
    let style = TextStyle::new(SIZE).anchor(Anchor::Middle);
    drawing.text((middle, above - 6.0), &text, &style);
}

fn stroke(group: &Group) -> Stroke {
    if group.is_blade {
        Stroke::new(BLADE, 1.8).dashed(Dash::Dashed)
    } else {
        Stroke::new(TOWER, 2.0)
    }
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

/// The lines that have a label: all, or those that are not passed over in silence, and of the others the lowest.
fn named<'a>(campbell: &Campbell, shown: &'a Shown) -> Vec<&'a Group> {
    let rank = |group: &&Group| {
        let own = campbell.margins.iter();
        let own = own.filter(|margin| group.members.contains(&margin.line));
        std::cmp::Reverse(own.map(|margin| margin.verdict).max())
    };
    let mut named: Vec<&Group> = shown.groups.iter().collect();
    if named.len() > LABELS {
        named.sort_by_cached_key(rank);
        named.truncate(LABELS);
    }
    named
}

/// The labels beside the right end: modes, and excitations that end there.
fn labels(named: &[&Group], multiples: &[usize], shown: &Shown, axes: &Axes) -> Vec<EndLabel> {
    let of_group = |group: &&Group| EndLabel {
        y: axes.y.at(group.points.last().map_or(0.0, |[_, hz]| *hz)),
        text: group.label.clone(),
        colour: stroke(group).colour,
        marker: group.is_blade.then_some(Marker::Disc),
        is_bold: false,
    };
    let of_multiple = |multiple: &usize| EndLabel {
        y: axes.y.at(end_hz(*multiple, shown)),
        text: format!("{multiple}P"),
        colour: Colour::Muted,
        marker: None,
        is_bold: true,
    };
    let groups = named.iter().map(of_group);
    groups.chain(multiples.iter().map(of_multiple)).collect()
}

/// What is in the picture, and how many lines of modes and excitations have no label.
fn entries(
    campbell: &Campbell,
    shown: &Shown,
    [modes, excitations]: [usize; 2],
    is_counted: bool,
) -> Vec<Entry> {
    let mut entries = Vec::new();
    let line = |line: Stroke, marker| Sample {
        line: Some(line),
        marker,
    };
    for (is_blade, text) in [(false, "mode of the tower"), (true, "mode of a blade")] {
        let first = shown.groups.iter().find(|group| group.is_blade == is_blade);
        let marker = is_blade.then_some((Marker::Disc, BLADE));
        entries.extend(first.map(|group| (line(stroke(group), marker), text.to_owned())));
    }
    let mut text = "excitation: nP is n times the rotor's speed".to_owned();
    if shown.more_multiples > 0 {
        text += &format!("; {} more are not drawn", shown.more_multiples);
    }
    entries.push((line(rays::stroke(shown), None), text));
    let without = [(modes, "line", "of modes"), (excitations, "excitation", "")];
    let without = without.iter().filter(|(count, ..)| *count > 0);
    let without = without.map(|(count, noun, of)| {
        let plural = if *count == 1 { "" } else { "s" };
        format!("{count} {noun}{plural} {of} without label").replace("  ", " ")
    });
    entries.extend(without.map(words));
    for (verdict, marker, text) in [
        (
            Verdict::Fail,
            (Marker::Cross, Colour::Fail),
            "too near: FAIL",
        ),
        (
            Verdict::Warn,
            (Marker::Triangle, Colour::Warn),
            "near: WARN",
        ),
    ] {
        let mut all = campbell.margins.iter();
        let has = all.any(|margin| margin.verdict == verdict);
        let sample = Sample {
            line: None,
            marker: Some(marker),
        };
        entries.extend(has.then(|| (sample, text.to_owned())));
    }
    let number = "number above a mark: so many pairs".to_owned();
    entries.extend(is_counted.then(|| words(number)));
    entries
}
