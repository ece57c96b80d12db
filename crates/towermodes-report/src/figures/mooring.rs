//! The mooring lines of a floating platform, from the side and from above.

use towermodes::{Tower, TowerDescription};

use super::lines::{LineAtRest, LinesAtRest, lines_at_rest};
use super::parts::Parts;
use super::scene::hull;
use super::structure::outline;
use super::symbols::{held_below, waves};
use crate::number::{length, short};
use crate::svg::{Axes, Colour, Dash, DataTable, Drawing, Figure, Frame, Stroke, TextStyle};
use crate::wording::counted;

const WIDTH: f64 = 900.0;
/// The field of the side view extends this far above the water, as a fraction of the depth.
const ABOVE: f64 = 0.12;
/// The field of the side view extends this far below the seabed, as a fraction of the depth.
const BELOW: f64 = 0.1;
/// The fields extend this far beyond the anchors, as a fraction of the largest distance.
const BESIDE: f64 = 0.06;
/// Left edge and width of both fields, room above and below each field.
const LEFT: f64 = 70.0;
const FIELD: f64 = 806.0;
const HEADING: f64 = 30.0;
const FOOT: f64 = 42.0;
/// The smallest and the largest height of a field.
const SIDE: [f64; 2] = [110.0, 420.0];
const PLAN: [f64; 2] = [200.0, 620.0];
/// Half the size of an anchor.
const ANCHOR: f64 = 5.0;

/// The lines of a floating platform at its reference position, from the side and from above, to
/// scale, with anchors, seabed and still water; none without lines.
pub fn mooring(description: &TowerDescription, tower: &Tower) -> Option<Figure> {
    let parts = Parts::new(description, tower);
    let at_rest = lines_at_rest(parts.platform()?.of)?;
    let hull = hull(&parts);
    let all = || {
        at_rest
            .lines
            .iter()
            .flat_map(|line| &line.places_m)
            .chain(&hull)
    };
    let range = |axis: usize| {
        let values = all().map(|place| place[axis]);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
            [low.min(x), high.max(x)]
        })
    };
    let (x, y) = (wider(range(0)), wider(range(1)));
    let depth_m = at_rest.of.description.depth_m;
    let z = [
        at_rest.seabed_m - BELOW * depth_m,
        at_rest.of.still_water_m + ABOVE * depth_m,
    ];
    let mut drawing = Drawing::new(WIDTH, 0.0);
    let side = field(0.0, (x, z), SIDE);
    draw_side(&mut drawing, &side, &at_rest, &hull);
    let plan = field(side.frame.bottom + FOOT, (x, y), PLAN);
    draw_plan(&mut drawing, &plan, &at_rest, &hull);
    drawing.height = plan.frame.bottom + FOOT;
    let count = counted(at_rest.lines.len(), "mooring line");
    Some(Figure {
        name: "mooring".to_owned(),
        title: match tower.name() {
            "" => "The mooring lines".to_owned(),
            name => format!("The mooring lines: {name}"),
        },
        description: format!(
            "{count} at rest from the side and from above; the seabed is {} m below still water.",
            length(depth_m)
        ),
        drawing,
        table: table(&at_rest),
    })
}

/// A range extended on both sides.
fn wider([low, high]: [f64; 2]) -> [f64; 2] {
    let beside = (BESIDE * (high - low)).max(1.0);
    [low - beside, high + beside]
}

/// Axes for two ranges at the same scale, with the upper edge at `top`; the height of the field is
/// limited to a range.
fn field(top: f64, (across, up): ([f64; 2], [f64; 2]), [least, most]: [f64; 2]) -> Axes {
    let size = |range: [f64; 2]| range[1] - range[0];
    let per_m = (FIELD / size(across)).min(most / size(up));
    let height = (per_m * size(up)).max(least);
    let around = |range: [f64; 2], room: f64| {
        let (middle, half) = (0.5 * (range[0] + range[1]), 0.5 * room / per_m);
        [middle - half, middle + half]
    };
    let frame = Frame {
        left: LEFT,
        top: top + HEADING,
        right: LEFT + FIELD,
        bottom: top + HEADING + height,
    };
    Axes::new(
        frame,
        around(across, FIELD),
        around(up, height),
        [false, false],
    )
}

