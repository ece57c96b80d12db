//! The whole structure in its modes: tower, frame or platform in space, at rest and deflected.

use towermodes::{Mode, Solution, Tower, TowerDescription};

use super::parts::Parts;
use super::scene::hull;
use super::substructure::{Substructure, largest_translation, moved_along};
use crate::number::{four_digits, length, short};
use crate::svg::{Colour, DataTable, Drawing, Figure, Frame, Stroke, TextStyle, broken};
use crate::wording::counted;

/// Width of the sheet, number of columns of panels, and height of a row.
const WIDTH: f64 = 900.0;
const COLUMNS: usize = 4;
const ROW: f64 = 340.0;
/// Room above a panel for name and frequency, and below the rows.
const HEADING: f64 = 58.0;
const FOOT: f64 = 24.0;
const GAP: f64 = 12.0;
/// Largest number of drawn modes.
const MOST: usize = 12;
/// The largest deflection as a fraction of the height of the structure.
const REACH: f64 = 0.07;
/// View direction: degrees about the tower axis from the upwind side, and above the horizon.
const AZIMUTH_DEG: f64 = 35.0;
const ELEVATION_DEG: f64 = 14.0;
/// Number of points along a member.
const ALONG: usize = 8;

type Point = [f64; 3];

/// A structure with its motion in a mode; at rest without a mode.
struct Deflected<'a> {
    parts: Parts<'a>,
    mode: Option<(&'a Mode, f64)>,
}

impl Deflected<'_> {
    /// The axis of the tower from its base to its top.
    fn tower(&self) -> Vec<Point> {
        let tower = self.parts.tower;
        match self.mode {
            None => vec![[0.0, 0.0, tower.base_m()], [0.0, 0.0, tower.top_m()]],
            Some((mode, scale)) => {
                let points = mode.shape.iter();
                let moved = points.map(|point| {
                    let [x, y, z] = point.translation.map(|u| scale * u);
                    [x, y, point.height_m + z]
                });
                moved.collect()
            }
        }
    }

    /// The axes of the members, about the axis of the tower.
    fn members(&self, substructure: &Substructure<'_>) -> Vec<Vec<Point>> {
        let [x, y, _] = substructure.of.reference_m();
        let shape = self.mode.and_then(|(mode, _)| mode.frame.as_ref());
        let scale = self.mode.map_or(0.0, |(_, scale)| scale);
        let members = substructure.description().members.iter().enumerate();
        let axis = members.map(|(index, member)| {
            let points = shape.map(|shape| shape.along(index, member.joints));
            let points = points.unwrap_or_default();
            let ends_m = substructure.ends_m(member);
            let steps = if shape.is_some() { ALONG } else { 1 };
            let at = |k: usize| {
                let (rest, moved) = moved_along(ends_m, &points, k as f64 / steps as f64);
                let point: Point = std::array::from_fn(|i| rest[i] + scale * moved[i]);
                [point[0] - x, point[1] - y, point[2]]
            };
            (0..=steps).map(at).collect()
        });
        axis.collect()
    }

    /// Points that move with the base of the tower as a rigid body.
    fn on_base(&self, points: &[Point]) -> Vec<Point> {
        let base_m = self.parts.tower.base_m();
        let first = self
            .mode
            .and_then(|(mode, scale)| Some((mode.shape.first()?, scale)));
        let Some((base, scale)) = first else {
            return points.to_vec();
        };
        let (by, turn) = (base.translation, base.rotation.map(|angle| scale * angle));
        let moved = |&[x, y, z]: &Point| {
            let [x, y, z] = turned([x, y, z - base_m], turn);
            [
                x + scale * by[0],
                y + scale * by[1],
                z + base_m + scale * by[2],
            ]
        };
        points.iter().map(moved).collect()
    }

    /// The rigid links of the transition piece: from the base of the tower to its joints.
    fn links(&self, substructure: &Substructure<'_>) -> Vec<[Point; 2]> {
        let Some(transition) = &substructure.description().transition else {
            return Vec::new();
        };
        let [x, y, _] = substructure.of.reference_m();
        let moved = self
            .mode
            .and_then(|(mode, scale)| Some((mode.frame.as_ref()?, scale)));
        let base = self.tower().first().copied().unwrap_or_default();
        let to = |&joint: &usize| {
            let at_m = substructure.description().joints[joint].position_m;
            let [dx, dy, dz] = moved.map_or([0.0; 3], |(shape, scale)| {
                std::array::from_fn(|i| scale * shape.joints[joint][i])
            });
            [base, [at_m[0] - x + dx, at_m[1] - y + dy, at_m[2] + dz]]
        };
        transition.joints.iter().map(to).collect()
    }
}

