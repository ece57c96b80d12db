//! The motion of a frame in a mode: of its joints, and of points between them along its members.

use super::element::Element;
use super::equations::motion_of;
use super::graph::Node;
use super::parts::inverse_tip;
use super::rigid::{Motion, Vector, into_axes, out_of_axes};
use crate::tower::frame::Frame;

/// Where members are sampled, as fractions of their length from the first joint.
const FRACTIONS: [f64; 3] = [0.25, 0.5, 0.75];

/// The motion of a frame in a mode.
///
/// A locally vibrating brace moves between joints that hardly move; therefore the shape includes
/// the middle of the members.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FrameShape {
    /// The motion (x, y, z, rotation about x, y, z) of each joint, in the order of the joints.
    pub joints: Vec<[f64; 6]>,
    /// The translation (x, y, z) of each member's axis at a quarter, a half and three quarters of
    /// its length from its first joint, in the order of the members.
    pub members: Vec<[[f64; 3]; 3]>,
}

impl FrameShape {
    /// The translations of five points of a member that joins two joints, from the first to the
    /// second.
    pub fn along(&self, member: usize, [from, to]: [usize; 2]) -> [[f64; 3]; 5] {
        let joint = |index: usize| {
            let [x, y, z, ..] = self.joints.get(index).copied().unwrap_or_default();
            [x, y, z]
        };
        let [a, b, c] = self.members.get(member).copied().unwrap_or_default();
        [joint(from), a, b, c, joint(to)]
    }

    /// The same motion divided by a number.
    pub(crate) fn divided_by(&self, size: f64) -> Self {
        // A zero keeps its sign for any sign of the size.
        let part = |x: f64| if x == 0.0 { 0.0 } else { x / size };
        Self {
            joints: self.joints.iter().map(|m| m.map(part)).collect(),
            members: self
                .members
                .iter()
                .map(|points| points.map(|point| point.map(part)))
                .collect(),
        }
    }

    /// Whether every number is finite.
    pub(crate) fn is_finite(&self) -> bool {
        let points = self.members.iter().flatten().flatten();
        let mut all = self.joints.iter().flatten().chain(points);
        all.all(|value| value.is_finite())
    }
}

/// The points of a member between two of its fractions: their indices and fractions.
pub(super) fn sampled(from: f64, to: f64) -> impl Iterator<Item = (usize, f64)> {
    let is_here = move |s: f64| from <= s && (s < to || to >= 1.0);
    let points = FRACTIONS.into_iter().enumerate();
    points.filter(move |(_, s)| is_here(*s))
}

/// Reads the shapes of a frame from vectors of its equations.
#[derive(Debug, Clone, Default)]
pub(super) struct ShapeReader {
    /// The node of each joint; none for the ground.
    pub(super) joints: Vec<Node>,
    /// Points of members that are beams.
    pub(super) samples: Vec<Sample>,
}

impl ShapeReader {
    /// The shape of a vector with these motions of the nodes.
    pub(super) fn read(&self, frame: &Frame, motions: &[Motion], x: &[f64]) -> FrameShape {
        let joints: Vec<Motion> = self.joints.iter().map(|n| motion_of(motions, *n)).collect();
        // Members that are not beams are straight between their joints.
        let straight = |ends: &[usize; 2]| {
            let [from, to] = ends.map(|joint| joints[joint]);
            FRACTIONS.map(|s| std::array::from_fn(|i| from[i] + s * (to[i] - from[i])))
        };
        let members = frame.description().members.iter();
        let mut members: Vec<[[f64; 3]; 3]> = members.map(|m| straight(&m.joints)).collect();
        for sample in &self.samples {
            members[sample.member][sample.point] = sample.translation(motions, x);
        }
        FrameShape { joints, members }
    }
}

/// A point of a beam member.
#[derive(Debug, Clone)]
pub(super) struct Sample {
    member: usize,
    point: usize,
    /// The nodes at the ends of its element; for a link only the first one.
    ends: [Node; 2],
    /// Index of the first unknown of the element.
    first: usize,
    /// The axes of the element as rows.
    axes: [Vector; 3],
    /// The translation in these axes, for the motions of both ends in them and the unknowns.
    rows: [Vec<f64>; 3],
}

