//! The jacket of a windIO file: legs, X-braces and mud braces, clamped at the feet.
//!
//! Sources: the schemas of windIO 1.0 and 2.x; WISDEM (NREL), which reads these keys, for the
//! levels of the braces.

use towermodes::frame::{
    Frame, FrameDescription, FrameFoundation, FrameJoint, FrameMember, FrameSupport, Transition,
};
use towermodes::{Foundation, Material, RigidBody, TowerDescription, tower::Tube};

use super::support::materials::Materials;
use super::support::water::in_air;
use super::text::known_keys::note_jacket;
use super::text::outline::Outline;
use super::text::reading::Reading;
use super::text::yaml::{Node, Value};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::number::Rounded;

/// Largest number of legs or bays of a jacket.
const MOST: f64 = 100.0;
/// If the feet are farther than this from the seabed, m, there is a note.
const NEAR_M: f64 = 1.0;
/// Relative heights of the lowest and the highest level of braces if the file has none, as in
/// WISDEM.
const BRACED: [f64; 2] = [0.1, 0.9];

/// Adds the jacket of the file below a tower whose base is at a height (m).
pub(super) fn stand(
    outline: &Outline,
    base_m: f64,
    description: &mut TowerDescription,
    reading: &mut Reading<'_>,
) -> Result<(), Diagnostic> {
    let components = outline.components.as_ref();
    let Some(node) = components.and_then(|all| all.jacket.as_ref()) else {
        return Ok(());
    };
    let others = components.map_or([None, None], |all| {
        [
            all.monopile.as_ref().map(|_| "monopile"),
            all.floating_platform.as_ref().map(|_| "floating_platform"),
        ]
    });
    if let Some(other) = others.into_iter().flatten().next() {
        let message = format!("the file has a jacket and a {other} under the tower");
        let kind = DiagnosticKind::Contradiction(message);
        let hint = "remove one of them; or read only the tower (--part tower)";
        return Err(Diagnostic::new(node.span.clone(), kind).with_hint(hint));
    }
    note_jacket(node, reading);
    let jacket = Jacket::read(node, base_m, outline, reading)?;
    let mass = node.get("transition_piece_mass");
    let mass_kg = mass.map(|mass| mass.mass_kg("mass of the transition piece"));
    let transition = RigidBody::point(mass_kg.transpose()?.unwrap_or_default(), [0.0; 3]);
    let wrong = |error| {
        let kind = DiagnosticKind::Frame(Box::new(error));
        Diagnostic::new(node.span.clone(), kind)
    };
    let frame = Frame::new(jacket.frame()).map_err(wrong)?;
    let foundation = FrameFoundation::new(frame, transition).map_err(wrong)?;
    description.foundation = Foundation::Frame(Box::new(foundation));
    note_place(outline, &jacket, node, reading)
}

/// The dimensions of a jacket.
struct Jacket {
    legs: usize,
    foot_m: [f64; 2],
    /// Radius and height of the leg heads, where the tower begins, m.
    head_m: [f64; 2],
    leg: Tube,
    /// The braces of each bay, from below.
    braces: Vec<Tube>,
    /// Relative heights of the levels that separate the bays.
    levels: Vec<f64>,
    has_mud_braces: bool,
    material: Material,
}

impl Jacket {
    fn read(
        node: &Node,
        top_m: f64,
        outline: &Outline,
        reading: &mut Reading<'_>,
    ) -> Result<Self, Diagnostic> {
        let legs = count(node, "n_legs", 3.0)?;
        let bays = count(node, "n_bays", 1.0)?;
        let length = |key: &str| positive(node.require(key, "the jacket").map_err(hint)?, key);
        let height_m = length("height")?;
        let radii_m = [length("r_foot")?, length("r_head")?];
        let leg = tube(
            length("leg_diameter")?,
            length("leg_thickness")?,
            node,
            "leg",
        )?;
        let each = |key: &str| lengths(node.require(key, "the jacket").map_err(hint)?, key, bays);
        let walls = each("brace_thicknesses")?.into_iter();
        let braces = each("brace_diameters")?.into_iter().zip(walls);
        let braces = braces.map(|(outer, wall)| tube(outer, wall, node, "brace"));
        Ok(Self {
            legs,
            foot_m: [radii_m[0], top_m - height_m],
            head_m: [radii_m[1], top_m],
            leg,
            braces: braces.collect::<Result<_, _>>()?,
            levels: levels(node.get("bay_spacing"), bays, reading)?,
            has_mud_braces: mud_braces(node)?,
            material: material(node, outline, reading)?,
        })
    }

    /// A point of a leg at a relative height.
    fn point_m(&self, leg: usize, level: f64) -> [f64; 3] {
        let blend = |i: usize| self.foot_m[i] + level * (self.head_m[i] - self.foot_m[i]);
        let angle = std::f64::consts::TAU * leg as f64 / self.legs as f64;
        let (sin, cos) = angle.sin_cos();
        [blend(0) * cos, blend(0) * sin, blend(1)]
    }

