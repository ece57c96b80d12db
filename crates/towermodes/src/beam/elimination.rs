//! The factorization of a matrix A of a beam in O(n), with solve and inertia count.
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

use super::model::{Beam, add_congruent};
use super::product::{base_motion, factors};
use crate::scalar::{Complex, Scalar};
use crate::space::{SquareMatrix, transform_force, transform_motion};
use crate::subsystem::Coefficients;

/// Pivots closer to zero than this are moved there, to the negative side: an eigenvalue hit exactly
/// counts as below.
const TINY_PIVOT: f64 = 1e-30;

/// A factored a, and working memory; reused from solve to solve.
#[derive(Debug, Clone, Default)]
pub struct Factors<S = f64> {
    /// Each element's matrix after its coordinates were eliminated: a row holds what it was coupled
    /// with before.
    elements: Vec<S>,
    /// The same of the base.
    base: Vec<S>,
    /// The base's when nothing is to be stored: a count must leave the factors alone.
    scratch: Vec<S>,
    matrix: Vec<S>,
    top: Vec<f64>,
    right: Vec<S>,
}

/// The number of negative eigenvalues of a matrix A of the beam; nothing is stored.
pub fn count_negative<const D: usize>(
    beam: &Beam<D>,
    a: &Coefficients,
    work: &mut Factors,
) -> usize {
    let mut base = std::mem::take(&mut work.scratch);
    let above = [[0.0; D]; D];
    let negative = eliminate_all(beam, a, above, work, &mut base, |_, _| {});
    work.scratch = base;
    negative
}

/// Factors a matrix A of the beam and returns the number of its negative eigenvalues.
pub fn factorize<const D: usize>(beam: &Beam<D>, a: &Coefficients, work: &mut Factors) -> usize {
    factorize_under(beam, a, [[0.0; D]; D], work)
}

/// The same with a matrix `above` added for the motion of the top.
fn factorize_under<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    a: &Coefficients,
    above: SquareMatrix<S, D>,
    work: &mut Factors<S>,
) -> usize {
    let size = beam.rows() * beam.rows();
    let mut elements = std::mem::take(&mut work.elements);
    elements.resize(size * beam.elements(), S::default());
    let mut base = std::mem::take(&mut work.base);
    let negative = eliminate_all(beam, a, above, work, &mut base, |element, matrix| {
        elements[element * size..(element + 1) * size].copy_from_slice(matrix);
    });
    (work.elements, work.base) = (elements, base);
    negative
}

/// Eliminates everything from the top down, passes each element's matrix to `record`, and leaves
/// that of the base in `base`.
fn eliminate_all<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    a: &Coefficients,
    above: SquareMatrix<S, D>,
    work: &mut Factors<S>,
    base: &mut Vec<S>,
    record: impl FnMut(usize, &[S]),
) -> usize {
    let factors = factors(a);
    let own = |element, matrix: &mut [S]| combine(beam, &factors, element, matrix);
    let (above, negative) = eliminate_elements(beam, a.stiffness, above, work, own, record);
    negative + eliminate_base(beam, &factors, above, base)
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
    work.top.resize(D * rows, 0.0);
    let (matrix, top) = (&mut work.matrix[..], &mut work.top[..]);
    let mut negative = 0;
    for element in (0..beam.elements()).rev() {
        own(element, matrix);
        beam.top_motion(element, top);
        add_congruent(&above, top, rows, matrix);
        (D..rows).for_each(|i| matrix[i * rows + i] += S::real(stiffness));
        negative += eliminate(matrix, rows, D);
        above = std::array::from_fn(|i| std::array::from_fn(|j| matrix[i * rows + j]));
        record(element, matrix);
    }
    (above, negative)
}

/// A matrix as seen from one point, with what was eliminated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condensed {
    /// The matrix for the motion (translation, rotation) of the point.
    pub matrix: SquareMatrix<Complex, 6>,
    /// Number of negative pivots.
    pub negative: usize,
    /// Sum of ln |pivot|.
    pub log_pivots: f64,
}

/// The matrix A = 1 + Σ factors · matrices + i skew · C of a blade, with C the skew matrices of the
/// elements, as seen from its root.
pub(super) fn eliminate_blade(
    beam: &Beam<6>,
    factors: &[f64; 3],
    (skew, coriolis): (f64, &[f64]),
    work: &mut Factors<Complex>,
) -> Condensed {
    let (rows, mut log_pivots) = (beam.rows(), 0.0);
    let own = |element, matrix: &mut [Complex]| {
        combine(beam, factors, element, matrix);
        let size = matrix.len();
        let turned = &coriolis[element * size..(element + 1) * size];
        for (entry, turned) in matrix.iter_mut().zip(turned) {
            entry.im += skew * turned;
        }
    };
    let above = [[Complex::default(); 6]; 6];
    let (matrix, negative) = eliminate_elements(beam, 1.0, above, work, own, |_, matrix| {
        log_pivots += log_of_pivots(matrix, rows, 6);
    });
    Condensed {
        matrix,
        negative,
        log_pivots,
    }
}