/// A vector rotated by a rotation vector, rad: a body stays rigid for any enlargement of its motion
/// (Rodrigues' formula).
fn turned([x, y, z]: Point, [a, b, c]: Point) -> Point {
    let angle = (a * a + b * b + c * c).sqrt();
    let sinc = if angle > 0.0 {
        angle.sin() / angle
    } else {
        1.0
    };
    let half = 0.5 * angle;
    let versed = if angle > 0.0 {
        (half.sin() / half).powi(2) / 2.0
    } else {
        0.5
    };
    let cross = |[x, y, z]: Point| [b * z - c * y, c * x - a * z, a * y - b * x];
    let once = cross([x, y, z]);
    let twice = cross(once);
    std::array::from_fn(|i| [x, y, z][i] + sinc * once[i] + versed * twice[i])
}

/// The positions of points on a panel.
struct Projection {
    right: Point,
    up: Point,
    per_m: f64,
    /// Coordinates of the middle of the panel, and its position on the sheet.
    middle: (f64, f64),
    at: (f64, f64),
}

impl Projection {
    /// A projection by which points fit a panel of this size.
    fn new(points: &[Point], (width, height): (f64, f64)) -> Self {
        let (s, c) = (AZIMUTH_DEG + 180.0).to_radians().sin_cos();
        let (se, ce) = ELEVATION_DEG.to_radians().sin_cos();
        let mut projection = Self {
            right: [-s, c, 0.0],
            up: [-c * se, -s * se, ce],
            per_m: 1.0,
            middle: (0.0, 0.0),
            at: (0.0, 0.0),
        };
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            let (x, y) = projection.flat(point);
            (low[0], low[1]) = (low[0].min(x), low[1].min(y));
            (high[0], high[1]) = (high[0].max(x), high[1].max(y));
        }
        let size = |i: usize| (high[i] - low[i]).max(1e-9);
        projection.per_m = (width / size(0)).min(height / size(1));
        projection.middle = (0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]));
        projection
    }

    fn flat(&self, point: &Point) -> (f64, f64) {
        let dot = |axis: &Point| axis.iter().zip(point).map(|(a, p)| a * p).sum::<f64>();
        (dot(&self.right), dot(&self.up))
    }

    fn place(&self, point: &Point) -> (f64, f64) {
        let (x, y) = self.flat(point);
        let (dx, dy) = (x - self.middle.0, y - self.middle.1);
        (self.at.0 + dx * self.per_m, self.at.1 - dy * self.per_m)
    }

    fn places(&self, points: &[Point]) -> Vec<(f64, f64)> {
        points.iter().map(|point| self.place(point)).collect()
    }
}

/// The tower with the frame or the platform under it in its modes, as seen from the front and from
/// above: at rest in grey, deflected in colour. At most twelve modes are drawn; the largest
/// deflection of each is 7 % of the height of the structure.
pub fn structure(description: &TowerDescription, tower: &Tower, solution: &Solution) -> Figure {
    let parts = Parts::new(description, tower);
    let hull = hull(&parts);
    let height_m = tower.top_m() - lowest_m(&parts, &hull);
    let drawn: Vec<&Mode> = solution.modes.iter().take(MOST).collect();
    let rows = drawn.len().div_ceil(COLUMNS).max(1);
    let height = (rows as f64 * ROW + FOOT).max(400.0);
    let mut drawing = Drawing::new(WIDTH, height);
    let deflected = |mode: &'_ Mode| {
        let largest = largest_translation(mode).max(largest_of_hull(parts, mode, &hull));
        let scale = if largest > 0.0 {
            REACH * height_m / largest
        } else {
            0.0
        };
        scale * sign(mode)
    };
    let mut projection = Projection::new(&room(&parts, &hull, REACH * height_m), panel_size());
    for (index, mode) in drawn.iter().enumerate() {
        let frame = panel(index);
        let style = TextStyle::new(12.0);
        let name = format!("{}. {}", mode.number, mode.label());
        let lines = broken(&name, frame.right - frame.left, &style.bold(), 2);
        for (index, line) in lines.iter().rev().enumerate() {
            let y = frame.top - 24.0 - 15.0 * index as f64;
            drawing.text((frame.left, y), line, &style.bold());
        }
        let frequency = format!("{} Hz", four_digits(mode.frequency_hz));
        drawing.text(
            (frame.left, frame.top - 9.0),
            &frequency,
            &style.colour(Colour::Muted),
        );
        projection.at = (
            0.5 * (frame.left + frame.right),
            0.5 * (frame.top + frame.bottom),
        );
        draw_levels(&mut drawing, &projection, &parts, frame);
        let moving = Some((*mode, deflected(mode)));
        for mode in [None, moving] {
            draw(&mut drawing, &projection, &Deflected { parts, mode }, &hull);
        }
    }
    draw_note(&mut drawing, solution.modes.len());
    Figure {
        name: "structure".to_owned(),
        title: title(tower, drawn.len()),
        description: words(&parts, &drawn),
        drawing,
        table: table(&parts, &drawn),
    }
}

