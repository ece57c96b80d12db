//! The axes of the beams of a frame: the strip members on them, and the beam nearest to a point.

use towermodes::frame::{FrameDescription, MemberKind};

use super::spatial::{Vector, between, difference, dot, norm};
use super::strip::StripMember;

/// A strip member lies on a beam if the distance of both axes is smaller than this, m: coordinates
/// in files have at least three decimals.
const TOLERANCE_M: f64 = 1e-3;

/// A beam of a frame.
#[derive(Debug, Clone)]
pub(super) struct Beam {
    /// The index of the member of the frame.
    pub(super) member: usize,
    ends_m: [Vector; 2],
}

/// The part of a strip member that lies on a beam.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lying {
    /// The index of the member of the frame.
    pub(super) member: usize,
    /// The part, as fractions of the length of the strip member.
    pub(super) range: [f64; 2],
    /// The positions of both ends of the part, as fractions of the length of the beam.
    pub(super) on_beam: [f64; 2],
}

impl Lying {
    /// The fraction of the beam's length at a fraction of the strip member's length.
    pub(super) fn beam_fraction(&self, fraction: f64) -> f64 {
        let [from, to] = self.range;
        let [first, last] = self.on_beam;
        let share = (fraction - from) / (to - from);
        (first + share * (last - first)).clamp(0.0, 1.0)
    }
}

/// The beams of a frame.
pub(super) fn of(frame: &FrameDescription) -> Vec<Beam> {
    axes(frame, |kind| matches!(kind, MemberKind::Beam { .. }))
}

/// All members of a frame, each with its axis like a beam.
pub(super) fn all(frame: &FrameDescription) -> Vec<Beam> {
    axes(frame, |_| true)
}

fn axes(frame: &FrameDescription, is_wanted: impl Fn(&MemberKind) -> bool) -> Vec<Beam> {
    let members = frame.members.iter().enumerate();
    let wanted = members.filter(|(_, member)| is_wanted(&member.kind));
    let axes = wanted.filter_map(|(index, member)| {
        let [from, to] = member.joints.map(|joint| frame.joints.get(joint));
        let ends_m = [from?.position_m, to?.position_m];
        (ends_m[0] != ends_m[1]).then_some(Beam {
            member: index,
            ends_m,
        })
    });
    axes.collect()
}

/// The parts of a strip member that lie on beams, in increasing order; no part lies on two beams.
pub(super) fn lying(strip: &StripMember, beams: &[Beam]) -> Vec<Lying> {
    let mut found: Vec<Lying> = beams.iter().filter_map(|beam| beam.under(strip)).collect();
    found.sort_by(|a, b| a.range[0].total_cmp(&b.range[0]));
    let mut end = 0.0_f64;
    let mut parts = Vec::new();
    for lying in found {
        let range = [lying.range[0].max(end), lying.range[1]];
        if range[1] > range[0] {
            let on_beam = range.map(|fraction| lying.beam_fraction(fraction));
            end = range[1];
            parts.push(Lying {
                range,
                on_beam,
                ..lying
            });
        }
    }
    parts
}

/// The beam nearest to a point, the fraction of its length at its nearest point, and this point.
pub(super) fn nearest(point_m: Vector, beams: &[Beam]) -> Option<(usize, f64, Vector)> {
    let distances = beams.iter().map(|beam| {
        let fraction = beam.fraction_next_to(point_m).clamp(0.0, 1.0);
        let foot_m = between(beam.ends_m[0], beam.ends_m[1], fraction);
        (
            norm(difference(point_m, foot_m)),
            beam.member,
            fraction,
            foot_m,
        )
    });
    let nearest = distances.min_by(|a, b| a.0.total_cmp(&b.0));
    nearest.map(|(_, member, fraction, foot_m)| (member, fraction, foot_m))
}

impl Beam {
    /// The fraction at the foot of the perpendicular from a point.
    fn fraction_next_to(&self, point_m: Vector) -> f64 {
        let axis = difference(self.ends_m[1], self.ends_m[0]);
        dot(difference(point_m, self.ends_m[0]), axis) / dot(axis, axis)
    }

    /// The part of a strip member that lies on this beam.
    fn under(&self, strip: &StripMember) -> Option<Lying> {
        let (length_m, axis) = (strip.length_m(), strip.axis());
        let along = self
            .ends_m
            .map(|end_m| dot(difference(end_m, strip.ends_m[0]), axis));
        let from_m = along[0].min(along[1]).max(0.0);
        let to_m = along[0].max(along[1]).min(length_m);
        if to_m - from_m < TOLERANCE_M {
            return None;
        }
        let range = [from_m / length_m, to_m / length_m];
        let points_m = range.map(|fraction| strip.point_m(fraction));
        let on_beam = points_m.map(|point_m| self.fraction_next_to(point_m));
        let distance = |end: usize| {
            let foot_m = between(self.ends_m[0], self.ends_m[1], on_beam[end]);
            norm(difference(points_m[end], foot_m))
        };
        let lies = distance(0) <= TOLERANCE_M && distance(1) <= TOLERANCE_M;
        lies.then_some(Lying {
            member: self.member,
            range,
            on_beam,
        })
    }
}
