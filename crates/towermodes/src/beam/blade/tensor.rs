//! Vectors and tensors in space.

/// A vector.
pub(super) type Vector = [f64; 3];

/// A tensor, row by row.
pub(super) type Tensor = [[f64; 3]; 3];

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    times(&cross_matrix(a), b)
}

/// [a] with [a] b = a × b.
pub(super) fn cross_matrix([x, y, z]: Vector) -> Tensor {
    [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
}

pub(crate) fn times(a: &Tensor, b: Vector) -> Vector {
    a.map(|row| dot(row, b))
}

/// 1 − n nᵀ.
pub(super) fn across(n: Vector) -> Tensor {
    let mut matrix = identity();
    for i in 0..3 {
        for j in 0..3 {
            matrix[i][j] -= n[i] * n[j];
        }
    }
    matrix
}

pub(crate) fn identity() -> Tensor {
    std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))))
}

pub(crate) fn product(a: &Tensor, b: &Tensor) -> Tensor {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

pub(super) fn transposed(a: &Tensor) -> Tensor {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

pub(crate) fn symmetric(a: &Tensor) -> Tensor {
    std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (a[i][j] + a[j][i])))
}

pub(crate) fn minus(a: &Tensor, b: &Tensor) -> Tensor {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] - b[i][j]))
}

pub(super) fn scaled(a: &Tensor, factor: f64) -> Tensor {
    a.map(|row| row.map(|entry| factor * entry))
}

pub(super) fn trace(a: &Tensor) -> f64 {
    a[0][0] + a[1][1] + a[2][2]
}
