//! The members of a platform: their position, their section, and the part that is not inside
//! another member.

use std::ops::Range;

use super::super::support::curve::Curve;
use super::super::support::layers::{Layer, layers};
use super::super::support::materials::Materials;
use super::super::text::outline::Version;
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::joints::{Joint, Joints, capped};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::hydrodyn::{SeaWater, Stretch, StripAddedMass, StripMember, StripSection};
use crate::note::Note;
use crate::number::Rounded;

/// A circular member.
#[derive(Debug)]
pub(super) struct Member<'n> {
    pub(super) name: String,
    pub(super) span: Range<usize>,
    /// The indices of its joints.
    pub(super) joints: [usize; 2],
    pub(super) diameter: Curve,
    pub(super) layers: Vec<Layer>,
    /// Factor on the mass of the walls.
    pub(super) outfitting: f64,
    /// Coefficient of added mass across the axis.
    pub(super) across: f64,
    /// The mass that the file gives for its walls, bulkheads, stiffeners and fixed ballast, kg.
    pub(super) given_kg: Option<f64>,
    /// The data of layers, bulkheads, ballast and stiffeners.
    pub(super) structure: &'n Node,
}

/// A part of a member between two positions, within which no quantity has a kink or a step.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    /// Positions along the whole member.
    pub(super) from: f64,
    pub(super) to: f64,
    /// The corresponding stretch of a strip member.
    pub(super) stretch: Stretch,
}

/// Reads the members and the joints along them.
pub(super) fn members<'n>(
    platform: &'n Node,
    version: Version,
    joints: &mut Joints,
    materials: &mut Materials<'_>,
    reading: &mut Reading<'_>,
) -> Result<Vec<Member<'n>>, Diagnostic> {
    let list = platform.require("members", "the floating platform")?;
    let list = capped(list, "members of the floating platform")?;
    if list.is_empty() {
        let what = "the list of members of the floating platform".to_owned();
        let kind = DiagnosticKind::Missing { what };
        return Err(Diagnostic::new(platform.span.clone(), kind));
    }
    place_axial_joints(list, joints, reading)?;
    let mut members = Vec::new();
    for node in list {
        members.push(member(node, version, joints, materials, reading)?);
    }
    note_assumed(list, reading);
    Ok(members)
}

/// Adds the joints along members; the ends of these members may themselves be joints along others.
fn place_axial_joints(
    list: &[Node],
    joints: &mut Joints,
    reading: &Reading<'_>,
) -> Result<(), Diagnostic> {
    let mut waiting: Vec<usize> = (0..list.len()).collect();
    while !waiting.is_empty() {
        let before = waiting.len();
        let mut later = Vec::new();
        for index in waiting {
            let node = &list[index];
            let ends = ends(node)?;
            let [Some(from), Some(to)] = ends.map(|end| joints.index(end, reading)) else {
                later.push(index);
                continue;
            };
            add_along(node, index, [from, to], joints, reading)?;
        }
        if later.len() == before {
            for end in ends(&list[later[0]])? {
                joints.find(end, reading)?;
            }
        }
        waiting = later;
    }
    Ok(())
}

fn ends(node: &Node) -> Result<[&Node; 2], Diagnostic> {
    let what = "a member of the floating platform";
    Ok([node.require("joint1", what)?, node.require("joint2", what)?])
}

fn add_along(
    node: &Node,
    member: usize,
    [from, to]: [usize; 2],
    joints: &mut Joints,
    reading: &Reading<'_>,
) -> Result<(), Diagnostic> {
    let Some(list) = node.get("axial_joints") else {
        return Ok(());
    };
    for axial in capped(list, "axial joints of a member")? {
        let name = axial.require("name", "an axial joint")?;
        let grid = axial.require("grid", "an axial joint")?;
        let at = grid.number("position (grid) of an axial joint")?;
        if !(0.0..=1.0).contains(&at) {
            let kind = DiagnosticKind::out_of_range("grid of an axial joint", at, "from 0 to 1");
            return Err(Diagnostic::new(grid.span.clone(), kind));
        }
        let [a, b] = [from, to].map(|end| joints.joints[end].position_m);
        let joint = Joint {
            position_m: std::array::from_fn(|i| a[i] + at * (b[i] - a[i])),
            axial: 0.0,
            along: Some((member, at)),
        };
        joints.add(name, joint, reading)?;
    }
    Ok(())
}

