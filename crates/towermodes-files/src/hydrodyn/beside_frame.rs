//! Strip members compared with the members of the frame at the same place.

use towermodes::frame::{FrameDescription, MemberKind, SectionEnds};

use super::beams::{self, Lying};
use super::input::HydrodynInput;
use super::section::blend;
use super::spatial::{difference, norm};
use super::strip::Stretch;

/// The largest plausible ratio of the diameters of a member in both files.
const FACTOR: f64 = 1.5;
/// The largest plausible distance between members of both files, in diameters and in m.
const DIAMETERS: f64 = 2.0;
const APART_M: f64 = 3.0;

/// A strip member on a tube of the frame with another diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OtherDiameter {
    /// The index of the strip member, from 0.
    pub(crate) strip: usize,
    /// The index of the member of the frame.
    pub(crate) member: usize,
    /// Height of the place, m.
    pub(crate) z_m: f64,
    /// Diameter of the strip member there, m.
    pub(crate) strip_m: f64,
    /// Diameter of the member of the frame there, m.
    pub(crate) tube_m: f64,
}

/// A strip member far from all members of the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FarAway {
    /// The index of the strip member, from 0.
    pub(crate) strip: usize,
    /// The index of the nearest member of the frame.
    pub(crate) member: usize,
    /// The largest distance of a point of the strip member, m.
    pub(crate) distance_m: f64,
}

impl HydrodynInput {
    /// Strip members with added mass that lie on a tube of another diameter.
    pub(crate) fn other_diameters(&self, frame: &FrameDescription) -> Vec<OtherDiameter> {
        let beams = beams::of(frame);
        let mut found = Vec::new();
        for (index, member) in self.members.iter().enumerate() {
            let lying = beams::lying(member, &beams);
            let moving = member.stretches.iter().filter(|stretch| stretch.moves());
            let pairs = moving.flat_map(|stretch| lying.iter().map(move |part| (stretch, part)));
            let unequal = pairs.filter_map(|(stretch, part)| {
                let at = middle(stretch, part)?;
                let strip_m = 2.0 * stretch.radius_at(at);
                let fraction = part.beam_fraction(at);
                let tube_m = tube_diameter_m(&frame.members[part.member].kind, fraction)?;
                let factor = (strip_m / tube_m).max(tube_m / strip_m);
                (factor > FACTOR).then_some(OtherDiameter {
                    strip: index,
                    member: part.member,
                    z_m: member.point_m(at)[2],
                    strip_m,
                    tube_m,
                })
            });
            found.extend(unequal.take(1));
        }
        found
    }

    /// Strip members with added mass that are far away from all members of the frame.
    pub(crate) fn far_away(&self, frame: &FrameDescription) -> Vec<FarAway> {
        let axes = beams::all(frame);
        let strips = self.members.iter().enumerate();
        let found = strips.filter_map(|(strip, member)| {
            let moving = member.stretches.iter().filter(|stretch| stretch.moves());
            let points = moving.flat_map(|stretch| {
                let limit_m = (2.0 * DIAMETERS * stretch.section.outer_radius_m()[0]).max(APART_M);
                let [from, to] = stretch.range;
                [from, 0.5 * (from + to), to].map(|at| (member.point_m(at), limit_m))
            });
            let far = points.filter_map(|(point_m, limit_m)| {
                let (member, _, foot_m) = beams::nearest(point_m, &axes)?;
                let distance_m = norm(difference(point_m, foot_m));
                (distance_m > limit_m).then_some(FarAway {
                    strip,
                    member,
                    distance_m,
                })
            });
            far.max_by(|a, b| a.distance_m.total_cmp(&b.distance_m))
        });
        found.collect()
    }
}

/// The middle of the part of a stretch that lies on a beam, as a fraction of the strip member.
fn middle(stretch: &Stretch, part: &Lying) -> Option<f64> {
    let from = stretch.range[0].max(part.range[0]);
    let to = stretch.range[1].min(part.range[1]);
    (from < to).then_some(0.5 * (from + to))
}

impl Stretch {
    /// The outer radius at a fraction of the member's length, m; for a rectangle the radius of the
    /// circle of the same area.
    fn radius_at(&self, at: f64) -> f64 {
        let [from, to] = self.range;
        self.section.outer((at - from) / (to - from)).radius_m()
    }
}

/// The outer diameter of a tube at a fraction of its length, m.
fn tube_diameter_m(kind: &MemberKind, fraction: f64) -> Option<f64> {
    match kind {
        MemberKind::Beam {
            ends: SectionEnds::Tube(ends),
            ..
        } => Some(blend(ends.map(|end| end.outer_diameter_m), fraction)),
        MemberKind::Beam {
            ends: SectionEnds::Rectangle(_) | SectionEnds::Given(_),
            ..
        }
        | MemberKind::Cable { .. }
        | MemberKind::Rigid { .. }
        | MemberKind::Spring(_) => None,
    }
}
