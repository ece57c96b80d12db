//! Eigenvalues and eigenvectors of small symmetric matrices.

/// Sweeps after which Jacobi's method has long converged.
const MAX_SWEEPS: usize = 60;

/// The eigenvalues of a symmetric matrix in rising order, and the eigenvector of each as a row.
///
/// Jacobi's cyclic rotations (Golub & Van Loan 2013, ch. 8.5), which find small eigenvalues of
/// scaled matrices to full accuracy.
///
/// # Example
/// ```
/// use towermodes::space::eigenpairs;
///
/// let (values, vectors) = eigenpairs([[2.0, 1.0], [1.0, 2.0]]);
/// assert!((values[0] - 1.0).abs() < 1e-15 && (values[1] - 3.0).abs() < 1e-15);
/// assert!((vectors[1][0] - vectors[1][1]).abs() < 1e-15);
/// ```
pub fn eigenpairs<const N: usize>(mut a: [[f64; N]; N]) -> ([f64; N], [[f64; N]; N]) {
    let mut vectors: [[f64; N]; N] =
        std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    for _ in 0..MAX_SWEEPS {
        let mut rotated = false;
        for p in 0..N {
            for q in p + 1..N {
                rotated |= rotate(&mut a, &mut vectors, p, q);
            }
        }
        if !rotated {
            break;
        }
    }
    let mut order: [usize; N] = std::array::from_fn(|i| i);
    order.sort_by(|&i, &j| a[i][i].total_cmp(&a[j][j]));
    (order.map(|i| a[i][i]), order.map(|i| vectors[i]))
}

/// Makes a[p][q] zero by a rotation, unless it is already, beside the diagonal.
fn rotate<const N: usize>(
    a: &mut [[f64; N]; N],
    vectors: &mut [[f64; N]; N],
    p: usize,
    q: usize,
) -> bool {
    let off = a[p][q];
    let scale = (a[p][p].abs() * a[q][q].abs()).sqrt();
    if !(off.abs() > 0.25 * f64::EPSILON * scale && off.abs() > f64::MIN_POSITIVE) {
        return false;
    }
    let tau = (a[q][q] - a[p][p]) / (2.0 * off);
    let t = 1.0_f64.copysign(tau) / (tau.abs() + tau.hypot(1.0));
    let c = 1.0 / t.hypot(1.0);
    let s = t * c;
    for row in a.iter_mut() {
        (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
    }
    for k in 0..N {
        let (x, y) = (a[p][k], a[q][k]);
        (a[p][k], a[q][k]) = (c * x - s * y, s * x + c * y);
        let (x, y) = (vectors[p][k], vectors[q][k]);
        (vectors[p][k], vectors[q][k]) = (c * x - s * y, s * x + c * y);
    }
    (a[p][q], a[q][p]) = (0.0, 0.0);
    true
}

#[cfg(test)]
mod tests {
    use super::eigenpairs;

    #[test]
    fn a_rotated_diagonal_gives_its_entries() {
        // Rotation by 0.6, 0.8 in the plane of the first two axes of diag(1, 4, −2).
        let (c, s) = (0.6, 0.8);
        let a = [
            [c * c + 4.0 * s * s, -3.0 * c * s, 0.0],
            [-3.0 * c * s, s * s + 4.0 * c * c, 0.0],
            [0.0, 0.0, -2.0],
        ];
        let (values, vectors) = eigenpairs(a);
        for (value, exact) in values.iter().zip([-2.0, 1.0, 4.0]) {
            assert!((value - exact).abs() < 1e-14);
        }
        assert!((vectors[0][2].abs() - 1.0).abs() < 1e-14);
        assert!((vectors[1][0].abs() - c).abs() < 1e-14 && (vectors[1][1].abs() - s).abs() < 1e-14);
    }
}
