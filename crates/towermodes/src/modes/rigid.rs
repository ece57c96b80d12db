//! The modes in which a floating tower moves as one body, and their names.

use super::family::Family;
use crate::space::SpatialMatrix;
use crate::symmetric::eigenpairs;
use crate::tower::{Motion, Plane};

/// A mode is rigid if the rigid motions have at least this share of its kinetic energy.
const RIGID: f64 = 0.5;

/// What a mode has in common with the rigid motions of the tower: energy by surge, sway, heave, roll, pitch, yaw, about the centre of
/// the inertia in each plane, as shares of the mode's kinetic energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RigidShares([f64; 6]);

impl RigidShares {
    /// Of a mode with kinetic energy 1 and these products of its inertia forces with rigid motions about the base, where the tower as one
    /// body has this inertia.
    ///
    /// The rigid motion a nearest to the mode solves R a = f with R the inertia.
    pub(crate) fn new(inertia: &SpatialMatrix, force: &[f64; 6]) -> Self {
        let a = solved(inertia, force);
        let mut shares = [0.0; 6];
        for plane in [Plane::ForeAft, Plane::SideSide] {
            let components = Motion::Bending(plane).components();
            let ((w, _), (theta, sign)) = (components[0], components[1]);
            let (mass, moment) = (inertia[w][w], sign * inertia[w][theta]);
            let (deflection, rotation) = (a[w], sign * a[theta]);
            // The deflection where a force would not turn the tower, and the inertia about there.
            let centre = deflection + moment / mass * rotation;
            shares[w] = mass * centre * centre;
            shares[theta] = (inertia[theta][theta] - moment * moment / mass) * rotation * rotation;
        }
        shares[2] = inertia[2][2] * a[2] * a[2];
        shares[5] = inertia[5][5] * a[5] * a[5];
        Self(shares)
    }

    fn is_rigid(&self) -> bool {
        self.0.iter().sum::<f64>() >= RIGID
    }
}

/// The names of those modes that are rigid, each name once: the largest shares choose first.
pub(crate) fn rigid_names(modes: &[RigidShares]) -> Vec<Option<Family>> {
    let mut names = vec![None; modes.len()];
    let mut taken = [false; 6];
    let mut choices: Vec<(usize, usize)> = Vec::new();
    for (mode, _) in modes.iter().enumerate().filter(|(_, mode)| mode.is_rigid()) {
        choices.extend((0..6).map(|motion| (mode, motion)));
    }
    choices.sort_by(|a, b| modes[b.0].0[b.1].total_cmp(&modes[a.0].0[a.1]));
    for (mode, motion) in choices {
        if names[mode].is_none() && !taken[motion] {
            names[mode] = Some(Family::RIGID[motion]);
            taken[motion] = true;
        }
    }
    names
}

/// R⁻¹ f of a positive definite matrix; motions without inertia do not move.
fn solved(matrix: &SpatialMatrix, right: &[f64; 6]) -> [f64; 6] {
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
    let mut solution = [0.0; 6];
    for (value, vector) in values
        .iter()
        .zip(&vectors)
        .filter(|(value, _)| **value > 1e-12)
    {
        let along: f64 = (0..6).map(|i| vector[i] * scale[i] * right[i]).sum();
        for i in 0..6 {
            solution[i] += scale[i] * vector[i] * along / value;
        }
    }
    solution
}
