//! Water around members and in them, and marine growth, as in `HydroDyn`: in strips along the
//! members and at their ends.

use std::f64::consts::PI;

use towermodes::RigidBody;
use towermodes::frame::{
    CoatKind, FrameCoat, FrameDescription, FrameMember, MemberKind, SectionEnds,
};

/// Water up to z = 0 with coefficients of added mass of 1.
pub(super) struct Sea {
    pub(super) density_kg_per_m3: f64,
    pub(super) bed_m: f64,
    pub(super) growth: Option<Growth>,
}

/// Marine growth between two heights.
pub(super) struct Growth {
    pub(super) range_m: [f64; 2],
    pub(super) thickness_m: f64,
    pub(super) density_kg_per_m3: f64,
}

impl Sea {
    /// The mass of the water in a member between two heights (m), up to the surface.
    pub(super) fn filling(&self, heights_m: [f64; 2], inner_radius_m: f64) -> Option<FrameCoat> {
        let kind = CoatKind::Solid {
            density_kg_per_m3: [self.density_kg_per_m3; 2],
            outer_radius_m: [inner_radius_m; 2],
            inner_radius_m: [0.0; 2],
        };
        let range = between(heights_m, [self.bed_m, 0.0])?;
        Some(FrameCoat { range, kind })
    }

    /// Adds the water around all members, their growth, and both at the member ends.
    pub(super) fn add_to(&self, frame: &mut FrameDescription) {
        let mut ends = vec![End::default(); frame.joints.len()];
        let FrameDescription {
            joints, members, ..
        } = frame;
        for member in members {
            let at = member.joints.map(|joint| joints[joint].position_m);
            self.surround(member, at.map(|position| position[2]));
            let radius_m = radius_m(member);
            let length_m = distance_m(at);
            for (end, joint) in member.joints.into_iter().enumerate() {
                let outward = std::array::from_fn(|i| (at[end][i] - at[1 - end][i]) / length_m);
                self.add_end(&mut ends[joint], at[end][2], radius_m, outward);
            }
        }
        for (joint, end) in ends.iter().enumerate() {
            let growth_kg = end.growth_kg();
            if growth_kg > 0.0 {
                frame
                    .masses
                    .push((joint, RigidBody::point(growth_kg, [0.0; 3])));
            }
            if let Some(matrix) = end.added_mass(self.density_kg_per_m3) {
                frame.added_masses.push((joint, matrix));
            }
        }
    }

    /// Adds the water around a member between two heights (m), and its growth.
    fn surround(&self, member: &mut FrameMember, heights_m: [f64; 2]) {
        let radius_m = radius_m(member);
        let mut water = |range_m: [f64; 2], thickness_m: f64| {
            let Some(range) = between(heights_m, range_m) else {
                return;
            };
            let kind = CoatKind::AddedMass {
                density_kg_per_m3: self.density_kg_per_m3,
                radius_m: [radius_m + thickness_m; 2],
                across: [1.0; 2],
                along: [1.0; 2],
            };
            member.coats.push(FrameCoat { range, kind });
        };
        let Some(growth) = &self.growth else {
            return water([self.bed_m, 0.0], 0.0);
        };
        let [low_m, high_m] = growth.range_m;
        water([self.bed_m, low_m], 0.0);
        water(growth.range_m, growth.thickness_m);
        water([high_m, 0.0], 0.0);
        if let Some(range) = between(heights_m, growth.range_m) {
            let kind = CoatKind::Solid {
                density_kg_per_m3: [growth.density_kg_per_m3; 2],
                outer_radius_m: [radius_m + growth.thickness_m; 2],
                inner_radius_m: [radius_m; 2],
            };
            member.coats.push(FrameCoat { range, kind });
        }
    }

    /// Adds the end of a member at a height (m) to the sum of its joint, if it is in the water.
    fn add_end(&self, end: &mut End, height_m: f64, radius_m: f64, outward: [f64; 3]) {
        if !(self.bed_m..=0.0).contains(&height_m) {
            return;
        }
        let is_grown =
            |growth: &&Growth| (growth.range_m[0]..=growth.range_m[1]).contains(&height_m);
        let growth = self.growth.as_ref().filter(is_grown);
        let thickness_m = growth.map_or(0.0, |growth| growth.thickness_m);
        let volume_m3 = 2.0 / 3.0 * PI * (radius_m + thickness_m).powi(3);
        let growth_kg = growth.map_or(0.0, |growth| {
            growth.density_kg_per_m3
                * growth.thickness_m
                * PI
                * (radius_m + growth.thickness_m).powi(2)
        });
        for (i, direction) in outward.into_iter().enumerate() {
            end.volume_m3[i] += volume_m3 * direction;
            end.growth_kg[i] += growth_kg * direction;
        }
    }
}

/// The sum of all member ends at a joint: half spheres of water and plates of growth, which cancel
/// if a member continues another one.
#[derive(Clone, Default)]
struct End {
    volume_m3: [f64; 3],
    growth_kg: [f64; 3],
}

impl End {
    fn growth_kg(&self) -> f64 {
        length(self.growth_kg)
    }

    /// ρ V Vᵀ/|V| for translations.
    fn added_mass(&self, density_kg_per_m3: f64) -> Option<[[f64; 6]; 6]> {
        let size = length(self.volume_m3);
        if size < 1e-12 {
            return None;
        }
        let entry =
            |i: usize, j: usize| density_kg_per_m3 * self.volume_m3[i] * self.volume_m3[j] / size;
        let is_translation = |i: usize, j: usize| i < 3 && j < 3;
        Some(std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                if is_translation(i, j) {
                    entry(i, j)
                } else {
                    0.0
                }
            })
        }))
    }
}

fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn distance_m([a, b]: [[f64; 3]; 2]) -> f64 {
    length(std::array::from_fn(|i| b[i] - a[i]))
}

/// The outer radius of a tube, m.
fn radius_m(member: &FrameMember) -> f64 {
    match &member.kind {
        MemberKind::Beam {
            ends: SectionEnds::Tube([tube, _]),
            ..
        } => 0.5 * tube.outer_diameter_m,
        _ => 0.0,
    }
}

/// The part of the member between two heights (m) that lies between two other heights, as fractions
/// of its length.
fn between([from_m, to_m]: [f64; 2], [low_m, high_m]: [f64; 2]) -> Option<[f64; 2]> {
    let rise_m = to_m - from_m;
    if rise_m == 0.0 {
        return (low_m..high_m).contains(&from_m).then_some([0.0, 1.0]);
    }
    let (a, b) = ((low_m - from_m) / rise_m, (high_m - from_m) / rise_m);
    let range = [a.min(b).max(0.0), a.max(b).min(1.0)];
    (range[1] > range[0] + 1e-9).then_some(range)
}