/// The number of negative eigenvalues of A with a matrix `above` added for the motion of the top,
/// and the sum of ln |pivot|.
pub(super) fn eliminate_under(
    beam: &Beam<6>,
    a: &Coefficients,
    above: SquareMatrix<Complex, 6>,
    work: &mut Factors<Complex>,
) -> (usize, f64) {
    let (rows, mut log_pivots) = (beam.rows(), 0.0);
    let mut base = std::mem::take(&mut work.scratch);
    let negative = eliminate_all(beam, a, above, work, &mut base, |_, matrix| {
        log_pivots += log_of_pivots(matrix, rows, 6);
    });
    log_pivots += log_of_pivots(&base, beam.base_coordinates(), 0);
    work.scratch = base;
    (negative, log_pivots)
}

/// Sum of ln |pivot| of an eliminated matrix, from row `first` on.
fn log_of_pivots(matrix: &[Complex], rows: usize, first: usize) -> f64 {
    (first..rows)
        .map(|i| matrix[i * rows + i].re.abs().ln())
        .sum()
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

/// Eliminates the coordinates of the base, where everything above it is the matrix `above`.
fn eliminate_base<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    factors: &[f64; 3],
    above: SquareMatrix<S, D>,
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
    for i in base.moving() {
        let row = base
            .moving()
            .map(|j| sum[i][j].times(base.unit[i] * base.unit[j]));
        matrix.extend(row);
    }
    eliminate(matrix, base.moving().count(), 0)
}

/// Eliminates all rows of a Hermitian matrix from the last to `first`; returns how many pivots are
/// negative.
pub(crate) fn eliminate<S: Scalar>(matrix: &mut [S], rows: usize, first: usize) -> usize {
    let mut negative = 0;
    for last in (first..rows).rev() {
        let (rest, row) = matrix.split_at_mut(last * rows);
        let mut pivot = row[last].re();
        if pivot.abs() < TINY_PIVOT {
            pivot = -TINY_PIVOT;
        }
        row[last] = S::real(pivot);
        negative += usize::from(pivot < 0.0);
        for (i, out) in rest.chunks_exact_mut(rows).enumerate() {
            let factor = row[i].conj().over(pivot);
            for (out, row) in out[..last].iter_mut().zip(&row[..last]) {
                *out -= factor * *row;
            }
        }
    }
    negative
}

/// Solves A y = x in place, with the factors of A from [`factorize`].
pub fn solve<const D: usize, S: Scalar>(beam: &Beam<D>, work: &mut Factors<S>, x: &mut [S]) {
    work.right.resize(beam.rows(), S::default());
    let (of_base, own) = x.split_at_mut(beam.base_coordinates());
    let force = reduce_down(beam, work, own);
    solve_base(beam, &work.base, &force, of_base);
    substitute_up(beam, work, base_motion(beam, of_base), own);
}

/// Eliminates the coordinates of the elements from the top down; returns the force on the base.
fn reduce_down<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    work: &mut Factors<S>,
    own: &mut [S],
) -> [S; D] {
    let (rows, coordinates) = (beam.rows(), beam.coordinates());
    let Factors {
        elements, right, ..
    } = work;
    let mut force = [S::default(); D];
    for element in (0..beam.elements()).rev() {
        let own = &mut own[element * coordinates..(element + 1) * coordinates];
        for (component, row) in force.iter().zip(tip_rows(beam, element)) {
            own.iter_mut()
                .zip(row)
                .for_each(|(x, tip)| *x += component.times(*tip));
        }
        transform_force(&mut force, beam.length_m(element));
        right[..D].copy_from_slice(&force);
        right[D..].copy_from_slice(own);
        reduce(&elements[element * rows * rows..], rows, D, right);
        force.copy_from_slice(&right[..D]);
        own.copy_from_slice(&right[D..]);
    }
    force
}

/// Finds the coordinates of the elements from the base up, from the motion of the base.
fn substitute_up<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    work: &mut Factors<S>,
    base: [S; D],
    own: &mut [S],
) {
    let (rows, coordinates) = (beam.rows(), beam.coordinates());
    let Factors {
        elements, right, ..
    } = work;
    let mut motion = base;
    for element in 0..beam.elements() {
        let own = &mut own[element * coordinates..(element + 1) * coordinates];
        right[..D].copy_from_slice(&motion);
        right[D..].copy_from_slice(own);
        substitute(&elements[element * rows * rows..], rows, D, right);
        own.copy_from_slice(&right[D..]);
        transform_motion(&mut motion, beam.length_m(element));
        for (component, row) in motion.iter_mut().zip(tip_rows(beam, element)) {
            *component += row
                .iter()
                .zip(&*own)
                .map(|(tip, y)| y.times(*tip))
                .sum::<S>();
        }
    }
}

