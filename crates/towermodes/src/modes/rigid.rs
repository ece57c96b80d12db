//! A floating tower as one rigid body, and the fractions of a mode in its rigid-body motions.

use crate::space::{SpatialMatrix, times};
use crate::symmetric::eigenpairs;
use crate::tower::{Motion, Plane};

/// The whole tower as one rigid body.
pub(crate) struct RigidTower {
    inertia: SpatialMatrix,
    /// The inverse of its inertia matrix.
    flexibility: SpatialMatrix,
}

impl RigidTower {
    /// The rigid body with this inertia about the base (kg, kg m, kg m²).
    pub(crate) fn new(inertia: &SpatialMatrix) -> Self {
        Self {
            inertia: *inertia,
            flexibility: inverse(inertia),
        }
    }

    /// The fractions of the kinetic energy of a mode in surge, sway, heave, roll, pitch and yaw,
    /// about the height in each plane at which a horizontal force causes no rotation. The mode has
    /// kinetic energy 1, and its inertia forces have these products f with rigid motions about the
    /// base: the rigid motion a nearest to it solves R a = f. Each of the six sums to 1 over all
    /// modes.
    pub(crate) fn shares(&self, force: &[f64; 6]) -> [f64; 6] {
        let a = times(&self.flexibility, force);
        self.coordinates(&a).map(|x| x * x)
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