impl Sample {
    /// The points of an element between two fractions of a member, which may fall, that carries its
    /// far end from a node.
    pub(super) fn of_link(
        (member, from, to): (usize, f64, f64),
        (element, axes): (&Element, &[Vector; 3]),
        parent: Node,
        first: usize,
    ) -> Vec<Self> {
        let moving: usize = element.planes().map(|(part, _)| part.moving()).sum();
        let row = |place: usize, i: usize| {
            let mut row = vec![0.0; 12 + element.coordinates()];
            let (mut next, mut bubble) = (12, 12 + moving);
            for (part, components) in element.planes() {
                let of_part = &part.translation(components, place)[i];
                let [near, own, bubbles] = part.split(of_part);
                add(&mut row[..6], 1.0, near);
                add(&mut row[next..], 1.0, own);
                add(&mut row[bubble..], 1.0, bubbles);
                (next, bubble) = (next + own.len(), bubble + bubbles.len());
            }
            row
        };
        Self::of((member, from, to), axes, ([parent, None], first), row)
    }

    /// As above for an element between two nodes that are carried by other links; its unknowns are
    /// bubbles.
    pub(super) fn of_chord(
        (member, from, to): (usize, f64, f64),
        (element, axes): (&Element, &[Vector; 3]),
        ends: [Node; 2],
        first: usize,
    ) -> Vec<Self> {
        let inverses: Vec<Vec<Vec<f64>>> = element.planes().map(|(p, _)| inverse_tip(p)).collect();
        let bubbles = element.planes().map(|(p, _)| p.coordinates - p.moving());
        let length = 12 + bubbles.sum::<usize>();
        let row = |place: usize, i: usize| {
            let (mut row, mut bubble) = (vec![0.0; length], 12);
            for ((part, components), inverse) in element.planes().zip(&inverses) {
                let of_part = &part.translation(components, place)[i];
                let [near, own, bubbles] = part.split(of_part);
                add(&mut row[..6], 1.0, near);
                // The coordinates that move the far end are L⁻¹ (q_far − X q_near).
                for (entry, inverse) in own.iter().zip(inverse) {
                    for ((component, sign), l) in components.iter().zip(inverse) {
                        let share = entry * l * sign;
                        row[6 + component] += share;
                        add(&mut row[..6], -share, &element.transfer[*component]);
                    }
                }
                add(&mut row[bubble..], 1.0, bubbles);
                bubble += bubbles.len();
            }
            row
        };
        Self::of((member, from, to), axes, (ends, first), row)
    }

    fn of(
        (member, from, to): (usize, f64, f64),
        axes: &[Vector; 3],
        (ends, first): ([Node; 2], usize),
        row: impl Fn(usize, usize) -> Vec<f64>,
    ) -> Vec<Self> {
        let points = sampled(from.min(to), from.max(to)).enumerate();
        let sample = |(place, (point, _)): (usize, (usize, f64))| Self {
            member,
            point,
            ends,
            first,
            axes: *axes,
            rows: std::array::from_fn(|i| row(place, i)),
        };
        points.map(sample).collect()
    }

    fn translation(&self, motions: &[Motion], x: &[f64]) -> Vector {
        let [near, far] = self
            .ends
            .map(|end| into_axes(&self.axes, &motion_of(motions, end)));
        let mut local = [0.0; 6];
        for (value, row) in local.iter_mut().zip(&self.rows) {
            let all = near.iter().chain(&far).chain(&x[self.first..]);
            *value = row.iter().zip(all).map(|(a, b)| a * b).sum();
        }
        let [x, y, z, ..] = out_of_axes(&self.axes, &local);
        [x, y, z]
    }
}

fn add(to: &mut [f64], factor: f64, values: &[f64]) {
    to.iter_mut()
        .zip(values)
        .for_each(|(to, value)| *to += factor * value);
}
