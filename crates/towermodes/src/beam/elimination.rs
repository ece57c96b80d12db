//! The factorization of a matrix A of a beam in O(n), with its eigenvalue count.
//!
//! As for a chain of rigid bodies: seen from the base of an element, all that is above it is one
//! Hermitian D×D matrix P. From the top down,
//!
//! A ← A_e + [X T]ᵀ P [X T],
//!
//! the element's coordinates are eliminated from A one by one, the stiffest first, and what is left
//! is the P of its base; last come the coordinates of a base that moves. The pivots are the D of a
//! factorization L D Lᴴ, so the negative ones are the negative eigenvalues (Sylvester).
//!
//! Entries are real, or complex where something turns: under a rotor P begins with a complex
//! matrix at the top. X, T and the matrices of the elements are real.

use super::model::Beam;
use super::product::factors;
use crate::scalar::{Complex, Scalar};
use crate::space::{Matrix, SquareMatrix, transform_force, transform_matrix};
use crate::subsystem::Coefficients;

/// Pivots closer to zero than this are moved there, to the negative side: an eigenvalue hit exactly
/// counts as below.
const TINY_PIVOT: f64 = 1e-30;

/// A factored a, and working memory; reused from solve to solve.
#[derive(Debug, Clone, Default)]
pub struct Factors<S = f64> {
    /// The matrix of each element after the elimination of its coordinates: each row contains the
    /// coupling with the rows before it.
    pub(super) elements: Vec<S>,
    /// The factors of the base, in the same form.
    pub(super) base: Vec<S>,
    /// Factors of the base if nothing is to be stored: a count must not change the stored factors.
    scratch: Vec<S>,
    matrix: Vec<S>,
    /// Forces at the top of an element, a row per coordinate.
    forces: Vec<S>,
    pub(super) right: Vec<S>,
}

/// The number of negative eigenvalues of a matrix A of the beam; nothing is stored.
pub fn count_negative<const D: usize>(
    beam: &Beam<D>,
    a: &Coefficients,
    work: &mut Factors,
) -> usize {
    count_negative_between(beam, a, ([[0.0; D]; D], None), work)
}

/// Matrices added at the ends of a beam: one for the motion of the top, and possibly one for the
/// motion of a moving base.
pub(super) type Ends<'a, S, const D: usize> = (SquareMatrix<S, D>, Option<&'a Matrix<D>>);

/// As [`count_negative`], with matrices added at both ends.
pub(super) fn count_negative_between<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    a: &Coefficients,
    ends: Ends<'_, S, D>,
    work: &mut Factors<S>,
) -> usize {
    let mut base = std::mem::take(&mut work.scratch);
    let negative = eliminate_all(beam, a, ends, work, &mut base, |_, _| {});
    work.scratch = base;
    negative
}

/// Factors a matrix A of the beam and returns the number of its negative eigenvalues.
pub fn factorize<const D: usize>(beam: &Beam<D>, a: &Coefficients, work: &mut Factors) -> usize {
    factorize_between(beam, a, ([[0.0; D]; D], None), work)
}

/// As [`factorize`], with matrices added at both ends.
pub(super) fn factorize_between<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    a: &Coefficients,
    ends: Ends<'_, S, D>,
    work: &mut Factors<S>,
) -> usize {
    let size = beam.rows() * beam.rows();
    let mut elements = std::mem::take(&mut work.elements);
    elements.resize(size * beam.elements(), S::default());
    let mut base = std::mem::take(&mut work.base);
    let negative = eliminate_all(beam, a, ends, work, &mut base, |element, matrix| {
        elements[element * size..(element + 1) * size].copy_from_slice(matrix);
    });
    (work.elements, work.base) = (elements, base);
    negative
}

/// Eliminates everything from the top down, passes the matrix of each element to `record`, and
/// leaves the matrix of the base in `base`.
fn eliminate_all<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    a: &Coefficients,
    (above, below): Ends<'_, S, D>,
    work: &mut Factors<S>,
    base: &mut Vec<S>,
    record: impl FnMut(usize, &[S]),
) -> usize {
    let factors = factors(a);
    let own = |element, matrix: &mut [S]| combine(beam, &factors, element, matrix);
    let (above, negative) = eliminate_elements(beam, a.stiffness, above, work, own, record);
    negative + eliminate_base(beam, &factors, (above, below), base)
}