    /// The crossing of the X-brace of a bay between a leg and the next leg.
    fn crossing_m(&self, leg: usize, bay: usize) -> [f64; 3] {
        let levels = [self.levels[bay], self.levels[bay + 1]];
        let radii = levels.map(|s| self.foot_m[0] + s * (self.head_m[0] - self.foot_m[0]));
        // Both diagonals of a symmetric trapezoid are divided in the ratio of its parallel sides.
        let share = radii[0] / (radii[0] + radii[1]);
        let (from, to) = (
            self.point_m(leg, levels[0]),
            self.point_m(leg + 1, levels[1]),
        );
        std::array::from_fn(|i| from[i] + share * (to[i] - from[i]))
    }

    /// All relative heights at which legs have joints: feet, levels of braces, heads.
    fn heights(&self) -> Vec<f64> {
        let mut heights = vec![0.0];
        heights.extend(self.levels.iter().filter(|s| **s > 0.0 && **s < 1.0));
        heights.push(1.0);
        heights
    }

    fn frame(&self) -> FrameDescription {
        let heights = self.heights();
        let on_leg = |leg: usize, k: usize| (leg % self.legs) * heights.len() + k;
        let level = |bay: usize| bay + usize::from(self.levels[0] > 0.0);
        let mut frame = FrameDescription::default();
        for leg in 0..self.legs {
            for (k, height) in heights.iter().enumerate() {
                let name = format!("leg {} joint {}", leg + 1, k + 1);
                let joint = FrameJoint::new(name, self.point_m(leg, *height));
                frame.joints.push(joint);
            }
            for k in 1..heights.len() {
                let joints = [on_leg(leg, k - 1), on_leg(leg, k)];
                self.add(
                    &mut frame,
                    format!("leg {} part {k}", leg + 1),
                    joints,
                    self.leg,
                );
            }
            frame.supports.push(FrameSupport::clamped(on_leg(leg, 0)));
        }
        for (bay, brace) in self.braces.iter().enumerate() {
            for leg in 0..self.legs {
                let face = format!("bay {} face {}", bay + 1, leg + 1);
                let crossing = frame.joints.len();
                let joint = FrameJoint::new(format!("{face} crossing"), self.crossing_m(leg, bay));
                frame.joints.push(joint);
                let (low, high) = (level(bay), level(bay + 1));
                let corners = [(leg, low), (leg + 1, high), (leg + 1, low), (leg, high)];
                for (part, (leg, k)) in corners.into_iter().enumerate() {
                    let name = format!("{face} brace part {}", part + 1);
                    self.add(&mut frame, name, [crossing, on_leg(leg, k)], *brace);
                }
            }
        }
        if let Some(brace) = self.braces.first().filter(|_| self.has_mud_braces) {
            for leg in 0..self.legs {
                let joints = [on_leg(leg, level(0)), on_leg(leg + 1, level(0))];
                self.add(&mut frame, format!("mud brace {}", leg + 1), joints, *brace);
            }
        }
        frame.transition = Some(Transition {
            position_m: [0.0, 0.0, self.head_m[1]],
            joints: (0..self.legs)
                .map(|leg| on_leg(leg, heights.len() - 1))
                .collect(),
            is_held: false,
        });
        frame
    }

    fn add(&self, frame: &mut FrameDescription, name: String, joints: [usize; 2], tube: Tube) {
        let member = FrameMember::tube(name, joints, [tube; 2], self.material);
        frame.members.push(member);
    }
}

/// Adds a suggestion to the mistake of a missing dimension.
fn hint(diagnostic: Diagnostic) -> Diagnostic {
    diagnostic.with_hint(
        "a jacket has n_legs, n_bays, r_foot, r_head, height, leg_diameter, leg_thickness, and brace_diameters and brace_thicknesses with a value for each bay; --clamped solves the tower alone",
    )
}

fn count(node: &Node, key: &str, least: f64) -> Result<usize, Diagnostic> {
    let value = node.require(key, "the jacket").map_err(hint)?;
    let found = value.number(key)?;
    match found.fract() == 0.0 && (least..=MOST).contains(&found) {
        true => Ok(found as usize),
        false => {
            let rule = format!("a whole number from {least} to {MOST}");
            let kind = DiagnosticKind::out_of_range(key, found, rule);
            Err(Diagnostic::new(value.span.clone(), kind))
        }
    }
}

fn positive(node: &Node, what: &str) -> Result<f64, Diagnostic> {
    let value = node.number(what)?;
    match value > 0.0 && value < 1e4 {
        true => Ok(value),
        false => {
            let kind = DiagnosticKind::out_of_range_in(what, value, "m", "positive, below 10 km");
            Err(Diagnostic::new(node.span.clone(), kind))
        }
    }
}

