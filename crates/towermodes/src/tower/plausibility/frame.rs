//! The frame under a tower: its members, and the position of the tower on it.

use super::Given;
use super::usual::check_inputs;
use crate::tower::frame::{FrameFoundation, FramePart, FrameWarning};
use crate::tower::{Ineffective, Place, Site, Tower, Warning};

/// Largest height of a transition piece, m.
const HIGH_M: f64 = 12.0;
/// Largest distance of the tower base below the highest joint of its transition piece, m.
const BELOW_M: f64 = 0.5;
/// Largest distance of the axis of a tower from the middle of the joints that carry it, m.
const BESIDE_M: f64 = 1.0;

pub(super) fn check(
    tower: &Tower,
    given: &Given<'_>,
    foundation: &FrameFoundation,
    warnings: &mut Vec<Warning>,
) {
    // The values of the tower's own materials were checked.
    let of_tower = |member: usize| matches!(foundation.materials.get(member), Some(Some(_)));
    let found = foundation.frame.warnings().into_iter();
    let found = found.filter(|warning| match warning {
        FrameWarning::UnusualModulus { member, .. }
        | FrameWarning::UnusualDensity { member, .. }
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
    // The reference point of a floater is at still water level.
    if is_far && foundation.platform.mass_kg > 0.0 && foundation.restoring.is_none() {
        return Some(Warning::FarReference {
            site,
            reference_m,
            base_m,
        });
    }
    if !(-BELOW_M..=HIGH_M).contains(&(base_m - highest_m)) {
        return Some(Warning::HighTransition {
            site,
            base_m,
            joints_m: highest_m,
        });
    }
    let beside_m = beside_m(foundation)?;
    (beside_m > BESIDE_M).then_some(Warning::TowerBesideJoints { site, beside_m })
}

/// The distance of the axis of the tower from the middle of the joints that carry it, m.
fn beside_m(foundation: &FrameFoundation) -> Option<f64> {
    let description = foundation.frame.description();
    let joints = &description.transition.as_ref()?.joints;
    let middle = |axis: usize| {
        let positions_m = joints
            .iter()
            .map(|j| description.joints[*j].position_m[axis]);
        positions_m.sum::<f64>() / joints.len() as f64
    };
    let [x_m, y_m, _] = foundation.reference_m();
    Some((middle(0) - x_m).hypot(middle(1) - y_m))
}
