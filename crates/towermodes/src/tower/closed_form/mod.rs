//! Foundations whose stiffness at the base follows by a closed form from their dimensions and the
//! soil: pure functions of the numbers in the tower file.

mod flexible_pile;
mod monopile;
mod pile_tube;
mod shadlou;
mod winkler;

pub use monopile::{Monopile, PileBehaviour, PileFormula, Slenderness};
pub use pile_tube::PileTube;
pub use winkler::WinklerPile;

use super::foundation::FoundationSprings;

/// How the modulus of the soil grows with the depth z below the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SoilProfile {
    /// The same at every depth.
    Homogeneous,
    /// With √z.
    Parabolic,
    /// With z.
    Linear,
}

/// The stiffness of a foundation in one plane at its head, coupled: force and moment for the
/// displacement x and the rotation about y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeadStiffness {
    /// Force per displacement, N/m.
    pub lateral_n_per_m: f64,
    /// Force per rotation and moment per displacement, N: negative for what holds below the head.
    pub coupling_n: f64,
    /// Moment per rotation, N m.
    pub rocking_n_m: f64,
}

impl HeadStiffness {
    /// Moment per rotation where the head is free to move sideways, K_R − K_LR²/K_L, N m.
    pub fn free_rocking_n_m(&self) -> f64 {
        self.rocking_n_m - self.coupling_n * self.coupling_n / self.lateral_n_per_m
    }

    /// With springs against the motions that the formula does not cover.
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