fn title(tower: &Tower, modes: usize) -> String {
    let what = match modes {
        1 => "The structure in its lowest mode".to_owned(),
        count => format!("The structure in its lowest {count} modes"),
    };
    match tower.name() {
        "" => what,
        name => format!("{what}: {name}"),
    }
}

fn panel_size() -> (f64, f64) {
    let frame = panel(0);
    let (width, height) = frame.size();
    (width - 4.0, height - 4.0)
}

fn panel(index: usize) -> Frame {
    let width = (WIDTH - GAP) / COLUMNS as f64;
    let left = GAP + width * (index % COLUMNS) as f64;
    let top = ROW * (index / COLUMNS) as f64;
    Frame {
        left,
        top: top + HEADING,
        right: left + width - GAP,
        bottom: top + ROW - 6.0,
    }
}

/// The sign for which the largest translation of the tower points to the right or upwards in the
/// picture.
fn sign(mode: &Mode) -> f64 {
    let top = mode
        .shape
        .last()
        .map_or([0.0; 3], |point| point.translation);
    let largest = top.iter().fold(
        0.0_f64,
        |most, u| {
            if u.abs() > most.abs() { *u } else { most }
        },
    );
    if largest < 0.0 { -1.0 } else { 1.0 }
}

/// The largest translation of a hull in a mode, in the scale of the mode shape.
fn largest_of_hull(parts: Parts<'_>, mode: &Mode, hull: &[Point]) -> f64 {
    let mode = Some((mode, 1.0));
    let moved = Deflected { parts, mode }.on_base(hull);
    let far = |(a, b): (&Point, &Point)| {
        let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
        squares.sum::<f64>().sqrt()
    };
    moved.iter().zip(hull).map(far).fold(0.0, f64::max)
}

fn lowest_m(parts: &Parts<'_>, hull: &[Point]) -> f64 {
    let keel_m = hull.iter().map(|point| point[2]);
    keel_m.fold(parts.foot_m(), f64::min)
}

/// The points that must fit a panel: the structure at rest, with the largest deflection around it.
fn room(parts: &Parts<'_>, hull: &[Point], reach_m: f64) -> Vec<Point> {
    let at_rest = Deflected {
        parts: *parts,
        mode: None,
    };
    let substructure = parts.substructure();
    let members = substructure.map_or_else(Vec::new, |frame| at_rest.members(&frame));
    let around = |point: &Point| {
        let moved = |axis: usize, by: f64| {
            std::array::from_fn(|i| point[i] + if i == axis { by } else { 0.0 })
        };
        (0..3)
            .flat_map(|axis| [moved(axis, -reach_m), moved(axis, reach_m)])
            .collect::<Vec<Point>>()
    };
    let all = at_rest
        .tower()
        .into_iter()
        .chain(members.into_iter().flatten());
    all.chain(hull.iter().copied())
        .flat_map(|point| around(&point))
        .collect()
}

/// Draws lines where the axis of the tower intersects the water surface and the ground.
fn draw_levels(drawing: &mut Drawing, projection: &Projection, parts: &Parts<'_>, frame: Frame) {
    let levels = [
        (parts.water_m(), Colour::Series(0)),
        (parts.ground_m(), Colour::Muted),
    ];
    for (height_m, colour) in levels {
        let y = height_m.map(|height_m| projection.place(&[0.0, 0.0, height_m]).1);
        if let Some(y) = y.filter(|y| (frame.top..frame.bottom).contains(y)) {
            drawing.line((frame.left, y), (frame.right, y), &Stroke::new(colour, 0.8));
        }
    }
}

