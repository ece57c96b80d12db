//! The ground as rows of springs along the tower and a foundation under its tip.

use super::super::parts::surroundings::SoilRow;
use super::super::support::base::Base;
use super::frame_plan::FramePlan;
use super::plan::{Lines, Plan, Section};
use super::reaction::Reactions;
use crate::space::SpatialMatrix;
use crate::tower::description::TowerDescription;
use crate::tower::foundation::{Foundation, StiffnessFoundation};

/// The heights at which the springs of the ground are computed: the same for a tower and slightly
/// changed towers.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::tower) enum GroundPlan {
    /// For the tower; empty without ground.
    OfTower(Plan),
    /// For the piles of the frame below the tower.
    OfFrame(FramePlan),
}

impl GroundPlan {
    /// The plan of a checked tower.
    pub(in crate::tower) fn of(description: &TowerDescription) -> Self {
        let foundation = description.foundation.frame();
        match foundation.zip(description.ground.as_ref()) {
            Some((foundation, ground)) => {
                Self::OfFrame(FramePlan::of(foundation.frame.description(), ground))
            }
            None => Self::OfTower(Plan::of(description)),
        }
    }

    /// The springs of the soil under the tip of a tower against x, y, z and the rotations about
    /// them; none of the piles of a frame.
    pub(in crate::tower) fn at_tip(&self, description: &TowerDescription) -> Option<[f64; 6]> {
        match self {
            Self::OfTower(plan) => Some(Reactions::of(description)?.at_tip(plan.tip_layer)),
            Self::OfFrame(_) => None,
        }
    }

    /// Relative error of a frequency by the linear interpolation.
    pub(in crate::tower) fn error(&self) -> f64 {
        match self {
            Self::OfTower(plan) => plan.error,
            Self::OfFrame(plan) => plan.error(),
        }
    }
}

impl TowerDescription {
    /// Whether soil surrounds the tower or the piles below it, as rows or in layers.
    pub fn has_soil(&self) -> bool {
        !self.soil.is_empty() || self.ground.is_some()
    }

    /// The same tower with rows of [`soil`](Self::soil) in place of the layers of
    /// [`ground`](Self::ground): the springs of each layer along the pile, with its name; those
    /// under the tip in the stiffness of the foundation; the bed of the water as low as the soil is
    /// scoured. Its frequencies are the same. Below a tower on a frame the springs are along the
    /// members of the frame and at its supports.
    ///
    /// For programs and formats that have springs only. A description that
    /// [`Tower::new`](crate::Tower::new) refuses can give springs that are not finite.
    #[must_use]
    pub fn with_ground_as_soil(&self) -> Self {
        let complete = self.clone().with_complete_frame();
        let plan = GroundPlan::of(&complete);
        let mut rows = with_rows(complete, &plan);
        if let GroundPlan::OfTower(plan) = &plan {
            rows.part_names.soil.resize(self.soil.len(), String::new());
            let layers = plan.sections.chunk_by(|a, b| a.layer == b.layer);
            for layer in layers.filter_map(|sections| sections.first()) {
                let name = self.part_names.ground.get(layer.layer);
                rows.part_names.soil.push(name.cloned().unwrap_or_default());
            }
        }
        if self.ground.is_none() {
            rows.part_names.soil.clone_from(&self.part_names.soil);
        }
        rows.part_names.ground.clear();
        rows
    }
}

/// The description with rows of soil in place of the ground: springs along the pile or the piles,
/// springs at tips in the foundation, the bed of the water scoured.
pub(in crate::tower) fn with_rows(
    mut description: TowerDescription,
    plan: &GroundPlan,
) -> TowerDescription {
    let Some(ground) = description.ground.clone() else {
        return description;
    };
    match plan {
        GroundPlan::OfTower(plan) => put_around_tower(&mut description, plan),
        GroundPlan::OfFrame(plan) => {
            if let Foundation::Frame(foundation) = &mut description.foundation {
                foundation.change(|frame| plan.apply(frame, &ground));
            }
        }
    }
    if let Some(water) = &mut description.water {
        *water = ground.lowered(*water);
    }
    description.ground = None;
    description
}

/// Puts the springs of the ground around a tower and under its tip.
fn put_around_tower(description: &mut TowerDescription, plan: &Plan) {
    let Some(reactions) = Reactions::of(description) else {
        return;
    };
    let soil = soil(description, &reactions, plan);
    let tip = reactions.at_tip(plan.tip_layer);
    drop(reactions);
    description.soil.extend(soil);
    description.foundation = on_springs(&description.foundation, tip);
}

/// The rows of each layer that touches the pile, by rising height.
fn soil(
    description: &TowerDescription,
    reactions: &Reactions<'_>,
    plan: &Plan,
) -> Vec<Vec<SoilRow>> {
    let heights_m = plan.heights_m(description, reactions);
    let of_one_layer = plan.sections.chunk_by(|a, b| a.layer == b.layer);
    let rows = of_one_layer.map(|sections| {
        let sections = sections.iter();
        let rows = sections.flat_map(|section| section.rows(reactions, &heights_m));
        rows.collect()
    });
    rows.collect()
}

impl Section {
    /// Its rows in increasing height, for these heights of the ends.
    pub(super) fn rows(&self, reactions: &Reactions<'_>, heights_m: &[f64]) -> Vec<SoilRow> {
        let parts = self.parts(&reactions.pile, heights_m);
        match self.lines {
            Lines::One => parts.flat_map(|part| part.line(reactions)).collect(),
            Lines::Pairs(_) => parts.flat_map(|part| part.pair(reactions)).collect(),
        }
    }
}

/// A foundation with springs added to the diagonal of its stiffness; they have no effect on fixed
/// motions, and under a floating platform.
fn on_springs(foundation: &Foundation, springs: [f64; 6]) -> Foundation {
    let base = Base::new(foundation, 0.0, 0.0);
    let acts = (0..6).any(|i| base.moves[i] && springs[i] != 0.0);
    if base.floats || !acts {
        return foundation.clone();
    }
    let mut stiffness: SpatialMatrix = base.stiffness;
    for i in 0..6 {
        match base.moves[i] {
            true => stiffness[i][i] += springs[i],
            false => stiffness[i][i] = f64::INFINITY,
        }
    }
    Foundation::Stiffness(Box::new(StiffnessFoundation {
        stiffness,
        inertia: base.inertia,
    }))
}
