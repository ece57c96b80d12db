//! The data of a frame for pictures: the outlines of its members, its position in water and ground,
//! its motion in a mode.

use towermodes::Mode;
use towermodes::frame::{
    CoatKind, Frame, FrameDescription, FrameFoundation, FrameMember, FrameShape, MemberKind,
    SectionEnds,
};

use super::outline::NOMINAL_SLENDERNESS;

/// Positions of the sampled points of a member, as fractions of its length.
const SAMPLED: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Water levels are rounded to multiples of this, m.
const LEVEL_M: f64 = 1e-6;

/// A frame under a tower.
#[derive(Debug, Clone, Copy)]
pub(super) struct Substructure<'a> {
    /// The given frame.
    pub of: &'a FrameFoundation,
}

impl<'a> Substructure<'a> {
    pub fn frame(&self) -> &'a Frame {
        &self.of.frame
    }

    pub fn description(&self) -> &'a FrameDescription {
        self.of.frame.description()
    }

    /// The positions of the ends of a member, m.
    pub fn ends_m(&self, member: &FrameMember) -> [[f64; 3]; 2] {
        let joints = &self.description().joints;
        member.joints.map(|joint| joints[joint].position_m)
    }

    /// The lowest and the highest joint, m.
    pub fn heights_m(&self) -> [f64; 2] {
        let joints = self.description().joints.iter();
        let heights_m = joints.map(|joint| joint.position_m[2]);
        heights_m.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| {
            [low.min(z), high.max(z)]
        })
    }

    /// The largest distance of a joint from the axis of the tower in x or y, m.
    pub fn reach_m(&self) -> f64 {
        let [x, y, _] = self.of.reference_m();
        let joints = self.description().joints.iter();
        let reach = joints.map(|joint| {
            let [a, b, _] = joint.position_m;
            (a - x).abs().max((b - y).abs())
        });
        reach.fold(0.0, f64::max)
    }

    /// The height of the water surface, m: the highest point at which members have water.
    pub fn water_m(&self) -> Option<f64> {
        let of_member = |member: &'a FrameMember| {
            let [from, to] = self.ends_m(member);
            let in_water = member
                .coats
                .iter()
                .filter(|coat| matches!(coat.kind, CoatKind::AddedMass { .. }));
            in_water
                .flat_map(|coat| coat.range)
                .map(move |s| from[2] + s * (to[2] - from[2]))
        };
        let members = self.description().members.iter();
        let level_m = members.flat_map(of_member).reduce(f64::max)?;
        // Fractions of members do not give still water to the last digit.
        Some((level_m / LEVEL_M).round() * LEVEL_M)
    }

    /// The height of the mudline, m: that of the highest support on the ground; a pile has joints
    /// below it.
    pub fn ground_m(&self) -> Option<f64> {
        let description = self.description();
        let supports = description.supports.iter();
        let heights_m = supports.map(|support| description.joints[support.joint].position_m[2]);
        heights_m.reduce(f64::max)
    }
}

/// The outer radii of a member at its ends, m; none if it has no section: a cable, a rigid link or
/// a spring. For a rectangle half of its larger side, for given properties the radius of the tube
/// with the same second moment of area and a wall of 1/200 of its diameter.
pub(super) fn radii_m(member: &FrameMember) -> Option<[f64; 2]> {
    let MemberKind::Beam { ends, .. } = &member.kind else {
        return None;
    };
    Some(match ends {
        SectionEnds::Tube(ends) => ends.map(|tube| 0.5 * tube.outer_diameter_m),
        SectionEnds::Rectangle(ends) => ends.map(|side| 0.5 * side.side_a_m.max(side.side_b_m)),
        SectionEnds::Given(given) => {
            let [a, b] = given.second_moments_m4;
            let of_unit = std::f64::consts::PI / 8.0 / NOMINAL_SLENDERNESS;
            [0.5 * (a.max(b) / of_unit).powf(0.25); 2]
        }
    })
}

/// A point of a member at a fraction of its length, at rest and with its displacement in a mode:
/// the quartic through the five sampled points.
pub(super) fn moved_along(
    ends_m: [[f64; 3]; 2],
    points: &[[f64; 3]; 5],
    s: f64,
) -> ([f64; 3], [f64; 3]) {
    let weight = |k: usize| {
        let others = SAMPLED.iter().enumerate().filter(|(other, _)| *other != k);
        others
            .map(|(_, at)| (s - at) / (SAMPLED[k] - at))
            .product::<f64>()
    };
    let weights: [f64; 5] = std::array::from_fn(weight);
    let [from, to] = ends_m;
    let at_rest = std::array::from_fn(|i| from[i] + s * (to[i] - from[i]));
    let sum = |i: usize| points.iter().zip(weights).map(|(p, w)| w * p[i]).sum();
    (at_rest, std::array::from_fn(sum))
}

/// The largest translation of tower and frame in a mode, in the scale of the mode shape.
pub(super) fn largest_translation(mode: &Mode) -> f64 {
    let size = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let of_tower = mode.shape.iter().map(|point| size(&point.translation));
    let frame = mode.frame.iter();
    let of_frame = frame.flat_map(|shape: &FrameShape| {
        let joints = shape.joints.iter().map(|joint| size(&joint[..3]));
        joints.chain(shape.members.iter().flatten().map(|point| size(point)))
    });
    of_tower.chain(of_frame).fold(0.0, f64::max)
}
