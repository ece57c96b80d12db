//! The springs of the ground along the piles of a frame: each pile is divided like a tower that
//! consists of this pile.

use super::super::frame::{FrameDescription, FrameSoil, FrameSoilRow, FrameSupport};
use super::super::parts::surroundings::SoilRow;
use super::description::Ground;
use super::frame_piles::{Buried, FramePile};
use super::plan::{Plan, Section};
use super::reaction::Reactions;
use crate::space::{SpatialMatrix, add_scaled};
use crate::tower::description::TowerDescription;
use crate::tower::error::TowerError;
use crate::tower::validate::{check_frame_in_ground, check_springs_of_frame};

/// An element of a pile is at most this many times (4 EI/k)^¼ long, over which a pile bends in
/// soil: then a polynomial of degree 8 has ten digits.
const LONGEST: f64 = 2.0;
/// Largest number of elements of one section: stiffer soil fixes the pile at its surface anyway.
const MOST_ELEMENTS: f64 = 16.0;

/// The heights at which the springs along the piles of a frame are computed: the same for a frame
/// and slightly changed frames.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::tower) struct FramePlan {
    piles: Vec<PilePlan>,
}

/// The heights along one pile.
#[derive(Debug, Clone, PartialEq)]
struct PilePlan {
    pile: FramePile,
    plan: Plan,
    /// Number of elements of each section of the plan.
    elements: Vec<usize>,
}

impl FrameDescription {
    /// The same frame with the springs of ground along its piles and under their tips.
    ///
    /// The piles are the members below the surface of the ground (after scour), and the parts of
    /// members below it, that are less than 60 degrees from the vertical; they need no mark in the
    /// description. They must be tubes. The springs follow from the layers by the same models as
    /// along a tower, with the outer diameter of the member at each depth, which is the vertical
    /// depth below the surface: those across the pile act across the axis of the member, also where
    /// it is inclined, the axial ones along it, each per length of the member. Where a pile ends,
    /// the springs under its tip add to the support of its joint. Piles do not influence each
    /// other: group effects are left out.
    ///
    /// # Errors
    /// [`TowerError`] with the place in the ground: impossible numbers, no member in the ground, a
    /// section without diameter, or layers that end above a tip.
    pub fn in_ground(&self, ground: &Ground) -> Result<Self, TowerError> {
        check_frame_in_ground(self, ground)?;
        let mut frame = self.clone();
        FramePlan::of(self, ground).apply(&mut frame, ground);
        check_springs_of_frame(&frame)?;
        Ok(frame)
    }
}

impl FramePlan {
    /// The plan of a frame; empty without piles.
    pub(super) fn of(frame: &FrameDescription, ground: &Ground) -> Self {
        let piles = FramePile::all(frame, ground).unwrap_or_default();
        let piles = piles.into_iter().map(|pile| {
            let alone = pile.alone(frame, ground);
            let plan = Plan::of(&alone);
            PilePlan {
                elements: elements(&alone, &plan),
                plan,
                pile,
            }
        });
        Self {
            piles: piles.collect(),
        }
    }

    /// Relative error of a frequency by linear interpolation of the springs: that of the worst
    /// pile.
    pub(super) fn error(&self) -> f64 {
        let errors = self.piles.iter().map(|pile| pile.plan.error);
        errors.fold(0.0, f64::max)
    }

    /// Adds the springs to a frame with the members of the first.
    pub(super) fn apply(&self, frame: &mut FrameDescription, ground: &Ground) {
        for pile in &self.piles {
            pile.apply(frame, ground);
        }
    }
}

/// Number of elements of each section of a pile.
fn elements(alone: &TowerDescription, plan: &Plan) -> Vec<usize> {
    let Some(reactions) = Reactions::of(alone) else {
        return Vec::new();
    };
    let heights_m = plan.heights_m(alone, &reactions);
    let of_section = |section: &Section| {
        let [lower_m, upper_m] = section.ends_m(&heights_m);
        let at = |share: f64| {
            let height_m = lower_m + share * (upper_m - lower_m);
            let lateral = reactions.springs(section.layer, height_m).x_n_per_m2;
            4.0 * reactions.pile.bending_n_m2(height_m) / lateral
        };
        // At the ends of a section the tube could be that of the adjacent section.
        let least = [0.001, 0.5, 0.999].map(at).into_iter();
        let bends_m = least.fold(f64::INFINITY, f64::min).powf(0.25);
        let wanted = ((upper_m - lower_m) / (LONGEST * bends_m)).ceil();
        wanted.clamp(1.0, MOST_ELEMENTS) as usize
    };
    plan.sections.iter().map(of_section).collect()
}