/// The rows of the motion of an element's top for its coordinates.
#[inline]
fn tip_rows<const D: usize>(beam: &Beam<D>, element: usize) -> std::slice::ChunksExact<'_, f64> {
    let coordinates = beam.coordinates();
    let tips = &beam.tips[element * D * coordinates..(element + 1) * D * coordinates];
    tips.chunks_exact(coordinates.max(1))
}

fn solve_base<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    matrix: &[S],
    force: &[S; D],
    of_base: &mut [S],
) {
    let Some(base) = &beam.base else {
        return;
    };
    for (x, component) in of_base.iter_mut().zip(base.moving()) {
        *x += force[component].times(base.unit[component]);
    }
    let rows = of_base.len();
    reduce(matrix, rows, 0, of_base);
    substitute(matrix, rows, 0, of_base);
}

/// Eliminates the coordinates from `first` on from a right side.
fn reduce<S: Scalar>(factors: &[S], rows: usize, first: usize, right: &mut [S]) {
    for last in (first..rows).rev() {
        let row = &factors[last * rows..=last * rows + last];
        let factor = right[last].over(row[last].re());
        for (r, a) in right[..last].iter_mut().zip(row) {
            *r -= factor * a.conj();
        }
    }
}

/// Finds the coordinates from `first` on of a reduced right side, the unknowns before them being
/// known.
fn substitute<S: Scalar>(factors: &[S], rows: usize, first: usize, right: &mut [S]) {
    for k in first..rows {
        let row = &factors[k * rows..=k * rows + k];
        let known: S = row[..k].iter().zip(&right[..k]).map(|(a, y)| *a * *y).sum();
        right[k] = (right[k] - known).over(row[k].re());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;

    const SIZE: usize = 9;

    /// Numbers in (−1, 1) that follow from a seed.
    fn numbers(seed: u64) -> impl Iterator<Item = f64> {
        let mut state = seed;
        std::iter::repeat_with(move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        })
    }

    fn hermitian(seed: u64) -> Vec<Complex> {
        let mut numbers = numbers(seed);
        let mut matrix = vec![Complex::default(); SIZE * SIZE];
        for i in 0..SIZE {
            for j in 0..=i {
                let mut next = || numbers.next().expect("endless");
                let im = if i == j { 0.0 } else { next() };
                matrix[i * SIZE + j] = Complex::new(next(), im);
                matrix[j * SIZE + i] = matrix[i * SIZE + j].conj();
            }
        }
        matrix
    }

    /// [[A, −B], [B, A]] for A + iB: real and symmetric, with every eigenvalue twice.
    fn doubled(matrix: &[Complex]) -> DMatrix<f64> {
        DMatrix::from_fn(2 * SIZE, 2 * SIZE, |i, j| {
            let entry = matrix[i % SIZE * SIZE + j % SIZE];
            match (i < SIZE, j < SIZE) {
                (true, false) => -entry.im,
                (false, true) => entry.im,
                _ => entry.re,
            }
        })
    }

    #[test]
    fn negative_pivots_of_hermitian_matrices_are_negative_eigenvalues() {
        for seed in 1..200 {
            let mut matrix = hermitian(seed);
            let eigenvalues = doubled(&matrix).symmetric_eigenvalues();
            let negative = eigenvalues.iter().filter(|value| **value < 0.0).count();
            assert_eq!(2 * eliminate(&mut matrix, SIZE, 0), negative, "{seed}");
        }
    }

    #[test]
    fn factors_of_hermitian_matrices_solve() {
        for seed in 1..50 {
            let matrix = hermitian(seed);
            let exact: Vec<Complex> = hermitian(seed + 1000)[..SIZE].to_vec();
            let rows = matrix.chunks_exact(SIZE);
            let mut x: Vec<Complex> = rows
                .map(|row| row.iter().zip(&exact).map(|(a, x)| *a * *x).sum())
                .collect();
            let mut factors = matrix.clone();
            eliminate(&mut factors, SIZE, 0);
            reduce(&factors, SIZE, 0, &mut x);
            substitute(&factors, SIZE, 0, &mut x);
            // Without exchanging rows a small pivot costs digits: not one of these costs seven.
            for (x, exact) in x.iter().zip(&exact) {
                let error = *x - *exact;
                assert!(error.re.hypot(error.im) < 1e-9, "{seed}");
            }
        }
    }
}