fn heading(drawing: &mut Drawing, axes: &Axes, text: &str) {
    let at = (axes.frame.left, axes.frame.top - 10.0);
    drawing.text(at, text, &TextStyle::new(12.0).bold());
}

fn draw_side(drawing: &mut Drawing, axes: &Axes, of: &LinesAtRest<'_>, hull: &[[f64; 3]]) {
    let Frame {
        left,
        right,
        bottom,
        ..
    } = axes.frame;
    let (water, seabed) = (axes.y.at(of.of.still_water_m), axes.y.at(of.seabed_m));
    let block = |drawing: &mut Drawing, top: f64, bottom: f64, colour| {
        drawing.rectangle((left, top), (right - left, bottom - top), colour, None);
    };
    block(drawing, water, seabed, Colour::Water);
    block(drawing, seabed, bottom, Colour::Soil);
    waves(drawing, left, right, water);
    held_below(drawing, left + 6.0, right, seabed);
    heading(drawing, axes, "from the side");
    draw_things(drawing, axes, (of, hull), 2);
    axes.draw_x(drawing, "x, fore-aft (m)", 8);
    axes.draw_y(drawing, "height z (m)", 5);
}

fn draw_plan(drawing: &mut Drawing, axes: &Axes, of: &LinesAtRest<'_>, hull: &[[f64; 3]]) {
    let Frame {
        left,
        top,
        right,
        bottom,
    } = axes.frame;
    drawing.rectangle(
        (left, top),
        (right - left, bottom - top),
        Colour::Water,
        None,
    );
    heading(drawing, axes, "from above");
    draw_things(drawing, axes, (of, hull), 1);
    axes.draw_x(drawing, "x, fore-aft (m)", 8);
    axes.draw_y(drawing, "y, side-side (m)", 6);
}

/// Draws lines, anchors and the platform over x and another coordinate.
fn draw_things(
    drawing: &mut Drawing,
    axes: &Axes,
    (of, hull): (&LinesAtRest<'_>, &[[f64; 3]]),
    up: usize,
) {
    let place = |point: &[f64; 3]| axes.at(point[0], point[up]);
    for line in &of.lines {
        let places: Vec<(f64, f64)> = line.places_m.iter().map(place).collect();
        drawing.polyline(&places, &Stroke::new(Colour::Series(1), 1.6));
        if let (true, Some([_, _, z])) = (line.is_on_platform, line.places_m.first()) {
            // The hull is nominal: it may not reach the fairlead.
            let arm = Stroke::new(Colour::Muted, 0.8).dashed(Dash::Dashed);
            drawing.line(places[0], place(&[0.0, 0.0, *z]), &arm);
        }
        if let (true, Some(&(x, y))) = (line.is_anchored, places.last()) {
            let anchor = [
                (x - ANCHOR, y + ANCHOR),
                (x + ANCHOR, y + ANCHOR),
                (x, y - ANCHOR),
            ];
            drawing.polygon(&anchor, Colour::Ink, None);
        }
    }
    let corners = outline(hull.iter().map(place).collect());
    drawing.polygon(
        &corners,
        Colour::Steel,
        Some(&Stroke::new(Colour::Ink, 1.0)),
    );
}

/// The lines at rest, line by line.
fn table(of: &LinesAtRest<'_>) -> DataTable {
    let header = [
        "line",
        "length (m)",
        "tension at the upper end (kN)",
        "on the seabed (m)",
        "horizontal distance of the ends (m)",
    ];
    let states = of
        .lines
        .iter()
        .zip(&of.state.lines)
        .zip(&of.of.description.lines);
    let row = |(index, ((line, state), given)): (usize, ((&LineAtRest, _), _))| {
        let state: &towermodes::mooring::LineState = state;
        let given: &towermodes::mooring::MooringLine = given;
        let [a, b] = state.tensions_n;
        vec![
            (index + 1).to_string(),
            length(given.length_m),
            short(1e-3 * a.max(b), 4),
            length(state.on_seabed_m),
            length(span_m(line)),
        ]
    };
    DataTable::new(header, states.enumerate().map(row))
}

fn span_m(line: &LineAtRest) -> f64 {
    match line.places_m[..] {
        [[x, y, _], .., [u, v, _]] => (u - x).hypot(v - y),
        _ => 0.0,
    }
}
