//! Solutions with the factors of a matrix A of a beam in O(n): forces from the top down, motions
//! from the base up.

use super::elimination::Factors;
use super::model::Beam;
use super::product::base_motion;
use crate::scalar::Scalar;
use crate::space::{transform_force, transform_motion};

/// Solves A y = x in place, with the factors of A from
/// [`factorize`](super::elimination::factorize).
pub fn solve<const D: usize, S: Scalar>(beam: &Beam<D>, work: &mut Factors<S>, x: &mut [S]) {
    solve_under(beam, work, [S::default(); D], x);
}

/// As above, with a force at the top; returns the motion of the top.
pub(super) fn solve_under<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    work: &mut Factors<S>,
    at_top: [S; D],
    x: &mut [S],
) -> [S; D] {
    let (of_base, own) = x.split_at_mut(beam.base_coordinates());
    let force = reduce_down(beam, work, at_top, own);
    solve_base(beam, &work.base, &force, of_base);
    substitute_up(beam, work, base_motion(beam, of_base), own)
}

/// Eliminates the coordinates of the elements from the top down, with a force at the top; returns
/// the force on the base.
pub(super) fn reduce_down<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    work: &mut Factors<S>,
    at_top: [S; D],
    own: &mut [S],
) -> [S; D] {
    work.right.resize(beam.rows(), S::default());
    let (rows, coordinates) = (beam.rows(), beam.coordinates());
    let Factors {
        elements, right, ..
    } = work;
    let mut force = at_top;
    for element in (0..beam.elements()).rev() {
        let own = &mut own[element * coordinates..(element + 1) * coordinates];
        for (component, row) in force.iter().zip(beam.tip_rows(element)) {
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

/// Computes the coordinates of the elements from the base up, from the motion of the base; returns
/// the motion of the top.
pub(super) fn substitute_up<const D: usize, S: Scalar>(
    beam: &Beam<D>,
    work: &mut Factors<S>,
    base: [S; D],
    own: &mut [S],
) -> [S; D] {
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
        for (component, row) in motion.iter_mut().zip(beam.tip_rows(element)) {
            *component += row
                .iter()
                .zip(&*own)
                .map(|(tip, y)| y.times(*tip))
                .sum::<S>();
        }
    }
    motion
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

/// Eliminates the coordinates with index `first` and higher from a right side.
pub(crate) fn reduce<S: Scalar>(factors: &[S], rows: usize, first: usize, right: &mut [S]) {
    for last in (first..rows).rev() {
        let row = &factors[last * rows..=last * rows + last];
        let factor = right[last].over(row[last].re());
        for (r, a) in right[..last].iter_mut().zip(row) {
            *r -= factor * a.conj();
        }
    }
}

/// Computes the coordinates with index `first` and higher from a reduced right side; the unknowns
/// before them are known.
pub(crate) fn substitute<S: Scalar>(factors: &[S], rows: usize, first: usize, right: &mut [S]) {
    for k in first..rows {
        let row = &factors[k * rows..=k * rows + k];
        let known: S = row[..k].iter().zip(&right[..k]).map(|(a, y)| *a * *y).sum();
        right[k] = (right[k] - known).over(row[k].re());
    }
}

#[cfg(test)]
mod tests {
    use super::super::elimination::eliminate;
    use super::*;
    use crate::scalar::Complex;
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
