//! The frame under a tower: its members, and where the tower begins on it.

use super::Given;
use super::usual::check_inputs;
use crate::tower::frame::{FrameFoundation, FramePart, FrameWarning};
use crate::tower::{Ineffective, Place, Site, Tower, Warning};

/// A transition piece is at most this high, m.
const HIGH_M: f64 = 12.0;

pub(super) fn check(
    tower: &Tower,
    given: &Given<'_>,
    foundation: &FrameFoundation,
    warnings: &mut Vec<Warning>,
) {
    // The moduli of the tower's own materials were checked.
    let of_tower = |member: usize| matches!(foundation.materials.get(member), Some(Some(_)));
    let found = foundation.frame.warnings().into_iter();
    let found = found.filter(|warning| match warning {
        FrameWarning::UnusualModulus { member, .. }
        | FrameWarning::ShearAboveYoungs { member, .. } => !of_tower(*member),
        FrameWarning::UnusualWall { .. }
        | FrameWarning::LargeDiameter { .. }
        | FrameWarning::Long { .. }
        | FrameWarning::Far { .. }
        | FrameWarning::SameJoints { .. } => true,
    });
    warnings.extend(found.map(|warning| {
        let part = warning.part();
        let site = Site::at(Place::Substructure { part });
        Warning::Frame { site, warning }
    }));
    warnings.extend(transition(tower, foundation));
    for (index, growth) in foundation.in_water.growth.iter().enumerate() {
        let part = FramePart::Growth(index);
        check_inputs(growth, |_| Place::Substructure { part }, warnings);
    }
    if let Some(water) = given.water
        && water.flooded
        && water.level_m <= tower.base_m()
    {
        let site = Site::at(Place::Water { key: "flooded" });
        let what = Ineffective::FloodedBesideFrame;
        warnings.push(Warning::NoEffect { site, what });
    }
}

/// A tower that begins far from the joints that carry it, or from the reference point.
fn transition(tower: &Tower, foundation: &FrameFoundation) -> Option<Warning> {
    let description = foundation.frame.description();
    let joints = description.transition.iter().flat_map(|t| &t.joints);
    let heights_m = joints.map(|joint| description.joints[*joint].position_m[2]);
    let highest_m = heights_m.max_by(f64::total_cmp)?;
    let base_m = tower.base_m();
    let part = FramePart::Transition;
    let site = Site::at(Place::Substructure { part });
    let [_, _, reference_m] = foundation.reference_m();
    let is_far = (base_m - reference_m).abs() > HIGH_M;
    // The reference point of a floater is at still water.
    if is_far && foundation.platform.mass_kg > 0.0 && foundation.restoring.is_none() {
        return Some(Warning::FarReference {
            site,
            reference_m,
            base_m,
        });
    }
    ((base_m - highest_m).abs() > HIGH_M).then_some(Warning::HighTransition {
        site,
        base_m,
        joints_m: highest_m,
    })
}
