//! The stiffness of the head of a pile or a caisson.

use super::super::parts::foundation_springs::FoundationSprings;

/// The stiffness of a foundation in one plane at its head, coupled: force and moment for the
/// displacement x and the rotation about y.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HeadStiffness {
    /// Force per displacement, N/m.
    pub lateral_n_per_m: f64,
    /// Force per rotation and moment per displacement, N: negative if the resistance is below the
    /// head.
    pub coupling_n: f64,
    /// Moment per rotation, N m.
    pub rocking_n_m: f64,
}

impl HeadStiffness {
    /// Moment per rotation of a head that is free to translate, K_R − K_LR²/K_L, N m.
    pub fn free_rocking_n_m(&self) -> f64 {
        self.rocking_n_m - self.coupling_n * self.coupling_n / self.lateral_n_per_m
    }

    /// The stiffness from the displacement and rotation of the head by a force of 1 N and by a
    /// moment of 1 N m.
    pub(super) fn from_compliance(
        displacement_by_force: f64,
        coupled: f64,
        rotation_by_moment: f64,
    ) -> Self {
        let determinant = displacement_by_force * rotation_by_moment - coupled * coupled;
        Self {
            lateral_n_per_m: rotation_by_moment / determinant,
            coupling_n: -coupled / determinant,
            rocking_n_m: displacement_by_force / determinant,
        }
    }

    /// The same stiffness with springs for the motions that the formula does not cover.
    pub(super) fn with(&self, vertical_n_per_m: f64, torsion_n_m: f64) -> FoundationSprings {
        FoundationSprings {
            lateral_n_per_m: self.lateral_n_per_m,
            rocking_n_m: self.rocking_n_m,
            coupling_n: self.coupling_n,
            vertical_n_per_m,
            torsion_n_m,
        }
    }
}
