//! The ground as rows of springs along the tower and a foundation under its tip.

use super::axial::axial_at_tip;
use super::pile::Pile;
use super::pisa::Pisa;
use super::plan::{Plan, Section};
use super::reaction::{shear_modulus_pa, springs};
use crate::space::SpatialMatrix;
use crate::tower::base::Base;
use crate::tower::description::TowerDescription;
use crate::tower::foundation::{Foundation, StiffnessFoundation};
use crate::tower::integrals::GAUSS_5;
use crate::tower::surroundings::{SoilRow, SoilStiffness};

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
    let Some(pile) = Pile::of(&description) else {
        return description;
    };
    let soil = soil(&description, &pile, plan);
    let tip = tip_stiffness(&pile, plan);
    let bed_m = description.water.map(|water| {
        let before_m = water.bed_m.unwrap_or(pile.ground.surface_m);
        before_m - (pile.ground.surface_m - pile.hole_m)
    });
    description.soil.extend(soil);
    description.foundation = on_springs(&description.foundation, tip);
    if let Some(water) = &mut description.water {
        water.bed_m = bed_m;
    }
    description.ground = None;
    description
}

/// The rows of each layer that touches the pile, by rising height.
fn soil(description: &TowerDescription, pile: &Pile<'_>, plan: &Plan) -> Vec<Vec<SoilRow>> {
    let of_one_layer = plan.sections.chunk_by(|a, b| a.layer == b.layer);
    let rows = |section: &Section| rows_of(description, pile, section);
    of_one_layer
        .map(|sections| sections.iter().flat_map(rows).collect())
        .collect()
}

/// Two rows for each part of a section; the parts are equal steps of the root of the depth.
fn rows_of(description: &TowerDescription, pile: &Pile<'_>, section: &Section) -> Vec<SoilRow> {
    let [lower_m, upper_m] =
        [section.lower, section.upper].map(|guide| guide.height_m(description, pile));
    let [deep, shallow] = [lower_m, upper_m].map(|end_m| pile.depth_m(end_m).max(0.0).sqrt());
    let border_m = |part: usize| match part {
        0 => lower_m,
        part if part == section.parts => upper_m,
        part => {
            let share = part as f64 / section.parts as f64;
            pile.hole_m - (deep + share * (shallow - deep)).powi(2)
        }
    };
    let parts = 0..section.parts;
    parts
        .flat_map(|part| line(pile, section.layer, [border_m(part), border_m(part + 1)]))
        .collect()
}

/// The springs of a part as a straight line with the same sum and the same first moment.
fn line(pile: &Pile<'_>, layer: usize, [lower_m, upper_m]: [f64; 2]) -> [SoilRow; 2] {
    const SPRINGS: usize = SoilStiffness::SPRINGS;
    let (middle_m, half_m) = (0.5 * (lower_m + upper_m), 0.5 * (upper_m - lower_m));
    let (mut mean, mut moment) = ([0.0; SPRINGS], [0.0; SPRINGS]);
    for (node, weight) in GAUSS_5 {
        let values = springs(pile, layer, middle_m + half_m * node).values();
        for spring in 0..SPRINGS {
            mean[spring] += 0.5 * weight * values[spring];
            moment[spring] += 1.5 * weight * node * values[spring];
        }
    }
    let end = |sign: f64| {
        let value = |spring: usize| {
            // No spring is negative: the sum is more important than the moment.
            let (mean, half) = (mean[spring], moment[spring]);
            mean + sign
                * if half.abs() > mean {
                    mean.copysign(half)
                } else {
                    half
                }
        };
        SoilStiffness::from_values(std::array::from_fn(value))
    };
    [(lower_m, -1.0), (upper_m, 1.0)].map(|(height_m, sign)| SoilRow {
        height_m,
        stiffness: end(sign),
    })
}

/// Stiffness of the soil under the tip against x, y, z and the rotations about them: N/m, N m.
pub(super) fn tip_stiffness(pile: &Pile<'_>, plan: &Plan) -> [f64; 6] {
    let layer = plan.tip_layer;
    let [vertical, torsion] = axial_at_tip(pile, layer);
    let (mut shear, mut moment) = (0.0, 0.0);
    if let Some(pisa) = pile.ground.layers.get(layer).and_then(Pisa::of) {
        let diameter_m = pile.diameter_m(pile.tip_m);
        let modulus_pa = shear_modulus_pa(pile, layer, pile.tip_m);
        let length = pile.length_m() / diameter_m;
        shear = pisa.shear(length) * modulus_pa * diameter_m;
        moment = pisa.moment(length) * modulus_pa * diameter_m.powi(3);
    }
    [shear, shear, vertical, moment, moment, torsion].map(|spring| spring * pile.ground.factor)
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