fn tube(outer: f64, wall: f64, node: &Node, what: &str) -> Result<Tube, Diagnostic> {
    if 2.0 * wall > outer {
        let rule = format!("at most half the diameter of {outer} m");
        let what = format!("the wall thickness of a {what}");
        let kind = DiagnosticKind::out_of_range_in(what, wall, "m", rule);
        return Err(Diagnostic::new(node.span.clone(), kind));
    }
    Ok(Tube {
        outer_diameter_m: outer,
        wall_thickness_m: wall,
    })
}

/// A list of this many positive lengths, m.
fn lengths(node: &Node, what: &str, bays: usize) -> Result<Vec<f64>, Diagnostic> {
    let list = node.list(what)?;
    if list.len() != bays {
        let kind = DiagnosticKind::wrong_count(what, list.len(), bays);
        let hint = "one value for each bay (n_bays), from below";
        return Err(Diagnostic::new(node.span.clone(), kind).with_hint(hint));
    }
    list.iter().map(|node| positive(node, what)).collect()
}

/// The relative heights of the levels of braces.
fn levels(
    node: Option<&Node>,
    bays: usize,
    reading: &mut Reading<'_>,
) -> Result<Vec<f64>, Diagnostic> {
    let Some(node) = node else {
        let [low, high] = BRACED;
        reading.note(Note::assumption(format!(
            "the jacket has no bay_spacing: its bays are equally high between {low} and {high} of its height"
        )));
        let step = (high - low) / bays as f64;
        return Ok((0..=bays).map(|k| low + k as f64 * step).collect());
    };
    let found = node.numbers("bay_spacing")?;
    if found.len() != bays + 1 {
        let kind = DiagnosticKind::wrong_count("bay_spacing", found.len(), bays + 1);
        let hint = "the relative heights of the ends of all bays, n_bays + 1 values";
        return Err(Diagnostic::new(node.span.clone(), kind).with_hint(hint));
    }
    let rises = found.windows(2).all(|pair| pair[0] < pair[1]);
    if rises && found[0] >= 0.0 && found[bays] <= 1.0 {
        return Ok(found);
    }
    let message = "bay_spacing must rise from at least 0 (foot) to at most 1 (head)";
    let kind = DiagnosticKind::Contradiction(message.to_owned());
    Err(Diagnostic::new(node.span.clone(), kind))
}

fn mud_braces(node: &Node) -> Result<bool, Diagnostic> {
    match node.get("x_mb") {
        None => Ok(false),
        Some(found) => match found.value {
            Value::Bool(is_there) => Ok(is_there),
            _ => Err(found.wrong("x_mb", "true or false")),
        },
    }
}

/// The material of all members: `material`, by default `steel`.
fn material(
    node: &Node,
    outline: &Outline,
    reading: &mut Reading<'_>,
) -> Result<Material, Diagnostic> {
    let mut materials = Materials::new(outline.materials.as_ref());
    match node.get("material") {
        Some(name) => materials.named(name, reading),
        None => {
            reading.note(Note::assumption(
                "the jacket has no material: `steel` is assumed",
            ));
            let name = Node {
                value: Value::Text("steel".to_owned()),
                span: node.span.clone(),
            };
            materials.named(&name, reading)
        }
    }
}

/// Notes on the known data of seabed and water.
fn note_place(
    outline: &Outline,
    jacket: &Jacket,
    node: &Node,
    reading: &mut Reading<'_>,
) -> Result<(), Diagnostic> {
    let [_, foot_m] = jacket.foot_m;
    let foot = Rounded(foot_m);
    let at = node.span.start;
    reading.note_at(
        at,
        Note::assumption(format!(
            "the heads of the jacket's legs are connected rigidly to the base of the tower, and its feet at z = {foot} m are clamped: flexible soil lowers the frequencies"
        )),
    );
    let environment = outline.environment.as_ref();
    if let Some(depth) = environment.and_then(|environment| environment.get("water_depth")) {
        let depth_m = depth.number("water depth")?;
        if (depth_m + foot_m).abs() > NEAR_M {
            reading.note_at(
                depth.span.start,
                Note::suspicious(format!(
                    "the feet of the jacket at z = {foot} m (base of the tower minus height of the jacket) are not on the seabed at z = {} m",
                    Rounded(0.0 - depth_m)
                )),
            );
        }
        if depth_m > 0.0 {
            reading.note_at(at, in_air(0.0 - depth_m));
        }
    }
    if let Some(mass) = node.get("gravity_foundation_mass")
        && mass.number("mass of the gravity foundation")? != 0.0
    {
        reading.note_at(
            mass.span.start,
            Note::left_out(
                "the mass of the gravity foundation has no effect: the feet do not move",
            ),
        );
    }
    Ok(())
}
