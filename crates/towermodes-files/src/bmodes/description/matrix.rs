//! The matrices of the offshore block: made symmetric, and referred to the tower's base.

use towermodes::space::{SpatialMatrix, transform_matrix};

use super::super::records::deck::MatrixValue;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Entries that should be equal may differ by this fraction of the larger one, because matrices are
/// results of panel and mooring programs, …
const SLIGHTLY: f64 = 0.05;
/// … or by this fraction of their diagonal entries.
const NOISE: f64 = 1e-3;

/// The pair of entries of a matrix that should be equal and differ most, with the difference as a
/// fraction of the larger one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Asymmetry {
    /// Row of the entry, from 1.
    pub(crate) row: usize,
    /// Column of the entry, from 1; greater than `row`.
    pub(crate) column: usize,
    pub(crate) upper: f64,
    pub(crate) lower: f64,
}

impl Asymmetry {
    fn fraction(&self) -> f64 {
        let larger = self.upper.abs().max(self.lower.abs());
        if larger == 0.0 {
            0.0
        } else {
            (self.upper / larger - self.lower / larger).abs()
        }
    }
}

/// The pair of entries with the largest asymmetry, if the matrix is not symmetric.
pub(super) fn asymmetry<const N: usize>(matrix: &[[f64; N]; N]) -> Option<Asymmetry> {
    let pairs = (0..N).flat_map(|row| (row + 1..N).map(move |column| (row, column)));
    let differences = pairs.map(|(row, column)| Asymmetry {
        row: row + 1,
        column: column + 1,
        upper: matrix[row][column],
        lower: matrix[column][row],
    });
    let unequal = differences.filter(|pair| pair.upper != pair.lower);
    unequal.max_by(|a, b| a.fraction().total_cmp(&b.fraction()))
}

/// The mean of a matrix and its transpose; an error if they differ by more than rounding and noise.
pub(super) fn symmetrized<const N: usize>(
    matrix: &MatrixValue<N>,
    name: &str,
) -> Result<[[f64; N]; N], Diagnostic> {
    let rows = &matrix.rows;
    for row in 0..N {
        for column in row + 1..N {
            let (upper, lower) = (rows[row][column], rows[column][row]);
            let diagonal = rows[row][row].abs().sqrt() * rows[column][column].abs().sqrt();
            let allowed = (SLIGHTLY * upper.abs().max(lower.abs())).max(NOISE * diagonal);
            if (upper - lower).abs() > allowed {
                let (i, j) = (row + 1, column + 1);
                let kind = DiagnosticKind::Contradiction(format!(
                    "{name} is not symmetric: row {i}, column {j} is {upper} and row {j}, column {i} is {lower}"
                ));
                let hint = "both entries are the same quantity; the order is x, y, z, rotation about x, y, z";
                return Err(Diagnostic::new(matrix.spans[column].clone(), kind).with_hint(hint));
            }
        }
    }
    Ok(std::array::from_fn(|i| {
        std::array::from_fn(|j| 0.5 * rows[i][j] + 0.5 * rows[j][i])
    }))
}

/// A stiffness or an inertia matrix about a point on the axis at `height_m`, transformed to the
/// base at `base_m`.
pub(super) fn about_base(mut matrix: SpatialMatrix, height_m: f64, base_m: f64) -> SpatialMatrix {
    transform_matrix(&mut matrix, height_m - base_m);
    matrix
}

/// A matrix without the rows and columns of vertical motion and of torsion.
pub(super) fn without_axial_and_torsion(matrix: &SpatialMatrix) -> SpatialMatrix {
    let is_kept = |i: usize| i != 2 && i != 5;
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if is_kept(i) && is_kept(j) {
                matrix[i][j]
            } else {
                0.0
            }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(rows: [[f64; 2]; 2]) -> MatrixValue<2> {
        let spans = [0..3, 4..7];
        MatrixValue { rows, spans }
    }

    #[test]
    fn slight_asymmetry_is_averaged_and_a_wrong_sign_refused() {
        let slight = value([[41180.0, -2821000.0], [-2816000.0, 6.9e9]]);
        let mean = symmetrized(&slight, "mooring_K").expect("slight");
        assert_eq!(mean[0][1], -2818500.0);
        assert_eq!(mean[1][0], -2818500.0);
        let pair = asymmetry(&slight.rows).expect("not symmetric");
        assert_eq!((pair.row, pair.column, pair.upper), (1, 2, -2821000.0));
        let wrong = value([[1.0, -20.0], [20.0, 900.0]]);
        let mistake = symmetrized(&wrong, "mooring_K").expect_err("a wrong sign");
        assert_eq!(mistake.span, 4..7);
        assert_eq!(asymmetry(&[[1.0, 2.0], [2.0, 1.0]]), None);
    }

    #[test]
    fn a_spring_below_the_base_turns_it_by_its_lever() {
        let mut spring = SpatialMatrix::default();
        spring[0][0] = 10.0;
        spring[1][1] = 10.0;
        spring[2][2] = 5.0;
        let about = about_base(spring, -3.0, 0.0);
        // The point 3 m below moves by x − 3 ry and y + 3 rx.
        assert_eq!(about[0][4], -30.0);
        assert_eq!(about[4][4], 90.0);
        assert_eq!(about[1][3], 30.0);
        assert_eq!(about[3][1], 30.0);
        assert_eq!(about[3][3], 90.0);
        let lateral = without_axial_and_torsion(&about);
        assert_eq!((lateral[2][2], lateral[0][4]), (0.0, -30.0));
    }
}
