//! The factorization of a matrix A of a beam in O(n), with solve and inertia count.
//!
//! As for a chain of rigid bodies: seen from the base of an element, all that is above it is one
//! symmetric D×D matrix P. From the top down,
//!
//! A ← A_e + [X T]ᵀ P [X T],
//!
//! the element's coordinates are eliminated from A one by one, the stiffest first, and what is left
//! is the P of its base; last come the coordinates of a base that moves. The pivots are the D of a
//! factorization L D Lᵀ, so the negative ones are the negative eigenvalues (Sylvester).

use super::model::{Beam, add_congruent};
use super::product::{base_motion, factors};
use crate::space::{Matrix, add_scaled, transform_force, transform_motion};
use crate::subsystem::Coefficients;

/// Pivots closer to zero than this are moved there, to the negative side: an eigenvalue hit exactly
/// counts as below.
const TINY_PIVOT: f64 = 1e-30;

/// A factored a, and working memory; reused from solve to solve.
#[derive(Debug, Clone, Default)]
pub struct Factors {
    /// Each element's matrix after its coordinates were eliminated: a row holds what it was coupled
    /// with before.
    elements: Vec<f64>,
    /// The same of the base.
    base: Vec<f64>,
    /// The base's when nothing is to be stored: a count must leave the factors alone.
    scratch: Vec<f64>,
    matrix: Vec<f64>,
    top: Vec<f64>,
    right: Vec<f64>,
}

/// The number of negative eigenvalues of a matrix A of the beam; nothing is stored.
pub fn count_negative<const D: usize>(
    beam: &Beam<D>,
    a: &Coefficients,
    work: &mut Factors,
) -> usize {
    let mut base = std::mem::take(&mut work.scratch);
    let negative = eliminate_all(beam, a, work, &mut base, |_, _| {});
    work.scratch = base;
    negative
}

/// Factors a matrix A of the beam and returns the number of its negative eigenvalues.
pub fn factorize<const D: usize>(beam: &Beam<D>, a: &Coefficients, work: &mut Factors) -> usize {
    let size = beam.rows() * beam.rows();
    let mut elements = std::mem::take(&mut work.elements);
    elements.resize(size * beam.elements(), 0.0);
    let mut base = std::mem::take(&mut work.base);
    let negative = eliminate_all(beam, a, work, &mut base, |element, matrix| {
        elements[element * size..(element + 1) * size].copy_from_slice(matrix);
    });
    (work.elements, work.base) = (elements, base);
    negative
}

/// Eliminates everything from the top down, passes each element's matrix to `record`, and leaves
/// that of the base in `base`.
fn eliminate_all<const D: usize>(
    beam: &Beam<D>,
    a: &Coefficients,
    work: &mut Factors,
    base: &mut Vec<f64>,
    mut record: impl FnMut(usize, &[f64]),
) -> usize {
    let rows = beam.rows();
    let factors = factors(a);
    work.matrix.resize(rows * rows, 0.0);
    work.top.resize(D * rows, 0.0);
    let (matrix, top) = (&mut work.matrix[..], &mut work.top[..]);
    let mut above = [[0.0; D]; D];
    let mut negative = 0;
    for element in (0..beam.elements()).rev() {
        combine(beam, &factors, element, matrix);
        beam.top_motion(element, top);
        add_congruent(&above, top, rows, matrix);
        (D..rows).for_each(|i| matrix[i * rows + i] += a.stiffness);
        negative += eliminate(matrix, rows, D);
        above = std::array::from_fn(|i| std::array::from_fn(|j| matrix[i * rows + j]));
        record(element, matrix);
    }
    negative + eliminate_base(beam, &factors, above, base)
}

/// The matrix of one element, without the elements' own stiffness.
#[inline]
fn combine<const D: usize>(beam: &Beam<D>, factors: &[f64; 3], element: usize, matrix: &mut [f64]) {
    let size = matrix.len();
    matrix.fill(0.0);
    for (factor, matrices) in factors.iter().zip(&beam.matrices) {
        let own = matrices.get(element * size..(element + 1) * size);
        if let Some(own) = own.filter(|_| *factor != 0.0) {
            for (entry, own) in matrix.iter_mut().zip(own) {
                *entry += factor * own;
            }
        }
    }
}

