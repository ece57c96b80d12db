//! Singular values of a matrix with few columns.

/// A matrix A = U diag(s) Vᵀ with orthogonal V.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Singular {
    /// The columns s_k u_k of U diag(s).
    pub(super) scaled_left: Vec<Vec<f64>>,
    /// The singular values, largest first.
    pub(super) values: Vec<f64>,
    /// The columns of V in the same order.
    pub(super) right: Vec<Vec<f64>>,
}

/// Rotations stop when the scalar product of any two columns, relative to their lengths, is at most
/// this.
const ORTHOGONAL: f64 = 1e-15;
/// More sweeps are never needed: convergence is quadratic.
const MOST_SWEEPS: usize = 60;

impl Singular {
    /// The decomposition of a matrix given by its columns, by one-sided Jacobi rotations, which
    /// give also small singular values accurately (Hestenes 1958; Demmel & Veselić 1992).
    pub(super) fn of(mut columns: Vec<Vec<f64>>) -> Self {
        let n = columns.len();
        let mut right: Vec<Vec<f64>> = (0..n)
            .map(|j| (0..n).map(|i| f64::from(u8::from(i == j))).collect())
            .collect();
        for _ in 0..MOST_SWEEPS {
            let mut has_rotated = false;
            for i in 0..n {
                for j in i + 1..n {
                    let Some(turn) = rotation(&columns[i], &columns[j]) else {
                        continue;
                    };
                    has_rotated = true;
                    rotate(&mut columns, (i, j), turn);
                    rotate(&mut right, (i, j), turn);
                }
            }
            if !has_rotated {
                break;
            }
        }
        let lengths: Vec<f64> = columns.iter().map(|column| norm(column)).collect();
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|&a, &b| lengths[b].total_cmp(&lengths[a]));
        Self {
            values: order.iter().map(|&k| lengths[k]).collect(),
            scaled_left: order.iter().map(|&k| columns[k].clone()).collect(),
            right: order.iter().map(|&k| right[k].clone()).collect(),
        }
    }

    /// The x that minimizes |A x − b|² + damping |x|². Components along directions with singular
    /// value zero remain zero.
    pub(super) fn damped_solution(&self, b: &[f64], damping: f64) -> Vec<f64> {
        let mut x = vec![0.0; self.values.len()];
        let all = self.scaled_left.iter().zip(&self.values).zip(&self.right);
        for ((left, value), right) in all {
            let denominator = value * value + damping;
            if denominator == 0.0 {
                continue;
            }
            let along = product(left, b) / denominator;
            for (x, v) in x.iter_mut().zip(right) {
                *x += along * v;
            }
        }
        x
    }

    /// (AᵀA)⁻¹, for a matrix without a singular value zero.
    pub(super) fn covariance(&self) -> Vec<Vec<f64>> {
        let n = self.values.len();
        let entry = |i: usize, j: usize| {
            let all = self.values.iter().zip(&self.right);
            all.map(|(s, v)| (v[i] / s) * (v[j] / s)).sum()
        };
        (0..n)
            .map(|i| (0..n).map(|j| entry(i, j)).collect())
            .collect()
    }

    /// The pseudo-inverse of A, row by row: the contribution of each entry of b to x.
    pub(super) fn gains(&self) -> Vec<Vec<f64>> {
        let rows = self.scaled_left.first().map_or(0, Vec::len);
        let entry = |i: usize, row: usize| {
            let all = self.scaled_left.iter().zip(&self.values).zip(&self.right);
            all.map(|((left, s), v)| v[i] / s * (left[row] / s)).sum()
        };
        (0..self.values.len())
            .map(|i| (0..rows).map(|row| entry(i, row)).collect())
            .collect()
    }
}

/// Cosine and sine of the rotation that makes two columns orthogonal; none if they are.
fn rotation(a: &[f64], b: &[f64]) -> Option<(f64, f64)> {
    let (aa, bb, ab) = (product(a, a), product(b, b), product(a, b));
    if ab == 0.0 || ab.abs() <= ORTHOGONAL * (aa * bb).sqrt() {
        return None;
    }
    let zeta = (bb - aa) / (2.0 * ab);
    let tangent = zeta.signum() / (zeta.abs() + zeta.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    Some((cosine, cosine * tangent))
}

fn rotate(columns: &mut [Vec<f64>], (i, j): (usize, usize), (c, s): (f64, f64)) {
    let (head, tail) = columns.split_at_mut(j);
    for (a, b) in head[i].iter_mut().zip(&mut tail[0]) {
        (*a, *b) = (c * *a - s * *b, s * *a + c * *b);
    }
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The length of a vector.
pub(super) fn norm(a: &[f64]) -> f64 {
    product(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::Singular;

    #[test]
    fn singular_values_of_a_small_matrix_are_those_of_paper() {
        // A = [[3, 0], [4, 5]]: AᵀA has the eigenvalues 45 and 5.
        let found = Singular::of(vec![vec![3.0, 4.0], vec![0.0, 5.0]]);
        assert!((found.values[0] - 45_f64.sqrt()).abs() < 1e-14);
        assert!((found.values[1] - 5_f64.sqrt()).abs() < 1e-14);
        let x = found.damped_solution(&[3.0, 14.0], 0.0);
        assert!((x[0] - 1.0).abs() < 1e-14 && (x[1] - 2.0).abs() < 1e-14);
        // (AᵀA)⁻¹ = [[25, -20], [-20, 25]]/225.
        let covariance = found.covariance();
        assert!((covariance[0][0] - 1.0 / 9.0).abs() < 1e-15);
        assert!((covariance[0][1] + 20.0 / 225.0).abs() < 1e-15);
    }

    #[test]
    fn fewer_rows_than_columns_have_zeros() {
        let found = Singular::of(vec![vec![1.0], vec![1.0]]);
        assert!((found.values[0] - 2_f64.sqrt()).abs() < 1e-15);
        assert!(found.values[1].abs() < 1e-15);
        let v = &found.right[1];
        assert!((v[0] + v[1]).abs() < 1e-15);
    }

    #[test]
    fn small_singular_values_keep_their_digits() {
        // Columns of lengths 1 and 1e-12 at right angles but for 1e-13.
        let found = Singular::of(vec![vec![1.0, 0.0], vec![1e-13, 1e-12]]);
        assert!((found.values[1] / 1e-12 - 1.0).abs() < 1e-12);
    }
}
