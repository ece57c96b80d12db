//! The joints of a platform, including those along members, by their names.

use std::collections::HashMap;
use std::ops::Range;

use super::super::text::outline::Version;
use super::super::text::reading::Reading;
use super::super::text::yaml::{Node, Value};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;

/// Largest number of joints or members of a platform.
pub(super) const MOST: usize = 2_000;

/// A joint.
#[derive(Debug, Clone)]
pub(super) struct Joint {
    pub(super) position_m: [f64; 3],
    /// Coefficient of the added mass of ends of members (`axial_coeffs`).
    pub(super) axial: f64,
    /// The member along which the joint lies, and its position on the member.
    pub(super) along: Option<(usize, f64)>,
}

/// The joints of a file.
#[derive(Debug, Default)]
pub(super) struct Joints {
    pub(super) joints: Vec<Joint>,
    indices: HashMap<String, usize>,
    /// The joint of the tower's base.
    pub(super) transition: Option<usize>,
}

impl Joints {
    /// The joints that have coordinates.
    pub(super) fn read(
        platform: &Node,
        version: Version,
        reading: &mut Reading<'_>,
    ) -> Result<Self, Diagnostic> {
        let mut joints = Self::default();
        let list = platform.require("joints", "the floating platform")?;
        let list = capped(list, "joints of the floating platform")?;
        let degrees = in_degrees(list, version)?;
        if degrees != (version == Version::Two)
            && let Some(first) = list.first()
        {
            let message = "an angle of a cylindrical joint is above 2 π: angles of joints are taken in degrees, as in windIO 2";
            reading.note_at(first.span.start, Note::assumption(message));
        }
        for node in list {
            let name = node.require("name", "a joint of the floating platform")?;
            let what = format!("joint `{}`", name.name(&reading.source.text));
            let position_m = position(node, &what, degrees)?;
            let axial = match node.find(&["axial_coeffs", "Ca"]) {
                Some(ca) => ca.number(&format!("Ca of {what}"))?,
                None => 0.0,
            };
            let joint = Joint {
                position_m,
                axial: axial.max(0.0),
                along: None,
            };
            let index = joints.add(name, joint, reading)?;
            if is_true(node, "transition") {
                joints.transition = joints.transition.or(Some(index));
            }
        }
        Ok(joints)
    }

    pub(super) fn add(
        &mut self,
        name: &Node,
        joint: Joint,
        reading: &Reading<'_>,
    ) -> Result<usize, Diagnostic> {
        let text = name.name(&reading.source.text);
        let index = self.joints.len();
        if self.indices.insert(text.to_owned(), index).is_some() {
            let what = format!("the joint `{text}`");
            let kind = DiagnosticKind::Repeated { what, times: 2 };
            return Err(Diagnostic::new(name.span.clone(), kind));
        }
        self.joints.push(joint);
        Ok(index)
    }

    /// The index of the joint with a name, if it exists already.
    pub(super) fn index(&self, name: &Node, reading: &Reading<'_>) -> Option<usize> {
        self.indices.get(name.name(&reading.source.text)).copied()
    }

    /// The index of the joint with a name.
    pub(super) fn find(&self, name: &Node, reading: &Reading<'_>) -> Result<usize, Diagnostic> {
        self.index(name, reading)
            .ok_or_else(|| unknown("joint", name, reading))
    }

    /// Moves all joints horizontally so that the tower's axis passes through x = y = 0.
    pub(super) fn shift(&mut self, [x, y]: [f64; 2]) {
        for joint in &mut self.joints {
            joint.position_m[0] -= x;
            joint.position_m[1] -= y;
        }
    }
}

/// The mistake of an unknown name.
pub(super) fn unknown(what: &'static str, name: &Node, reading: &Reading<'_>) -> Diagnostic {
    let text = name.name(&reading.source.text);
    let name_kind = DiagnosticKind::UnknownName {
        what,
        name: text.chars().take(60).collect(),
    };
    Diagnostic::new(name.span.clone(), name_kind)
}

/// A list of limited length.
pub(super) fn capped<'n>(node: &'n Node, what: &str) -> Result<&'n [Node], Diagnostic> {
    let list = node.list(what)?;
    match list.get(MOST) {
        None => Ok(list),
        Some(first) => {
            let (what, found, limit) = (what.to_owned(), list.len(), MOST);
            let kind = DiagnosticKind::TooMany { what, found, limit };
            Err(Diagnostic::new(first.span.clone(), kind))
        }
    }
}

pub(super) fn is_true(node: &Node, key: &str) -> bool {
    matches!(
        node.get(key).map(|node| &node.value),
        Some(Value::Bool(true))
    )
}

/// Three numbers as a vector.
pub(super) fn vector(node: &Node, what: &str) -> Result<[f64; 3], Diagnostic> {
    let numbers = node.numbers(what)?;
    <[f64; 3]>::try_from(numbers.as_slice()).map_err(|_| {
        let kind = DiagnosticKind::wrong_count(what, numbers.len(), 3);
        Diagnostic::new(node.span.clone(), kind)
    })
}

/// Whether angles are in degrees: in version 2, and if one is above 2 π.
fn in_degrees(list: &[Node], version: Version) -> Result<bool, Diagnostic> {
    if version == Version::Two {
        return Ok(true);
    }
    for node in list.iter().filter(|node| is_true(node, "cylindrical")) {
        if let Some(location) = node.get("location")
            && vector(location, "location of a joint")?[1].abs() > 1.001 * std::f64::consts::TAU
        {
            return Ok(true);
        }
    }
    Ok(false)
}

fn position(node: &Node, what: &str, degrees: bool) -> Result<[f64; 3], Diagnostic> {
    let location = node.require("location", what)?;
    let [a, b, z] = vector(location, &format!("location of {what}"))?;
    check_size(&[a, z], location.span.clone(), what)?;
    if !is_true(node, "cylindrical") {
        check_size(&[b], location.span.clone(), what)?;
        return Ok([a, b, z]);
    }
    let angle = if degrees { b.to_radians() } else { b };
    let (sin, cos) = angle.sin_cos();
    Ok([a * cos, a * sin, z])
}

/// Largest coordinate of a turbine, m.
const FARTHEST_M: f64 = 1e5;

fn check_size(values: &[f64], span: Range<usize>, what: &str) -> Result<(), Diagnostic> {
    match values.iter().find(|value| value.abs() > FARTHEST_M) {
        None => Ok(()),
        Some(value) => {
            let what = format!("a coordinate of {what}");
            let rule = "at most 100 km in size";
            let kind = DiagnosticKind::out_of_range_in(what, *value, "m", rule);
            Err(Diagnostic::new(span, kind))
        }
    }
}