/// Eliminates the coordinates of the base, where everything above it is the matrix `above`.
fn eliminate_base<const D: usize>(
    beam: &Beam<D>,
    factors: &[f64; 3],
    above: Matrix<D>,
    matrix: &mut Vec<f64>,
) -> usize {
    matrix.clear();
    let Some(base) = &beam.base else {
        return 0;
    };
    let mut sum = above;
    for (factor, own) in factors.iter().zip(&base.matrices) {
        add_scaled(&mut sum, *factor, own);
    }
    for i in base.moving() {
        let row = base
            .moving()
            .map(|j| base.unit[i] * base.unit[j] * sum[i][j]);
        matrix.extend(row);
    }
    eliminate(matrix, base.moving().count(), 0)
}

/// Eliminates all rows of a matrix from the last to `first`; returns how many pivots are negative.
fn eliminate(matrix: &mut [f64], rows: usize, first: usize) -> usize {
    let mut negative = 0;
    for last in (first..rows).rev() {
        let (rest, row) = matrix.split_at_mut(last * rows);
        let mut pivot = row[last];
        if pivot.abs() < TINY_PIVOT {
            pivot = -TINY_PIVOT;
        }
        row[last] = pivot;
        negative += usize::from(pivot < 0.0);
        for (i, out) in rest.chunks_exact_mut(rows).enumerate() {
            let factor = row[i] / pivot;
            for (out, row) in out[..last].iter_mut().zip(&row[..last]) {
                *out -= factor * row;
            }
        }
    }
    negative
}

/// Solves A y = x in place, with the factors of A from [`factorize`].
pub fn solve<const D: usize>(beam: &Beam<D>, work: &mut Factors, x: &mut [f64]) {
    work.right.resize(beam.rows(), 0.0);
    let (of_base, own) = x.split_at_mut(beam.base_coordinates());
    let force = reduce_down(beam, work, own);
    solve_base(beam, &work.base, &force, of_base);
    substitute_up(beam, work, base_motion(beam, of_base), own);
}

/// Eliminates the coordinates of the elements from the top down; returns the force on the base.
fn reduce_down<const D: usize>(beam: &Beam<D>, work: &mut Factors, own: &mut [f64]) -> [f64; D] {
    let (rows, coordinates) = (beam.rows(), beam.coordinates());
    let Factors {
        elements, right, ..
    } = work;
    let mut force = [0.0; D];
    for element in (0..beam.elements()).rev() {
        let own = &mut own[element * coordinates..(element + 1) * coordinates];
        for (component, row) in force.iter().zip(tip_rows(beam, element)) {
            own.iter_mut()
                .zip(row)
                .for_each(|(x, tip)| *x += component * tip);
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
fn substitute_up<const D: usize>(
    beam: &Beam<D>,
    work: &mut Factors,
    base: [f64; D],
    own: &mut [f64],
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
            *component += row.iter().zip(&*own).map(|(tip, y)| tip * y).sum::<f64>();
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

fn solve_base<const D: usize>(
    beam: &Beam<D>,
    matrix: &[f64],
    force: &[f64; D],
    of_base: &mut [f64],
) {
    let Some(base) = &beam.base else {
        return;
    };
    for (x, component) in of_base.iter_mut().zip(base.moving()) {
        *x += base.unit[component] * force[component];
    }
    let rows = of_base.len();
    reduce(matrix, rows, 0, of_base);
    substitute(matrix, rows, 0, of_base);
}

/// Eliminates the coordinates from `first` on from a right side.
fn reduce(factors: &[f64], rows: usize, first: usize, right: &mut [f64]) {
    for last in (first..rows).rev() {
        let row = &factors[last * rows..=last * rows + last];
        let factor = right[last] / row[last];
        for (r, a) in right[..last].iter_mut().zip(row) {
            *r -= factor * a;
        }
    }
}

/// Finds the coordinates from `first` on of a reduced right side, the unknowns before them being
/// known.
fn substitute(factors: &[f64], rows: usize, first: usize, right: &mut [f64]) {
    for k in first..rows {
        let row = &factors[k * rows..=k * rows + k];
        let known: f64 = row[..k].iter().zip(&right[..k]).map(|(a, y)| a * y).sum();
        right[k] = (right[k] - known) / row[k];
    }
}
