//! Signs and positions of the couplings in 6×6 matrices.

use crate::space::SpatialMatrix;
use crate::tower::Site;
use crate::tower::Warning;

/// Couplings below this fraction of the geometric mean of their diagonal entries are numerical
/// noise of the program that computed the matrix.
const NOISE: f64 = 0.05;

/// If the diagonal entries of both planes differ by a larger factor, the planes of the structure
/// are different, and their couplings may have any signs.
const PLANES_APART: f64 = 3.0;

/// A matrix and its name.
pub(super) struct Named<'a> {
    pub(super) what: &'static str,
    pub(super) site: Site,
    pub(super) matrix: &'a SpatialMatrix,
    /// Height of the reference point of the matrix above the tower's base, m.
    pub(super) above_base_m: f64,
    /// Largest height of its centre above the base, m; none if there is no limit.
    pub(super) highest_m: Option<f64>,
}

pub(super) fn check(named: &Named<'_>, warnings: &mut Vec<Warning>) {
    let &Named {
        what, site, matrix, ..
    } = named;
    along_axis(what, site, matrix, warnings);
    let (fore_aft, side_side) = (matrix[0][4], matrix[1][3]);
    if fore_aft * side_side > 0.0 && has_equal_planes(matrix) {
        warnings.push(Warning::CouplingSigns {
            what,
            site,
            fore_aft,
            side_side,
        });
        return;
    }
    warnings.extend(acts_above(named));
}

/// Whether the diagonal entries of both planes are so close that the couplings must be close, too.
fn has_equal_planes(matrix: &SpatialMatrix) -> bool {
    [(0, 1), (3, 4)].into_iter().all(|(i, j)| {
        let (one, other) = (matrix[i][i].abs(), matrix[j][j].abs());
        one.max(other) <= PLANES_APART * one.min(other)
    })
}

/// Warns about a coupling of a translation with the rotation about the same axis: a structure with
/// a vertical plane of symmetry does not have it.
fn along_axis(what: &'static str, site: Site, matrix: &SpatialMatrix, warnings: &mut Vec<Warning>) {
    let couples = |i: &usize| {
        let diagonal = matrix[*i][*i].abs().sqrt() * matrix[i + 3][i + 3].abs().sqrt();
        diagonal > 0.0 && matrix[*i][i + 3].abs() > NOISE * diagonal
    };
    if let Some(i) = (0..3).find(couples) {
        warnings.push(Warning::CouplingAlongAxis {
            what,
            site,
            row: i + 1,
            column: i + 4,
            value: matrix[i][i + 3],
        });
    }
}

/// A spring or a mass k at a height h above the point has k h in row 1, column 5 and −k h in row 2,
/// column 4.
fn acts_above(named: &Named<'_>) -> Option<Warning> {
    let highest_m = named.highest_m?;
    let m = named.matrix;
    let heights = [(m[0][4], m[0][0]), (-m[1][3], m[1][1])];
    let heights = heights.into_iter().filter(|(_, diagonal)| *diagonal > 0.0);
    let above = heights.map(|(coupling, diagonal)| named.above_base_m + coupling / diagonal);
    let above_m = above.max_by(f64::total_cmp)?;
    (above_m > highest_m).then_some(Warning::ActsAbove {
        what: named.what,
        site: named.site,
        above_m,
    })
}
