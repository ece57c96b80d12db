//! Eigenvalues of the small symmetric tridiagonal matrix of the Lanczos process.

/// Limit of the QL iterations for one eigenvalue; fewer are always enough.
const MAX_ITERATIONS: usize = 60;

/// Diagonalizes the symmetric tridiagonal matrix with diagonal `d` and off-diagonal `e` (e[i]
/// couples i and i+1) in place by the implicit QL iteration (Bowdler, Martin, Reinsch & Wilkinson
/// 1968).
///
/// `d` becomes the eigenvalues in no order; `z`, stored by columns of `rows` entries, is multiplied
/// by the eigenvectors from the right: start it with the identity for all of them, with one row of
/// the identity for one component of each. Returns false if the iteration does not converge, which
/// only non-finite input can cause.
pub(super) fn diagonalize(d: &mut [f64], e: &mut [f64], z: &mut [f64], rows: usize) -> bool {
    let size = d.len();
    let scale = d
        .iter()
        .chain(e.iter())
        .fold(0.0_f64, |a, x| a.max(x.abs()));
    if !(scale > 0.0 && scale.is_finite()) {
        return scale == 0.0;
    }
    // At unit scale squares neither overflow nor underflow harmfully.
    d.iter_mut().chain(e.iter_mut()).for_each(|x| *x /= scale);
    let converged = (0..size).all(|first| isolate(d, e, z, rows, first));
    d.iter_mut().for_each(|x| *x *= scale);
    converged
}

/// Iterates until entry `first` is decoupled from what follows.
fn isolate(d: &mut [f64], e: &mut [f64], z: &mut [f64], rows: usize, first: usize) -> bool {
    for _ in 0..MAX_ITERATIONS {
        let last = decoupled_at(d, e, first);
        if last == first {
            return true;
        }
        ql_step(d, e, z, rows, first, last);
    }
    false
}

/// The end of the unreduced block that begins at `first`.
fn decoupled_at(d: &[f64], e: &[f64], first: usize) -> usize {
    (first..d.len() - 1)
        .find(|&i| e[i].abs() <= f64::EPSILON * (d[i].abs() + d[i + 1].abs()))
        .unwrap_or(d.len() - 1)
}

/// One implicit QL step with Wilkinson's shift on the block first..=last.
fn ql_step(d: &mut [f64], e: &mut [f64], z: &mut [f64], rows: usize, first: usize, last: usize) {
    let half_difference = (d[first + 1] - d[first]) / (2.0 * e[first]);
    let root = half_difference.hypot(1.0).copysign(half_difference);
    let mut g = d[last] - d[first] + e[first] / (half_difference + root);
    let (mut s, mut c, mut p) = (1.0, 1.0, 0.0);
    for i in (first..last).rev() {
        let (f, b) = (s * e[i], c * e[i]);
        let r = (f * f + g * g).sqrt();
        if i + 1 < last {
            e[i + 1] = r;
        }
        if r == 0.0 {
            // The rotation angle would be zero: the block has split here.
            d[i + 1] -= p;
            return;
        }
        (s, c) = (f / r, g / r);
        g = d[i + 1] - p;
        let t = (d[i] - g) * s + 2.0 * c * b;
        p = s * t;
        d[i + 1] = g + p;
        g = c * t - b;
        rotate(z, rows, i, s, c);
    }
    d[first] -= p;
    e[first] = g;
}

/// Turns columns i and i+1 of z by the rotation (c, s).
#[inline]
fn rotate(z: &mut [f64], rows: usize, i: usize, s: f64, c: f64) {
    let (left, right) = z[i * rows..(i + 2) * rows].split_at_mut(rows);
    for (left, right) in left.iter_mut().zip(right) {
        let (a, b) = (*left, *right);
        *right = s * a + c * b;
        *left = c * a - s * b;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn second_difference_matrix_has_its_closed_form_spectrum() {
        // tridiag(−1, 2, −1) of size n: 2 − 2 cos(kπ/(n+1)), last components ∝ sin(nkπ/(n+1)).
        let n = 30;
        let (mut d, mut e) = (vec![2.0; n], vec![-1.0; n - 1]);
        let mut last_row = vec![0.0; n];
        last_row[n - 1] = 1.0;
        assert!(diagonalize(&mut d, &mut e, &mut last_row, 1));
        let mut pairs: Vec<_> = d.iter().zip(&last_row).collect();
        pairs.sort_by(|a, b| a.0.total_cmp(b.0));
        for (k, (value, component)) in pairs.into_iter().enumerate() {
            let angle = (k + 1) as f64 * std::f64::consts::PI / (n + 1) as f64;
            assert!((value - (2.0 - 2.0 * angle.cos())).abs() < 1e-14);
            let exact = (2.0 / (n + 1) as f64).sqrt() * (n as f64 * angle).sin();
            assert!((component.abs() - exact.abs()).abs() < 1e-14);
        }
    }

    #[test]
    fn eigenvectors_rebuild_the_matrix() {
        let (d, e) = ([4.0, 1.0, 1e-3, 1e-7], [0.5, 1e-2, 1e-5]);
        let (mut values, mut work) = (d, e);
        let mut z = vec![0.0; 16];
        (0..4).for_each(|i| z[5 * i] = 1.0);
        assert!(diagonalize(&mut values, &mut work, &mut z, 4));
        for row in 0..4 {
            for col in 0..4 {
                let entry: f64 = (0..4)
                    .map(|k| values[k] * z[4 * k + row] * z[4 * k + col])
                    .sum();
                let exact = match row.abs_diff(col) {
                    0 => d[row],
                    1 => e[row.min(col)],
                    _ => 0.0,
                };
                assert!((entry - exact).abs() < 1e-14);
            }
        }
    }
}