fn draw(drawing: &mut Drawing, projection: &Projection, of: &Deflected<'_>, hull: &[Point]) {
    let (colour, thick, thin) = match of.mode {
        Some(_) => (Colour::Series(1), 2.6, 1.2),
        None => (Colour::Grid, 2.6, 1.2),
    };
    let line = |width| Stroke::new(colour, width);
    if !hull.is_empty() {
        let mut outline = outline(projection.places(&of.on_base(hull)));
        outline.extend(outline.first().copied());
        drawing.polyline(&outline, &line(1.6));
    }
    if let Some(substructure) = of.parts.substructure() {
        for member in of.members(&substructure) {
            drawing.polyline(&projection.places(&member), &line(thin));
        }
        for link in of.links(&substructure) {
            drawing.polyline(&projection.places(&link), &line(thin));
        }
    }
    let tower = projection.places(&of.tower());
    drawing.polyline(&tower, &line(thick));
    if let (Some(_), Some(top)) = (of.parts.rna(), tower.last()) {
        drawing.disc(*top, 4.5, colour, None);
    }
}

/// The smallest convex polygon around points (Andrew's monotone chain).
pub(super) fn outline(mut places: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    places.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let half = |places: &mut dyn Iterator<Item = &(f64, f64)>| {
        let mut chain: Vec<(f64, f64)> = Vec::new();
        for &(x, y) in places {
            while let [.., a, b] = chain[..]
                && (b.0 - a.0) * (y - a.1) - (b.1 - a.1) * (x - a.0) <= 0.0
            {
                chain.pop();
            }
            chain.push((x, y));
        }
        chain.pop();
        chain
    };
    let mut around = half(&mut places.iter());
    around.extend(half(&mut places.iter().rev()));
    around
}

fn draw_note(drawing: &mut Drawing, modes: usize) {
    let mut note = "Seen from upwind and a little above, to scale. Grey: at rest; disc: RNA. The largest deflection of each mode is drawn as 7 % of the height."
        .to_owned();
    if modes > MOST {
        note.push_str(&format!(" {} more.", counted(modes - MOST, "mode")));
    }
    let style = TextStyle::new(10.0).colour(Colour::Muted);
    drawing.text((GAP, drawing.height - 8.0), &note, &style);
}

fn words(parts: &Parts<'_>, modes: &[&Mode]) -> String {
    let below = match (parts.substructure(), parts.platform()) {
        (Some(frame), _) => format!(
            "The tower on a frame of {}",
            counted(frame.description().members.len(), "member")
        ),
        (_, Some(_)) => "The tower on its floating platform".to_owned(),
        _ => "The tower".to_owned(),
    };
    let names = modes.iter();
    let names =
        names.map(|mode| format!("{} at {} Hz", mode.label(), four_digits(mode.frequency_hz)));
    let names: Vec<String> = names.collect();
    format!(
        "{below}, at rest and deflected in each mode: {}.",
        names.join("; ")
    )
}

/// The position of the largest motion in each mode.
fn table(parts: &Parts<'_>, modes: &[&Mode]) -> DataTable {
    let header = ["mode", "frequency (Hz)", "largest motion", "x", "y", "z"];
    let row = |mode: &&Mode| {
        let (place, motion) = largest(parts, mode);
        let size = motion.iter().map(|u| u * u).sum::<f64>().sqrt();
        let share = |u: f64| short(if size > 0.0 { u / size } else { 0.0 }, 3);
        let [x, y, z] = motion.map(share);
        vec![mode.label(), four_digits(mode.frequency_hz), place, x, y, z]
    };
    DataTable::new(header, modes.iter().map(row))
}

/// The position of the largest motion, and its translation.
fn largest(parts: &Parts<'_>, mode: &Mode) -> (String, Point) {
    let size = |u: &Point| u.iter().map(|x| x * x).sum::<f64>();
    let mut most = (String::new(), [0.0; 3]);
    let mut consider = |place: &dyn Fn() -> String, u: Point| {
        if size(&u) > size(&most.1) * (1.0 + 1e-9) {
            most = (place(), u);
        }
    };
    for point in &mode.shape {
        let place = || format!("tower at z = {} m", length(point.height_m));
        consider(&place, point.translation);
    }
    if let (Some(frame), Some(shape)) = (parts.substructure(), &mode.frame) {
        let description = frame.description();
        for (joint, [x, y, z, ..]) in description.joints.iter().zip(&shape.joints) {
            consider(&|| format!("joint {}", joint.name), [*x, *y, *z]);
        }
        for (member, points) in description.members.iter().zip(&shape.members) {
            for point in points {
                consider(&|| format!("member {}", member.name), *point);
            }
        }
    }
    most
}