impl PilePlan {
    fn apply(&self, frame: &mut FrameDescription, ground: &Ground) {
        let alone = self.pile.alone(frame, ground);
        let Some(reactions) = Reactions::of(&alone) else {
            return;
        };
        let heights_m = self.plan.heights_m(&alone, &reactions);
        for (section, elements) in self.plan.sections.iter().zip(&self.elements) {
            let [lower_m, upper_m] = section.ends_m(&heights_m);
            let is_here = |part: &&Buried| {
                let [upper, lower] = part.ends_m(frame).map(|end| end[2]);
                (lower..upper).contains(&(0.5 * (lower_m + upper_m)))
            };
            let Some(part) = self.pile.own().iter().find(is_here) else {
                continue;
            };
            let ends_m = frame.members[part.member].joints;
            let ends_m = ends_m.map(|joint| frame.joints[joint].position_m[2]);
            let rows = section.rows(&reactions, &heights_m);
            let border_m = |k: usize| match k {
                k if k == *elements => upper_m,
                k => lower_m + k as f64 / *elements as f64 * (upper_m - lower_m),
            };
            let soil = (0..*elements).map(|k| along(&rows, [border_m(k), border_m(k + 1)], ends_m));
            frame.members[part.member].soil.extend(soil);
        }
        if let Some((joint, direction)) = self.pile.tip(frame) {
            let springs = reactions.at_tip(self.plan.tip_layer);
            add_support(frame, joint, &at_tip(springs, direction));
        }
    }
}

/// The rows by height between two heights (m) as rows of a member whose joints are at these heights
/// (m).
fn along(rows: &[SoilRow], [low_m, high_m]: [f64; 2], [from_m, to_m]: [f64; 2]) -> FrameSoil {
    let mut own = Vec::new();
    for pair in rows.windows(2) {
        let (below, above) = (&pair[0], &pair[1]);
        let ends_m = [below.height_m.max(low_m), above.height_m.min(high_m)];
        if ends_m[0] >= ends_m[1] {
            continue;
        }
        own.extend(ends_m.map(|height_m| {
            let share = (height_m - below.height_m) / (above.height_m - below.height_m);
            FrameSoilRow {
                fraction: (height_m - from_m) / (to_m - from_m),
                stiffness: below.stiffness.blend(&above.stiffness, share),
            }
        }));
    }
    if to_m < from_m {
        own.reverse();
    }
    FrameSoil { rows: own }
}

/// The matrix of springs (x, y, z, rotation about x, y, z), which are the same in all directions
/// across a pile, with z along its direction: a 1 + (b − a) n nᵀ for translations and rotations.
fn at_tip(springs: [f64; 6], direction: [f64; 3]) -> SpatialMatrix {
    let mut matrix = [[0.0; 6]; 6];
    for first in [0, 3] {
        let (across, along) = (springs[first], springs[first + 2]);
        for i in 0..3 {
            matrix[first + i][first + i] += across;
            for j in 0..3 {
                matrix[first + i][first + j] += (along - across) * direction[i] * direction[j];
            }
        }
    }
    matrix
}

/// Adds a stiffness to the support of a joint, or gives it a support.
fn add_support(frame: &mut FrameDescription, joint: usize, stiffness: &SpatialMatrix) {
    if *stiffness == [[0.0; 6]; 6] {
        return;
    }
    let mut supports = frame.supports.iter_mut();
    if let Some(support) = supports.find(|support| support.joint == joint) {
        return add_scaled(&mut support.stiffness, 1.0, stiffness);
    }
    frame.supports.push(FrameSupport {
        fixed: [false; 6],
        stiffness: *stiffness,
        ..FrameSupport::clamped(joint)
    });
}
