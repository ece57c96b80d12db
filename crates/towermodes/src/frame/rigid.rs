//! Motions and matrices of rigid bodies at points in space.

use crate::space::SpatialMatrix;

pub(super) type Vector = [f64; 3];
pub(super) type Motion = [f64; 6];

pub(super) const NONE: SpatialMatrix = [[0.0; 6]; 6];

/// The motion of a point at `lever` (m) from one whose motion is known: [1, −[r]; 0, 1].
pub(super) fn rigid_transfer([x, y, z]: Vector) -> SpatialMatrix {
    let mut matrix = identity();
    // −[r] θ = θ × r.
    (matrix[0][4], matrix[0][5]) = (z, -y);
    (matrix[1][3], matrix[1][5]) = (-z, x);
    (matrix[2][3], matrix[2][4]) = (y, -x);
    matrix
}

pub(super) fn identity() -> SpatialMatrix {
    std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))))
}

/// Global components of a motion or force in axes given by rows: translations and rotations alike.
pub(super) fn out_of_axes(axes: &[Vector; 3], motion: &Motion) -> Motion {
    std::array::from_fn(|i| {
        let part = &motion[i / 3 * 3..i / 3 * 3 + 3];
        (0..3).map(|k| axes[k][i % 3] * part[k]).sum()
    })
}

/// The components of a motion or force in axes given by rows.
pub(super) fn into_axes(axes: &[Vector; 3], motion: &Motion) -> Motion {
    std::array::from_fn(|i| {
        let part = &motion[i / 3 * 3..i / 3 * 3 + 3];
        axes[i % 3].iter().zip(part).map(|(a, x)| a * x).sum()
    })
}

/// The matrix whose columns are those of another one out of axes.
pub(super) fn columns_out_of_axes(axes: &[Vector; 3], matrix: &SpatialMatrix) -> SpatialMatrix {
    let columns = transposed(matrix).map(|column| out_of_axes(axes, &column));
    transposed(&columns)
}

/// Aᵀ M A with the axes as rows of A: transforms a matrix from these axes to global axes.
pub(super) fn matrix_out_of_axes(axes: &[Vector; 3], matrix: &SpatialMatrix) -> SpatialMatrix {
    let half = columns_out_of_axes(axes, matrix);
    transposed(&columns_out_of_axes(axes, &transposed(&half)))
}

pub(super) fn transposed(matrix: &SpatialMatrix) -> SpatialMatrix {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[j][i]))
}

/// A B.
pub(super) fn product(a: &SpatialMatrix, b: &SpatialMatrix) -> SpatialMatrix {
    let mut sum = NONE;
    for (row, left) in sum.iter_mut().zip(a) {
        for (factor, right) in left.iter().zip(b) {
            for (sum, entry) in row.iter_mut().zip(right) {
                *sum += factor * entry;
            }
        }
    }
    sum
}

/// Aᵀ B.
pub(super) fn transposed_product(a: &SpatialMatrix, b: &SpatialMatrix) -> SpatialMatrix {
    let mut sum = NONE;
    for (left, right) in a.iter().zip(b) {
        for (row, factor) in sum.iter_mut().zip(left) {
            for (sum, entry) in row.iter_mut().zip(right) {
                *sum += factor * entry;
            }
        }
    }
    sum
}

/// A v.
pub(super) fn moved(a: &SpatialMatrix, motion: &Motion) -> Motion {
    a.map(|row| row.iter().zip(motion).map(|(a, b)| a * b).sum())
}

/// sum += Aᵀ f.
pub(super) fn add_transposed(sum: &mut Motion, a: &SpatialMatrix, force: &Motion) {
    for (row, factor) in a.iter().zip(force) {
        for (sum, entry) in sum.iter_mut().zip(row) {
            *sum += entry * factor;
        }
    }
}