/// Eliminates the coordinates of the elements from the top down, where everything above them is the
/// matrix `above` and `own` writes an element's matrix without its stiffness; passes each matrix to
/// `record`. Returns P of the lowest base and the number of negative pivots.
fn eliminate_elements<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    stiffness: f64,
    mut above: SquareMatrix<S, D>,
    work: &mut Factors<S>,
    own: impl Fn(usize, &mut [S]),
    mut record: impl FnMut(usize, &[S]),
) -> (SquareMatrix<S, D>, usize) {
    let rows = beam.rows();
    work.matrix.resize(rows * rows, S::default());
    let Factors { matrix, forces, .. } = work;
    let mut negative = 0;
    for element in (0..beam.elements()).rev() {
        own(element, matrix);
        add_above(beam, element, &above, forces, matrix);
        (D..rows).for_each(|i| matrix[i * rows + i] += S::real(stiffness));
        negative += eliminate(matrix, rows, D);
        above = first_block(matrix, rows);
        record(element, matrix);
    }
    (above, negative)
}

/// Adds [X T]ᵀ P [X T] to the lower triangle of an element's matrix, for P above it; `forces` is
/// working memory.
#[inline]
fn add_above<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    element: usize,
    above: &SquareMatrix<S, D>,
    forces: &mut Vec<S>,
    matrix: &mut [S],
) {
    let (rows, m, length_m) = (beam.rows(), beam.coordinates(), beam.length_m(element));
    let mut moved = *above;
    transform_matrix(&mut moved, length_m);
    for (i, row) in moved.iter().enumerate() {
        for (sum, entry) in matrix[i * rows..=i * rows + i].iter_mut().zip(row) {
            *sum += *entry;
        }
    }
    // The forces P T at the top, coordinate by coordinate.
    forces.clear();
    forces.resize(D * m, S::default());
    let (forces, _) = forces.as_chunks_mut::<D>();
    for (row, tip) in above.iter().zip(beam.tip_rows(element)) {
        for (force, tip) in forces.iter_mut().zip(tip) {
            for (component, entry) in force.iter_mut().zip(row) {
                *component += entry.conj().times(*tip);
            }
        }
    }
    for (i, force) in forces.iter().enumerate() {
        let row = &mut matrix[(D + i) * rows..];
        let mut at_base = *force;
        transform_force(&mut at_base, length_m);
        for (sum, component) in row.iter_mut().zip(at_base) {
            *sum += component.conj();
        }
        for (component, tip) in force.iter().zip(beam.tip_rows(element)) {
            for (sum, tip) in row[D..=D + i].iter_mut().zip(tip) {
                *sum += component.conj().times(*tip);
            }
        }
    }
}

/// The first D rows and columns of a Hermitian matrix whose lower triangle is given.
pub(crate) fn first_block<const D: usize, S: Scalar>(
    matrix: &[S],
    rows: usize,
) -> SquareMatrix<S, D> {
    let mut block = [[S::default(); D]; D];
    for i in 0..D {
        for j in 0..=i {
            block[i][j] = matrix[i * rows + j];
            block[j][i] = block[i][j].conj();
        }
    }
    block
}

/// A matrix as seen from one point, with what was eliminated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condensed {
    /// The matrix for the motion (translation, rotation) of the point.
    pub matrix: SquareMatrix<Complex, 6>,
    /// Number of negative pivots.
    pub negative: usize,
}

/// The matrix A = 1 + a M + b S + i c C of a blade, with the inertia M, the stiffness S by the spin
/// in the place of a foundation, and the skew matrices C of its elements.
pub(super) struct TurningMatrix<'a> {
    pub(super) inertia: f64,
    pub(super) spin: f64,
    pub(super) skew: f64,
    pub(super) coriolis: &'a [f64],
}

/// Eliminates the coordinates of a blade.
pub(super) fn condense_blade(
    beam: &Beam<6>,
    a: &TurningMatrix<'_>,
    work: &mut Factors<Complex>,
) -> Condensed {
    let (matrix, negative) = eliminate_blade(beam, a, work, |_, _| {});
    Condensed { matrix, negative }
}

/// As above, with the factors stored.
pub(super) fn factorize_blade(
    beam: &Beam<6>,
    a: &TurningMatrix<'_>,
    work: &mut Factors<Complex>,
) -> Condensed {
    let size = beam.rows() * beam.rows();
    let mut elements = std::mem::take(&mut work.elements);
    elements.resize(size * beam.elements(), Complex::default());
    let (matrix, negative) = eliminate_blade(beam, a, work, |element, matrix| {
        elements[element * size..(element + 1) * size].copy_from_slice(matrix);
    });
    work.elements = elements;
    Condensed { matrix, negative }
}

