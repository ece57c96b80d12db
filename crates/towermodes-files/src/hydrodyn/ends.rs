//! The ends of strip members: added mass along the axis and growth on the surface.
//!
//! Source: HydroDyn Theory Manual (2024), lumped loads at joints: V = Σ ±(2/3) π R³ k and A = Σ ±π
//! R² k over the members of a joint, with outward axes k and the radius R including growth; the
//! added mass is Cₓ ρ V Vᵀ/|V| and the mass of growth ρ t |A|. A rectangle is replaced by the
//! circle of the same area, R = √(a b/π). The volume of growth in the summary file of HydroDyn is
//! that of the members without these ends.

use std::f64::consts::PI;

use super::growth::Growth;
use super::section::Outline;
use super::spatial::{Tensor, Vector, norm};
use super::strip::StripMember;
use super::water::SeaWater;

/// The mass that moves with a joint of strip members.
#[derive(Debug, Clone, PartialEq)]
pub struct StripEnd {
    /// The number of the joint in the file.
    pub joint: String,
    /// Its position, m.
    pub position_m: [f64; 3],
    /// Added mass by direction, kg.
    pub added_mass: [[f64; 3]; 3],
    /// Mass of the growth, kg.
    pub growth_kg: f64,
}

/// A joint and its coefficient Cₓ.
#[derive(Debug, Clone)]
pub(super) struct Joint {
    pub(super) name: String,
    pub(super) position_m: Vector,
    pub(super) axial: f64,
}

/// If the sum is below this share of a single member, the members of a joint cancel.
const CANCELS: f64 = 1e-9;

/// The joints in the water whose members do not cancel; `joints_of` gives the joints of each
/// member.
pub(super) fn of(
    joints: &[Joint],
    members: &[StripMember],
    joints_of: &[[usize; 2]],
    growth: &Growth,
    water: &SeaWater,
) -> Vec<StripEnd> {
    let mut sums = vec![Sums::default(); joints.len()];
    for (member, ends) in members.iter().zip(joints_of) {
        if !member.is_potential_flow {
            add_member(&mut sums, member, ends);
        }
    }
    let pairs = joints.iter().zip(&sums);
    let wet = pairs.filter(|(joint, _)| water.holds(joint.position_m[2]));
    wet.filter_map(|(joint, sums)| sums.end(joint, growth, water))
        .collect()
}

/// The sums of a joint, without growth: the sections of its members with their outward axes.
#[derive(Debug, Clone, Default)]
struct Sums {
    members: Vec<(Outline, Vector)>,
}

fn add_member(sums: &mut [Sums], member: &StripMember, joints: &[usize; 2]) {
    let axis = member.axis();
    let (Some(first), Some(last)) = (member.stretches.first(), member.stretches.last()) else {
        return;
    };
    let ends = [
        (first.section.outer(0.0), -1.0),
        (last.section.outer(1.0), 1.0),
    ];
    for (joint, (outline, sign)) in joints.iter().zip(ends) {
        sums[*joint].members.push((outline, axis.map(|k| sign * k)));
    }
}

impl Sums {
    fn end(&self, joint: &Joint, growth: &Growth, water: &SeaWater) -> Option<StripEnd> {
        let z_m = joint.position_m[2];
        let layer = growth.between([z_m; 2]);
        let thickness_m = layer.map_or(0.0, |layer| layer.thickness_m[0]);
        let density = layer.map_or(0.0, |layer| layer.density_kg_per_m3[0]);
        let grown = |outline: Outline| outline.grown(thickness_m);
        let volume = self.sum(|outline| 2.0 / 3.0 * PI * grown(outline).radius_m().powi(3));
        let area = self.sum(|outline| grown(outline).area_m2());
        let per_volume = joint.axial * water.density_kg_per_m3;
        let added_mass: Tensor = match norm(volume) {
            0.0 => [[0.0; 3]; 3],
            size => volume.map(|a| volume.map(|b| per_volume * a * b / size)),
        };
        let growth_kg = density * thickness_m * norm(area);
        let is_some = growth_kg > 0.0 || added_mass != [[0.0; 3]; 3];
        is_some.then(|| StripEnd {
            joint: joint.name.clone(),
            position_m: joint.position_m,
            added_mass,
            growth_kg,
        })
    }

    /// A vector sum along the outward axes; zero if it is a rounding error.
    fn sum(&self, size: impl Fn(Outline) -> f64) -> Vector {
        let mut sum = [0.0; 3];
        let mut largest = 0.0_f64;
        for (outline, axis) in &self.members {
            let size = size(*outline);
            largest = largest.max(size);
            for (sum, k) in sum.iter_mut().zip(axis) {
                *sum += size * k;
            }
        }
        match norm(sum) > CANCELS * largest {
            true => sum,
            false => [0.0; 3],
        }
    }
}
