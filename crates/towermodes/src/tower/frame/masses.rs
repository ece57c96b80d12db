//! The mass of a frame by substance.

use super::coat::{CoatKind, FrameCoat, Substance};
use super::description::FrameDescription;
use super::member::{FrameMember, MemberKind};
use super::validate::Frame;
use crate::tower::parts::rigid_body::RigidBody;

/// The mass of a frame by kind, kg. All but the last value are masses of the frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FrameMasses {
    /// The structural members.
    pub members_kg: f64,
    /// Marine growth around members.
    pub growth_kg: f64,
    /// Water, or another filling, in members.
    pub filling_kg: f64,
    /// Masses on joints.
    pub joints_kg: f64,
    /// Soil that moves with the supports.
    pub soil_kg: f64,
    /// Water around members that moves with them across their axes. It has no weight.
    pub added_kg: f64,
}

impl Frame {
    /// The mass of the frame by kind: members, growth, filling, joints, soil, added mass.
    pub fn masses(&self) -> FrameMasses {
        let description = self.description();
        let of_joints = description.masses.iter().map(|(_, body)| body.mass_kg);
        let of_soil = description.supports.iter().map(|s| s.inertia[0][0]);
        // The sum of an empty list would be −0.
        let mut masses = FrameMasses {
            joints_kg: 0.0 + of_joints.sum::<f64>(),
            soil_kg: 0.0 + of_soil.sum::<f64>(),
            ..FrameMasses::default()
        };
        for member in &description.members {
            masses.add(member, self.length_m(member), self.member_mass_kg(member));
        }
        masses
    }

    /// Members and masses on joints as one point mass at their centre of mass (m), without growth
    /// and filling.
    pub fn body(&self) -> RigidBody {
        let FrameDescription {
            joints,
            members,
            masses,
            ..
        } = self.description();
        let on_joint = |(joint, body): &(usize, RigidBody)| {
            let at_m = joints[*joint].position_m;
            point(
                body.mass_kg,
                std::array::from_fn(|i| at_m[i] + body.center_m[i]),
            )
        };
        let of_members = members.iter().map(|member| self.body_of(member));
        let all: Vec<RigidBody> = of_members.chain(masses.iter().map(on_joint)).collect();
        let whole = RigidBody::combined(&all);
        point(whole.mass_kg, whole.center_m)
    }

    /// The same with growth and filling.
    pub(crate) fn body_with_coats(&self) -> RigidBody {
        let joints = &self.description().joints;
        let mut all = vec![self.body()];
        for member in &self.description().members {
            let [from_m, to_m] = member.joints.map(|j| joints[j].position_m);
            let length_m = self.length_m(member);
            let solids = member
                .coats
                .iter()
                .filter(|coat| match coat.kind.substance() {
                    Substance::Filling | Substance::Growth => true,
                    Substance::Water => false,
                });
            all.extend(solids.map(|coat| {
                let middle = 0.5 * (coat.range[0] + coat.range[1]);
                let at_m = |i: usize| from_m[i] + middle * (to_m[i] - from_m[i]);
                point(coat.mass_kg(length_m), std::array::from_fn(at_m))
            }));
        }
        let whole = RigidBody::combined(&all);
        point(whole.mass_kg, whole.center_m)
    }

    /// The mass of a member and its centre.
    fn body_of(&self, member: &FrameMember) -> RigidBody {
        let [from_m, to_m] = member
            .joints
            .map(|j| self.description().joints[j].position_m);
        let (mass_kg, fraction) = match &member.kind {
            // The mass per length is quadratic: Simpson's rule is exact for its moment too.
            MemberKind::Beam { ends, material } => {
                let [a, b, c] = [0.0, 0.5, 1.0].map(|s| ends.at(s, material).masses.mass_kg_per_m);
                let sum = a + 4.0 * b + c;
                let fraction = if sum > 0.0 { (2.0 * b + c) / sum } else { 0.5 };
                (self.length_m(member) * sum / 6.0, fraction)
            }
            MemberKind::Cable { .. } | MemberKind::Rigid { .. } | MemberKind::Spring(_) => {
                (self.member_mass_kg(member), 0.5)
            }
        };
        let at_m = |i: usize| from_m[i] + fraction * (to_m[i] - from_m[i]);
        point(mass_kg, std::array::from_fn(at_m))
    }
}

fn point(mass_kg: f64, center_m: [f64; 3]) -> RigidBody {
    RigidBody {
        mass_kg,
        center_m,
        ..RigidBody::default()
    }
}

impl FrameMasses {
    /// Adds a member of this length (m) and mass (kg).
    fn add(&mut self, member: &FrameMember, length_m: f64, mass_kg: f64) {
        let mut coats_kg = 0.0;
        for coat in &member.coats {
            let mass_kg = coat.mass_kg(length_m);
            coats_kg += mass_kg;
            match coat.kind.substance() {
                Substance::Filling => self.filling_kg += mass_kg,
                Substance::Growth => self.growth_kg += mass_kg,
                Substance::Water => self.added_kg += coat.added_mass_kg(length_m),
            }
        }
        self.members_kg += mass_kg - coats_kg;
    }
}

impl FrameCoat {
    /// Added mass across a member of this length (m), kg; 0 for a solid.
    fn added_mass_kg(&self, length_m: f64) -> f64 {
        let CoatKind::AddedMass {
            density_kg_per_m3,
            radius_m: [r, s],
            across: [a, b],
            ..
        } = self.kind
        else {
            return 0.0;
        };
        // The square of the radius times the coefficient is cubic: Simpson's rule is exact.
        let (middle_m, middle) = (0.5 * (r + s), 0.5 * (a + b));
        let sum = r * r * a + 4.0 * middle_m * middle_m * middle + s * s * b;
        let [from, to] = self.range;
        density_kg_per_m3 * std::f64::consts::PI * (to - from) * length_m * sum / 6.0
    }
}