fn eliminate_blade(
    beam: &Beam<6>,
    a: &TurningMatrix<'_>,
    work: &mut Factors<Complex>,
    record: impl FnMut(usize, &[Complex]),
) -> (SquareMatrix<Complex, 6>, usize) {
    let own = |element, matrix: &mut [Complex]| {
        let size = matrix.len();
        let all = [&beam.matrices[0], &beam.matrices[1], a.coriolis];
        let [inertia, spin, coriolis] = all.map(|all| &all[element * size..][..size]);
        let parts = inertia.iter().zip(spin).zip(coriolis);
        for (entry, ((inertia, spin), coriolis)) in matrix.iter_mut().zip(parts) {
            *entry = Complex::new(a.inertia * inertia + a.spin * spin, a.skew * coriolis);
        }
    };
    let above = [[Complex::default(); 6]; 6];
    eliminate_elements(beam, 1.0, above, work, own, record)
}

/// The matrix of one element, without the elements' own stiffness.
#[inline]
fn combine<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    factors: &[f64; 3],
    element: usize,
    matrix: &mut [S],
) {
    let size = matrix.len();
    matrix.fill(S::default());
    for (factor, matrices) in factors.iter().zip(&beam.matrices) {
        let own = matrices.get(element * size..(element + 1) * size);
        if let Some(own) = own.filter(|_| *factor != 0.0) {
            for (entry, own) in matrix.iter_mut().zip(own) {
                *entry += S::real(factor * own);
            }
        }
    }
}

/// Eliminates the coordinates of the base; `above` is the matrix of everything above it, `below`
/// the matrix of its support.
fn eliminate_base<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    factors: &[f64; 3],
    (above, below): Ends<'_, S, D>,
    matrix: &mut Vec<S>,
) -> usize {
    matrix.clear();
    let Some(base) = &beam.base else {
        return 0;
    };
    let mut sum = above;
    for (factor, own) in factors.iter().zip(&base.matrices) {
        for (sum, own) in sum.as_flattened_mut().iter_mut().zip(own.as_flattened()) {
            *sum += S::real(factor * own);
        }
    }
    if let Some(below) = below {
        for (sum, own) in sum.as_flattened_mut().iter_mut().zip(below.as_flattened()) {
            *sum += S::real(*own);
        }
    }
    for i in base.moving() {
        let row = base
            .moving()
            .map(|j| sum[i][j].times(base.unit[i] * base.unit[j]));
        matrix.extend(row);
    }
    eliminate(matrix, base.moving().count(), 0)
}

/// Eliminates all rows of a Hermitian matrix, whose lower triangle is given, from the last to
/// `first`; returns how many pivots are negative.
pub(crate) fn eliminate<S: Scalar>(matrix: &mut [S], rows: usize, first: usize) -> usize {
    let mut negative = 0;
    for last in (first..rows).rev() {
        let (rest, row) = matrix.split_at_mut(last * rows);
        negative += eliminate_row(rest, row, (rows, last), 0);
    }
    negative
}

/// As [`eliminate`], with only the rows from `first` on given: their contribution to the rows
/// before is not subtracted from these rows.
pub(crate) fn eliminate_rows(given: &mut [f64], rows: usize, first: usize) -> usize {
    let mut negative = 0;
    for last in (first..rows).rev() {
        let (rest, row) = given.split_at_mut((last - first) * rows);
        negative += eliminate_row(rest, row, (rows, last), first);
    }
    negative
}

/// Eliminates row number `row` from the rows before it, beginning with row `first`; returns the
/// number of negative pivots.
#[inline]
fn eliminate_row<S: Scalar>(
    rest: &mut [S],
    row: &mut [S],
    (rows, last): (usize, usize),
    first: usize,
) -> usize {
    let mut pivot = row[last].re();
    if pivot.abs() < TINY_PIVOT {
        pivot = -TINY_PIVOT;
    }
    row[last] = S::real(pivot);
    for (i, out) in (first..).zip(rest.chunks_exact_mut(rows)) {
        let factor = row[i].conj().over(pivot);
        for (out, row) in out[..=i].iter_mut().zip(&row[..=i]) {
            *out -= factor * *row;
        }
    }
    usize::from(pivot < 0.0)
}
