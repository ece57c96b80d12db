//! Least squares with a few unknowns, by Householder's reflections.

use towermodes::space::eigenpairs;

/// A column counts as dependent on the previous ones if its component orthogonal to them is smaller
/// than this fraction of it.
const DEPENDENT: f64 = 1e-10;

/// The solution of a least-squares problem.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LeastSquares<const N: usize> {
    /// The unknowns.
    pub(super) solution: [f64; N],
    /// The ratio of the largest to the smallest singular value of the columns scaled to length 1.
    pub(super) condition: f64,
}

/// The x that minimizes |A x − b| for A given by its columns; none if these are linearly dependent.
///
/// Golub & Van Loan 2013, ch. 5.3.2. The singular values are those of R: the roots of the
/// eigenvalues of RᵀR.
pub(super) fn least_squares<const N: usize>(
    mut columns: [Vec<f64>; N],
    mut b: Vec<f64>,
) -> Option<LeastSquares<N>> {
    let lengths: [f64; N] = std::array::from_fn(|j| norm(&columns[j]));
    if b.len() < N || !lengths.iter().all(|length| length.is_normal()) {
        return None;
    }
    for (column, length) in columns.iter_mut().zip(lengths) {
        column.iter_mut().for_each(|entry| *entry /= length);
    }
    let mut r = [[0.0; N]; N];
    for k in 0..N {
        let (own, others) = columns[k..].split_first_mut()?;
        let mirror = Mirror::of(&own[k..])?;
        for (j, other) in others.iter_mut().enumerate() {
            mirror.reflect(&mut other[k..]);
            r[k][k + 1 + j] = other[k];
        }
        mirror.reflect(&mut b[k..]);
        r[k][k] = mirror.diagonal;
    }
    let mut solution = back_substitution(&r, &b);
    for (x, length) in solution.iter_mut().zip(lengths) {
        *x /= length;
    }
    let condition = condition(&r);
    Some(LeastSquares {
        solution,
        condition,
    })
}

/// The x with R x = b for an upper triangular R.
fn back_substitution<const N: usize>(r: &[[f64; N]; N], b: &[f64]) -> [f64; N] {
    let mut x = [0.0; N];
    for i in (0..N).rev() {
        let known: f64 = (i + 1..N).map(|j| r[i][j] * x[j]).sum();
        x[i] = (b[i] - known) / r[i][i];
    }
    x
}

/// The reflection that makes all entries of a column zero except the first.
struct Mirror {
    normal: Vec<f64>,
    /// The first entry after the reflection.
    diagonal: f64,
}

impl Mirror {
    /// The reflection of a column; none if the rest of a column of length 1 is nearly zero.
    fn of(column: &[f64]) -> Option<Self> {
        let length = norm(column);
        if length.is_nan() || length <= DEPENDENT {
            return None;
        }
        let mut normal = column.to_vec();
        // Away from the entry, so that nothing cancels.
        let diagonal = -length.copysign(normal[0]);
        normal[0] -= diagonal;
        let size = norm(&normal);
        normal.iter_mut().for_each(|entry| *entry /= size);
        Some(Self { normal, diagonal })
    }

    fn reflect(&self, column: &mut [f64]) {
        let along: f64 = self.normal.iter().zip(&*column).map(|(n, c)| n * c).sum();
        for (entry, n) in column.iter_mut().zip(&self.normal) {
            *entry -= 2.0 * along * n;
        }
    }
}

fn norm(column: &[f64]) -> f64 {
    let largest = column.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
    if !largest.is_normal() {
        return largest;
    }
    let squares = column.iter().map(|c| (c / largest).powi(2));
    largest * squares.sum::<f64>().sqrt()
}

fn condition<const N: usize>(r: &[[f64; N]; N]) -> f64 {
    let product = |i: usize, j: usize| (0..N).map(|k| r[k][i] * r[k][j]).sum::<f64>();
    let normal: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| product(i, j)));
    let (squares, _) = eigenpairs(normal);
    (squares[N - 1] / squares[0]).sqrt()
}

#[cfg(test)]
mod tests {
    use super::least_squares;

    #[test]
    fn a_line_through_three_points_is_that_of_the_normal_equations() {
        // y = a + b x through (0, 1), (1, 2), (2, 4): a = 5/6, b = 3/2. Of the columns, of lengths
        // √3 and √5, the product is 3/√15, so the condition is √((1 + 3/√15)/(1 − 3/√15)).
        let columns = [vec![1.0, 1.0, 1.0], vec![0.0, 1.0, 2.0]];
        let found = least_squares(columns, vec![1.0, 2.0, 4.0]).expect("a line");
        assert!((found.solution[0] - 5.0 / 6.0).abs() < 1e-15);
        assert!((found.solution[1] - 1.5).abs() < 1e-15);
        let product = 3.0 / 15.0_f64.sqrt();
        let condition = ((1.0 + product) / (1.0 - product)).sqrt();
        assert!((found.condition - condition).abs() < 1e-14);
    }

    #[test]
    fn columns_that_say_the_same_have_no_solution() {
        let twice = [vec![1.0, 2.0, 3.0], vec![2.0, 4.0, 6.0]];
        assert!(least_squares(twice, vec![1.0; 3]).is_none());
        assert!(least_squares([vec![0.0; 3]], vec![1.0; 3]).is_none());
        assert!(least_squares([vec![f64::NAN; 3]], vec![1.0; 3]).is_none());
        assert!(least_squares([vec![], vec![]], vec![]).is_none());
    }
}
