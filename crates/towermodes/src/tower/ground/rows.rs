//! The ground as rows of springs along the tower and a foundation under its tip.

use super::super::parts::surroundings::SoilRow;
use super::super::support::base::Base;
use super::plan::{Lines, Plan};
use super::reaction::Reactions;
use crate::space::SpatialMatrix;
use crate::tower::description::TowerDescription;
use crate::tower::foundation::{Foundation, StiffnessFoundation};

impl TowerDescription {
    /// Whether soil surrounds the tower, as rows or in layers.
    pub fn has_soil(&self) -> bool {
        !self.soil.is_empty() || self.ground.is_some()
    }

    /// The same tower with rows of [`soil`](Self::soil) in place of the layers of
    /// [`ground`](Self::ground): the springs of each layer along the pile, with its name; those
    /// under the tip in the stiffness of the foundation; the bed of the water as low as the soil is
    /// scoured. Its frequencies are the same.
    ///
    /// For programs and formats that know springs only. A description that
    /// [`Tower::new`](crate::Tower::new) refuses can give springs that are not finite.
    #[must_use]
    pub fn with_ground_as_soil(&self) -> Self {
        let plan = Plan::of(self);
        let mut rows = with_rows(self.clone(), &plan);
        rows.part_names.soil.resize(self.soil.len(), String::new());
        let layers = plan.sections.chunk_by(|a, b| a.layer == b.layer);
        for layer in layers.filter_map(|sections| sections.first()) {
            let name = self.part_names.ground.get(layer.layer);
            rows.part_names.soil.push(name.cloned().unwrap_or_default());
        }
        if self.ground.is_none() {
            rows.part_names.soil.clone_from(&self.part_names.soil);
        }
        rows.part_names.ground.clear();
        rows
    }
}

/// The description with rows of soil in place of the ground: springs along the pile, springs at its
/// tip in the foundation, the bed of the water scoured.
pub(in crate::tower) fn with_rows(
    mut description: TowerDescription,
    plan: &Plan,
) -> TowerDescription {
    let Some(reactions) = Reactions::of(&description) else {
        return description;
    };
    let soil = soil(&description, &reactions, plan);
    let (tip, pile) = (reactions.at_tip(plan.tip_layer), &reactions.pile);
    let bed_m = description.water.map(|water| {
        let before_m = water.bed_m.unwrap_or(pile.ground.surface_m);
        before_m - (pile.ground.surface_m - pile.hole_m)
    });
    drop(reactions);
    description.soil.extend(soil);
    description.foundation = on_springs(&description.foundation, tip);
    if let Some(water) = &mut description.water {
        water.bed_m = bed_m;
    }
    description.ground = None;
    description
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
        let mut rows = Vec::new();
        for section in sections {
            let parts = section.parts(&reactions.pile, &heights_m);
            match section.lines {
                Lines::One => rows.extend(parts.flat_map(|part| part.line(reactions))),
                Lines::Pairs(_) => rows.extend(parts.flat_map(|part| part.pair(reactions))),
            }
        }
        rows
    });
    rows.collect()
}

/// A foundation with springs on the diagonal of its stiffness; they have no effect where it is
/// rigid, and none under a floating platform.
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
