//! Vectors in space, rotation matrices and rotation vectors.

use std::array::from_fn;

/// A vector in space.
pub(super) type Vector = [f64; 3];
/// A 3×3 matrix by rows.
pub(super) type Matrix3 = [[f64; 3]; 3];

/// The identity matrix: no rotation.
pub(super) const IDENTITY: Matrix3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

pub(super) fn sum(a: Vector, b: Vector) -> Vector {
    from_fn(|i| a[i] + b[i])
}

pub(super) fn difference(a: Vector, b: Vector) -> Vector {
    from_fn(|i| a[i] - b[i])
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn length(a: Vector) -> f64 {
    a[0].hypot(a[1]).hypot(a[2])
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The skew matrix \[a\] with \[a\] b = a × b.
pub(super) fn skew([x, y, z]: Vector) -> Matrix3 {
    [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
}

pub(super) fn times(matrix: &Matrix3, vector: Vector) -> Vector {
    matrix.map(|row| dot(row, vector))
}

pub(super) fn product(a: &Matrix3, b: &Matrix3) -> Matrix3 {
    from_fn(|i| from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

pub(super) fn transposed(a: &Matrix3) -> Matrix3 {
    from_fn(|i| from_fn(|j| a[j][i]))
}

/// The rotation matrix exp\[θ\] of a rotation vector (Rodrigues' formula).
pub(super) fn rotation(vector_rad: Vector) -> Matrix3 {
    let angle = length(vector_rad);
    let (a, b) = if angle < 1e-4 {
        let square = angle * angle;
        (1.0 - square / 6.0, 0.5 - square / 24.0)
    } else {
        let half = (0.5 * angle).sin() / angle;
        (angle.sin() / angle, 2.0 * half * half)
    };
    let skew = skew(vector_rad);
    let square = product(&skew, &skew);
    from_fn(|i| from_fn(|j| IDENTITY[i][j] + a * skew[i][j] + b * square[i][j]))
}

/// The rotation vector of a rotation matrix, of at most 180 degrees.
pub(super) fn rotation_vector(matrix: &Matrix3) -> Vector {
    let axis: Vector = [
        matrix[2][1] - matrix[1][2],
        matrix[0][2] - matrix[2][0],
        matrix[1][0] - matrix[0][1],
    ];
    let sine = 0.5 * length(axis);
    let cosine = 0.5 * (matrix[0][0] + matrix[1][1] + matrix[2][2] - 1.0);
    let angle = sine.atan2(cosine);
    if cosine > 0.0 || sine > 1e-6 {
        let factor = if sine > 1e-12 {
            0.5 * angle / sine
        } else {
            0.5
        };
        return axis.map(|a| factor * a);
    }
    // A rotation of 180 degrees about n: R = 2 n nᵀ − 1. The column of the largest entry is the
    // most accurate.
    let largest = (0..3).fold(0, |k, i| if matrix[i][i] > matrix[k][k] { i } else { k });
    let column: Vector = from_fn(|i| matrix[i][largest] + IDENTITY[i][largest]);
    let norm = length(column);
    column.map(|c| c * angle / norm)
}

/// R_x(φ) R_y(θ) R_z(ψ).
pub(super) fn rotation_of_angles([roll, pitch, yaw]: Vector) -> Matrix3 {
    let about_y_z = product(&rotation([0.0, pitch, 0.0]), &rotation([0.0, 0.0, yaw]));
    product(&rotation([roll, 0.0, 0.0]), &about_y_z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rotation_has_its_vector() {
        let pi = std::f64::consts::PI;
        for vector in [
            [0.0, 0.0, 0.0],
            [1e-9, -2e-9, 3e-9],
            [0.3, -1.2, 0.4],
            [0.0, -pi, 0.0],
            [pi * 0.6, 0.0, pi * 0.8],
        ] {
            let found = rotation_vector(&rotation(vector));
            let again = rotation(found);
            for (a, b) in rotation(vector)
                .iter()
                .flatten()
                .zip(again.iter().flatten())
            {
                assert!((a - b).abs() < 1e-9, "{vector:?} {found:?}");
            }
        }
        let found = rotation_vector(&rotation([0.3, -1.2, 0.4]));
        assert!((found[1] + 1.2).abs() < 1e-14);
    }

    #[test]
    fn angles_turn_about_the_axes_of_the_body() {
        let quarter = std::f64::consts::FRAC_PI_2;
        // After a roll of a quarter turn the body's y axis points up; a pitch turns about it.
        let matrix = rotation_of_angles([quarter, quarter, 0.0]);
        let x = times(&matrix, [1.0, 0.0, 0.0]);
        assert!((x[1] - 1.0).abs() < 1e-15, "{x:?}");
    }
}