fn member<'n>(
    node: &'n Node,
    version: Version,
    joints: &Joints,
    materials: &mut Materials<'_>,
    reading: &mut Reading<'_>,
) -> Result<Member<'n>, Diagnostic> {
    let name = node.require("name", "a member of the floating platform")?;
    let name = name.name(&reading.source.text).to_owned();
    let what = format!("member `{name}`");
    let [from, to] = ends(node)?;
    let ends = [joints.find(from, reading)?, joints.find(to, reading)?];
    let [a, b] = ends.map(|end| joints.joints[end].position_m);
    if distance(a, b) == 0.0 {
        let message = format!("both joints of {what} are at one point");
        let kind = DiagnosticKind::Contradiction(message);
        return Err(Diagnostic::new(from.span.clone(), kind));
    }
    let diameter = diameter(node, &what, reading)?;
    let key = match version {
        Version::One => "internal_structure",
        Version::Two => "structure",
    };
    let structure = node.get(key).or_else(|| node.get("structure"));
    let structure = match structure.or_else(|| node.get("internal_structure")) {
        Some(structure) => structure,
        None => node.require(key, &what)?,
    };
    let layers = layers(Some(structure), &what, materials, reading)?;
    let outfitting = structure.number_or("outfitting_factor", "outfitting factor", 1.0)?;
    Ok(Member {
        span: node.span.clone(),
        joints: ends,
        diameter,
        layers,
        outfitting,
        across: across(node, &what)?,
        given_kg: given_kg(node, &what, reading)?,
        structure,
        name,
    })
}

pub(super) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

fn diameter(node: &Node, what: &str, reading: &Reading<'_>) -> Result<Curve, Diagnostic> {
    let shape_node = node.require("outer_shape", what)?;
    let shape = shape_node.get("shape");
    let is_circular = |shape: &Node| shape.name(&reading.source.text) == "circular";
    if let Some(shape) = shape.filter(|shape| !is_circular(shape)) {
        let text = shape.name(&reading.source.text);
        let message = format!("{what} is {text}: only circular members can be read");
        let hint = "describe it as a circular member of the same area";
        return Err(
            Diagnostic::new(shape.span.clone(), DiagnosticKind::Unsupported(message))
                .with_hint(hint),
        );
    }
    let name = format!("outer diameter of {what}");
    let curve = Curve::read(shape_node.require("outer_diameter", what)?, &name)?;
    match curve.values().iter().find(|value| **value <= 0.0) {
        None => Ok(curve),
        Some(value) => {
            let kind = DiagnosticKind::out_of_range_in(name, *value, "m", "positive");
            Err(Diagnostic::new(shape_node.span.clone(), kind))
        }
    }
}

/// The default coefficient of added mass: that of a circular cylinder in potential flow.
const ASSUMED_ACROSS: f64 = 1.0;

/// The coefficient of added mass: a number, or a list whose first entry applies to a circle.
fn across(node: &Node, what: &str) -> Result<f64, Diagnostic> {
    let Some(given) = given_across(node) else {
        return Ok(ASSUMED_ACROSS);
    };
    let name = format!("Ca of {what}");
    let first = given.list(&name).ok().and_then(|list| list.first());
    let value = first.unwrap_or(given).number(&name)?;
    match value >= 0.0 {
        true => Ok(value),
        false => {
            let kind = DiagnosticKind::out_of_range(name, value, "0 or positive");
            Err(Diagnostic::new(given.span.clone(), kind))
        }
    }
}

fn given_across(node: &Node) -> Option<&Node> {
    node.get("Ca").or_else(|| node.get("ca"))
}

/// A common note on all members without a coefficient of added mass, at the first of them.
fn note_assumed(list: &[Node], reading: &mut Reading<'_>) {
    let without: Vec<&Node> = list
        .iter()
        .filter(|node| given_across(node).is_none())
        .collect();
    let Some(first) = without.first() else {
        return;
    };
    let text = &reading.source.text;
    let names = without.iter().filter_map(|node| node.get("name"));
    let names: Vec<String> = names.map(|name| format!("`{}`", name.name(text))).collect();
    let (which, have) = match names.as_slice() {
        [name] => (format!("member {name}"), "has"),
        [first, .., last] if names.len() > MOST_NAMES => (
            format!("{} members ({first} to {last})", names.len()),
            "have",
        ),
        _ => (format!("members {}", names.join(", ")), "have"),
    };
    let message =
        format!("{which} {have} no coefficient of added mass: Ca = {ASSUMED_ACROSS} is assumed");
    reading.note_at(first.span.start, Note::assumption(message));
}

/// Largest number of names in a sentence.
const MOST_NAMES: usize = 4;

/// The mass of a member that the user gives; the computed masses of its parts are scaled to it as
/// in WISDEM; 0 means none.
fn given_kg(node: &Node, what: &str, reading: &mut Reading<'_>) -> Result<Option<f64>, Diagnostic> {
    let Some(given) = node.get(MEMBER_MASS) else {
        return Ok(None);
    };
    let mass_kg = given.mass_kg(&format!("{MEMBER_MASS} of {what}"))?;
    if mass_kg == 0.0 {
        return Ok(None);
    }
    let message = format!(
        "{what} has {MEMBER_MASS} = {} kg: walls, bulkheads, stiffeners and fixed ballast are scaled to this mass",
        Rounded(mass_kg)
    );
    reading.note_at(given.span.start, Note::assumption(message));
    Ok(Some(mass_kg))
}

