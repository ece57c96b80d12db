//! The mass of a frame by what it is.

use super::coat::{CoatKind, FrameCoat, Substance};
use super::member::FrameMember;
use super::validate::Frame;

/// The mass of a frame by what it is, kg. All but the last are that of the frame.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FrameMasses {
    /// The members themselves.
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
    /// Its mass by what it is.
    pub fn masses(&self) -> FrameMasses {
        let description = self.description();
        let of_joints = description.masses.iter().map(|(_, body)| body.mass_kg);
        let of_soil = description.supports.iter().map(|s| s.inertia[0][0]);
        // The sum of nothing would be −0.
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
