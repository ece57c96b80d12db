//! The centrifugal stiffness of a rigid body at the tip of a blade.

use crate::space::SpatialMatrix;
use crate::tower::RigidBody;

type Tensor = [[f64; 3]; 3];

/// The directions in the rotor's plane: X and Z.
const IN_PLANE: [usize; 2] = [0, 2];

const NONE: SpatialMatrix = [[0.0; 6]; 6];

/// The stiffness due to rotation against motions of a body at the tip, `tip_m` (m) from the rotor's
/// axis, at Ω² = `speed_squared` (rad²/s²): N/m, N, N m. The tension that the body causes in the
/// blade is not included.
///
/// The potential of the centrifugal forces is −½ Ω² ∫ |P r|² dm, with P r the part of r normal to
/// the rotor's axis. A point of the body that is ρ from the tip moves to r₀ + u + R ρ, where R
/// turns by the slopes first and by the twist about the deformed axis then: R = 1 + B + T + ½ B² +
/// B T + ½ T² with B the cross product of the bending rotations and T that of the twist.
pub(super) fn centrifugal_stiffness(
    tip: &RigidBody,
    tip_m: f64,
    speed_squared: f64,
) -> SpatialMatrix {
    let moment = tip.center_m.map(|c| tip.mass_kg * c);
    let second_moments = second_moments(tip);
    let mut matrix = NONE;
    for i in IN_PLANE {
        matrix[i][i] = -speed_squared * tip.mass_kg;
    }
    for a in 0..3 {
        for i in IN_PLANE {
            let moved = dot(&generator(a)[i], &moment);
            set(&mut matrix, i, 3 + a, -speed_squared * moved);
        }
        for b in 0..3 {
            let turned = turned(a, b, &second_moments);
            let outwards = dot(&second_order(a, b)[2], &moment);
            matrix[3 + a][3 + b] = -speed_squared * (turned + tip_m * outwards);
        }
    }
    matrix
}

/// ∫ |P W ρ|² + ρᵀ P N ρ dm for rotations a and b: the contribution of the extent of the body, kg
/// m².
fn turned(a: usize, b: usize, second_moments: &Tensor) -> f64 {
    let (first, then, second) = (generator(a), generator(b), second_order(a, b));
    let rows = IN_PLANE.into_iter().map(|i| {
        let moved = second_moments.map(|row| dot(&row, &then[i]));
        dot(&first[i], &moved) + dot(&second[i], &second_moments[i])
    });
    rows.sum()
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// ∫ ρ ρᵀ dm of a body about the tip, kg m²: ½ tr(J) 1 − J.
fn second_moments(body: &RigidBody) -> Tensor {
    let about_tip = body.tensor_about([0.0; 3]);
    let half_trace = 0.5 * (about_tip[0][0] + about_tip[1][1] + about_tip[2][2]);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let diagonal = if i == j { half_trace } else { 0.0 };
            diagonal - about_tip[i][j]
        })
    })
}

/// The cross product e_a ×.
fn generator(a: usize) -> Tensor {
    let mut matrix = [[0.0; 3]; 3];
    let (b, c) = ((a + 1) % 3, (a + 2) % 3);
    matrix[c][b] = 1.0;
    matrix[b][c] = -1.0;
    matrix
}

/// Twice the second-order part of R for the rotations a and b: both halves of B² + 2 B T + T².
fn second_order(a: usize, b: usize) -> Tensor {
    let product = |first: usize, then: usize| -> Tensor {
        let (left, right) = (generator(first), generator(then));
        std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..3).map(|k| left[i][k] * right[k][j]).sum())
        })
    };
    match (a, b) {
        (2, _) => product(b, 2),
        (_, 2) => product(a, 2),
        _ => {
            let (one, other) = (product(a, b), product(b, a));
            std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (one[i][j] + other[i][j])))
        }
    }
}

/// Sets both entries of a symmetric matrix.
fn set(matrix: &mut SpatialMatrix, i: usize, j: usize, value: f64) {
    matrix[i][j] = value;
    matrix[j][i] = value;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tower::Inertia;

    const SPEED_SQUARED: f64 = 2.5;
    const TIP_M: f64 = 4.0;

    /// Masses that make a body without any symmetry.
    const MASSES: [(f64, [f64; 3]); 4] = [
        (1.0, [0.3, -0.2, 0.1]),
        (2.0, [-0.1, 0.4, 0.5]),
        (0.5, [0.2, 0.6, -0.3]),
        (1.5, [0.0, -0.3, 0.2]),
    ];

    fn body() -> RigidBody {
        let points = MASSES.map(|(mass, at)| RigidBody::point(mass, at));
        RigidBody::combined(&points)
    }

    /// exp(θ ×), by Rodrigues.
    fn rotation(theta: [f64; 3]) -> Tensor {
        let angle = theta.iter().map(|t| t * t).sum::<f64>().sqrt();
        let (first, second) = match angle {
            0.0 => (1.0, 0.5),
            _ => (angle.sin() / angle, (1.0 - angle.cos()) / (angle * angle)),
        };
        let w: Tensor = std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..3).map(|a| theta[a] * generator(a)[i][j]).sum())
        });
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let square: f64 = (0..3).map(|k| w[i][k] * w[k][j]).sum();
                f64::from(u8::from(i == j)) + first * w[i][j] + second * square
            })
        })
    }

    /// −½ Ω² ∫ |P r|² dm of the body moved by (u, θ): slopes first, then the twist about the axis
    /// that has turned with them.
    fn potential(motion: [f64; 6]) -> f64 {
        let [x, _, z, rx, ry, rz] = motion;
        let (bent, twisted) = (rotation([rx, ry, 0.0]), rotation([0.0, 0.0, rz]));
        let energies = MASSES.map(|(mass, at)| {
            let at = twisted.map(|row| dot(&row, &at));
            let at = bent.map(|row| dot(&row, &at));
            let (x, z) = (at[0] + x, at[2] + z + TIP_M);
            -0.5 * SPEED_SQUARED * mass * (x * x + z * z)
        });
        energies.iter().sum()
    }

    #[test]
    fn the_stiffness_is_the_curvature_of_the_centrifugal_potential() {
        let step = 1e-3;
        let at = |i: usize, j: usize, a: f64, b: f64| {
            let mut motion = [0.0; 6];
            motion[i] += a * step;
            motion[j] += b * step;
            potential(motion)
        };
        let matrix = centrifugal_stiffness(&body(), TIP_M, SPEED_SQUARED);
        for (i, row) in matrix.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                let corners = at(i, j, 1.0, 1.0) - at(i, j, 1.0, -1.0) - at(i, j, -1.0, 1.0)
                    + at(i, j, -1.0, -1.0);
                let curvature = corners / (4.0 * step * step);
                let difference = (entry - curvature).abs();
                assert!(difference < 1e-4, "({i}, {j}): {entry} and {curvature}");
            }
        }
    }

    #[test]
    fn a_body_keeps_its_second_moments() {
        let expected = MASSES.map(|(mass, at)| mass * at[0] * at[2]);
        let second_moments = second_moments(&body());
        assert!((second_moments[0][2] - expected.iter().sum::<f64>()).abs() < 1e-14);
        let none = RigidBody::massless(Inertia::default());
        assert_eq!(
            centrifugal_stiffness(&none, TIP_M, SPEED_SQUARED)[4][4],
            0.0
        );
    }
}