/// The key of this mass, as in WISDEM.
const MEMBER_MASS: &str = "member_mass_user";

impl Member<'_> {
    /// The range of positions that is not inside the members on which its joints lie.
    pub(super) fn outside(&self, joints: &Joints, members: &[Member<'_>]) -> [f64; 2] {
        let ends = self.joints.map(|end| &joints.joints[end]);
        let length_m = distance(ends[0].position_m, ends[1].position_m);
        let inside = ends.map(|end| match end.along {
            Some((other, at)) => 0.5 * members[other].diameter.below(at) / length_m,
            None => 0.0,
        });
        [inside[0], 1.0 - inside[1]]
    }

    /// Its largest outer radius, m.
    pub(super) fn widest_m(&self) -> f64 {
        let diameters = self.diameter.values().iter();
        0.5 * diameters.fold(0.0_f64, |most, diameter| most.max(*diameter))
    }

    /// The wall thickness at a position, m; just above it, or just below.
    pub(super) fn wall_m(&self, at: f64, above: bool) -> f64 {
        let layers = self.layers.iter();
        layers.map(|layer| value(&layer.thickness, at, above)).sum()
    }

    /// The inner radius at a position, m.
    pub(super) fn inner_m(&self, at: f64, above: bool) -> f64 {
        (0.5 * value(&self.diameter, at, above) - self.wall_m(at, above)).max(0.0)
    }

    /// The member divided into pieces, at the positions where it or a ballast begins, ends or has a
    /// kink.
    pub(super) fn pieces(
        &self,
        joints: &Joints,
        range: [f64; 2],
        limits: &[f64],
        water: &SeaWater,
    ) -> (StripMember, Vec<Piece>) {
        let whole_m = self.joints.map(|end| joints.joints[end].position_m);
        let point =
            |at: f64| std::array::from_fn(|i| whole_m[0][i] + at * (whole_m[1][i] - whole_m[0][i]));
        let mut cuts: Vec<f64> = range.to_vec();
        cuts.extend(self.diameter.grid());
        cuts.extend(self.layers.iter().flat_map(|layer| layer.thickness.grid()));
        cuts.extend(limits);
        let [from_m, to_m] = whole_m.map(|end_m| end_m[2]);
        cuts.extend([0.0, -water.depth_m].map(|z_m| (z_m - from_m) / (to_m - from_m)));
        cuts.retain(|cut| (range[0]..=range[1]).contains(cut));
        cuts.sort_by(f64::total_cmp);
        let pairs = cuts.windows(2).filter(|pair| pair[1] - pair[0] > SAME_CUT);
        let pieces: Vec<Piece> = pairs
            .map(|pair| self.piece([pair[0], pair[1]], range, [from_m, to_m], water))
            .collect();
        let member = StripMember {
            name: self.name.clone(),
            ends_m: range.map(point),
            spin_deg: 0.0,
            is_potential_flow: false,
            has_hydrostatics: true,
            stretches: pieces.iter().map(|piece| piece.stretch).collect(),
        };
        (member, pieces)
    }

    fn piece(
        &self,
        [from, to]: [f64; 2],
        range: [f64; 2],
        heights_m: [f64; 2],
        water: &SeaWater,
    ) -> Piece {
        let local = |at: f64| ((at - range[0]) / (range[1] - range[0])).clamp(0.0, 1.0);
        let middle_m = heights_m[0] + 0.5 * (from + to) * (heights_m[1] - heights_m[0]);
        let is_wet = middle_m <= 0.0 && middle_m >= -water.depth_m;
        let added_mass = is_wet.then_some(StripAddedMass {
            across: [[self.across; 2]; 2],
            along: [0.0; 2],
        });
        let stretch = Stretch {
            range: [local(from), local(to)],
            section: StripSection::Circle {
                outer_radius_m: [
                    0.5 * value(&self.diameter, from, true),
                    0.5 * value(&self.diameter, to, false),
                ],
                inner_radius_m: [self.inner_m(from, true), self.inner_m(to, false)],
            },
            is_wet,
            growth: None,
            added_mass,
            fill_density_kg_per_m3: 0.0,
        };
        Piece { from, to, stretch }
    }
}

/// Positions that are closer together than this are merged.
const SAME_CUT: f64 = 1e-12;

pub(super) fn value(curve: &Curve, at: f64, above: bool) -> f64 {
    match above {
        true => curve.above(at),
        false => curve.below(at),
    }
}
