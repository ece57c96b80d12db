//! The factor of Cholesky of a correlation matrix.

/// Tolerance of a coefficient relative to the limits set by the others; rounding errors are
/// smaller.
const TOLERANCE: f64 = 1e-9;
/// If the square of a pivot is smaller, it is a rounding error: the value is a linear combination
/// of those before it.
const LEAST_SQUARE: f64 = 1e-13;

/// A coefficient that is impossible with the coefficients before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Excluded {
    /// Column and row, the smaller first.
    pub(super) pair: [usize; 2],
    /// The lowest and the highest coefficient that would be possible.
    pub(super) limits: [f64; 2],
}

/// The rows of L with R = L Lᵀ; row i has the columns 0 to i. `lower` contains the coefficients of
/// R: row i has the columns 0 to i − 1. The matrix may be singular.
pub(super) fn cholesky(lower: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, Excluded> {
    let mut factor: Vec<Vec<f64>> = Vec::with_capacity(lower.len());
    for (second, coefficients) in lower.iter().enumerate() {
        let mut row: Vec<f64> = Vec::with_capacity(second + 1);
        let mut rest: f64 = 1.0;
        for (first, coefficient) in coefficients.iter().enumerate() {
            let before = &factor[first];
            let middle: f64 = row.iter().zip(before).map(|(a, b)| a * b).sum();
            let pivot = before[first];
            let half = pivot * rest.sqrt();
            let difference = coefficient - middle;
            if difference.abs() > half + TOLERANCE {
                let limits = [middle - half, middle + half].map(|r| r.clamp(-1.0, 1.0));
                let pair = [first, second];
                return Err(Excluded { pair, limits });
            }
            let bounded = difference.clamp(-half, half);
            row.push(if pivot > 0.0 { bounded / pivot } else { 0.0 });
            rest -= row[first] * row[first];
            if rest < LEAST_SQUARE {
                rest = 0.0;
            }
        }
        row.push(rest.sqrt());
        factor.push(row);
    }
    Ok(factor)
}

#[cfg(test)]
mod tests {
    use super::cholesky;

    /// By hand: 0.6, √(1 − 0.36), (0.3 − 0.6·0.5)/0.8.
    #[test]
    fn the_factor_is_that_of_the_matrix() {
        let factor = cholesky(&[vec![], vec![0.6], vec![0.5, 0.3]]).expect("a correlation matrix");
        let expected = [vec![1.0], vec![0.6, 0.8], vec![0.5, 0.0, 0.75_f64.sqrt()]];
        for (found, expected) in factor.iter().flatten().zip(expected.iter().flatten()) {
            assert!((found - expected).abs() < 1e-15, "{factor:?}");
        }
    }

    #[test]
    fn a_singular_matrix_has_a_factor_if_it_is_consistent() {
        let factor = cholesky(&[vec![], vec![1.0], vec![-0.5, -0.5]]).expect("a matrix");
        assert_eq!(factor[1], [1.0, 0.0]);
        let excluded = cholesky(&[vec![], vec![1.0], vec![-0.5, -0.4]]).expect_err("none");
        assert_eq!((excluded.pair, excluded.limits), ([1, 2], [-0.5, -0.5]));
    }

    /// Just inside the limits at which a coefficient is refused, the factor exists.
    #[test]
    fn the_limits_are_those_of_positive_definite_matrices() {
        let of = |last| cholesky(&[vec![], vec![0.9], vec![0.2, 0.3], vec![0.1, 0.2, last]]);
        let excluded = of(-0.99).expect_err("none");
        let [low, high] = excluded.limits;
        assert_eq!(excluded.pair, [2, 3]);
        assert!(of(low + 1e-8).is_ok() && of(high - 1e-8).is_ok());
        assert!(of(low - 1e-8).is_err() && of(high + 1e-8).is_err());
    }
}
