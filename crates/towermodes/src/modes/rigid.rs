//! The rigid-body modes of a floating tower, and their names.

use super::family::Family;
use crate::space::{SpatialMatrix, times};
use crate::symmetric::eigenpairs;
use crate::tower::{Motion, Plane};

/// A mode is a rigid-body mode if rigid-body motions have at least this fraction of its kinetic
/// energy.
const RIGID: f64 = 0.5;
/// A rigid-body mode may have the name of a motion with at least this fraction of that energy.
const NAMED: f64 = 0.25;

/// The whole tower as one rigid body.
pub(crate) struct RigidTower {
    inertia: SpatialMatrix,
    /// Its inverse.
    flexibility: SpatialMatrix,
}

/// The rigid-body motions in a mode, as fractions of its kinetic energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RigidShares {
    /// Of surge, sway, heave, roll, pitch, yaw, about the height in each plane where a push does
    /// not turn the tower.
    motions: [f64; 6],
    /// Of all together.
    total: f64,
}

impl RigidTower {
    /// The rigid body with this inertia about the base (kg, kg m, kg m²).
    pub(crate) fn new(inertia: &SpatialMatrix) -> Self {
        Self {
            inertia: *inertia,
            flexibility: inverse(inertia),
        }
    }

    /// What a mode of kinetic energy 1 with these products of its inertia forces with rigid motions
    /// about the base has in common with them: the rigid motion a nearest to it solves R a = f.
    pub(crate) fn shares(&self, force: &[f64; 6]) -> RigidShares {
        let a = times(&self.flexibility, force);
        RigidShares {
            motions: self.coordinates(&a).map(|x| x * x),
            total: a.iter().zip(force).map(|(a, f)| a * f).sum(),
        }
    }

    /// Surge, sway, heave, roll, pitch and yaw in a rigid motion of the base: square roots of twice
    /// their kinetic energies over the square of the frequency, with the sign of the motion.
    pub(crate) fn coordinates(&self, a: &[f64; 6]) -> [f64; 6] {
        let inertia = &self.inertia;
        let mut motions = [0.0; 6];
        for plane in [Plane::ForeAft, Plane::SideSide] {
            let components = Motion::Bending(plane).components();
            let ((w, _), (theta, sign)) = (components[0], components[1]);
            let (mass, moment) = (inertia[w][w], sign * inertia[w][theta]);
            let (deflection, rotation) = (a[w], sign * a[theta]);
            let about_centre = inertia[theta][theta] - moment * moment / mass;
            motions[w] = mass.sqrt() * (deflection + moment / mass * rotation);
            motions[theta] = about_centre.sqrt() * rotation;
        }
        motions[2] = inertia[2][2].sqrt() * a[2];
        motions[5] = inertia[5][5].sqrt() * a[5];
        motions
    }
}

impl RigidShares {
    /// The motion with the largest fraction among those not taken, if the mode is a rigid-body mode
    /// and the fraction is large enough for the name.
    pub(crate) fn name(&self, taken: &[bool; 6]) -> Option<usize> {
        let free = (0..6).filter(|&motion| !taken[motion]);
        let largest = free.max_by(|&a, &b| self.motions[a].total_cmp(&self.motions[b]))?;
        let is_named = self.total >= RIGID && self.motions[largest] >= NAMED * self.total;
        is_named.then_some(largest)
    }
}

/// Names modes by rising frequency: each name once, lower modes before higher ones, so that a
/// longer list changes no name.
#[derive(Debug, Default)]
pub(crate) struct RigidNames {
    taken: [bool; 6],
}

impl RigidNames {
    /// The name of the next mode, if it is rigid.
    pub(crate) fn name(&mut self, mode: &RigidShares) -> Option<Family> {
        let motion = mode.name(&self.taken)?;
        self.taken[motion] = true;
        Some(Family::RIGID[motion])
    }
}

/// R⁻¹ of a positive definite matrix; zero for motions without inertia.
fn inverse(matrix: &SpatialMatrix) -> SpatialMatrix {
    let scale: [f64; 6] = std::array::from_fn(|i| {
        if matrix[i][i] > 0.0 {
            1.0 / matrix[i][i].sqrt()
        } else {
            0.0
        }
    });
    let scaled: SpatialMatrix =
        std::array::from_fn(|i| std::array::from_fn(|j| scale[i] * scale[j] * matrix[i][j]));
    let (values, vectors) = eigenpairs(scaled);
    let mut inverse = [[0.0; 6]; 6];
    for (value, vector) in values
        .iter()
        .zip(&vectors)
        .filter(|(value, _)| **value > 1e-12)
    {
        for i in 0..6 {
            for j in 0..6 {
                inverse[i][j] += scale[i] * scale[j] * vector[i] * vector[j] / value;
            }
        }
    }
    inverse
}
