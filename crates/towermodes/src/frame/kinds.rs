//! The kinds of matrices of a frame, and sums of them.

/// The kinds of matrices: inertia, stiffness to the ground, geometric stiffness, and elastic
/// stiffness of parts without coordinates.
pub(super) const KINDS: usize = 4;
pub(super) const INERTIA: usize = 0;
pub(super) const GROUND: usize = 1;
pub(super) const GEOMETRIC: usize = 2;
pub(super) const ELASTIC: usize = 3;

/// A = Σ factor·matrix + `own` times the stiffness of the coordinates.
pub(super) type Combination<'a> = (&'a [f64; KINDS], f64);

/// sum += factor·A for the lower triangle or the whole of matrices of the same size.
pub(super) fn add_matrices(factors: &[f64; KINDS], matrices: &[Vec<f64>; KINDS], sum: &mut [f64]) {
    for (factor, matrix) in factors.iter().zip(matrices) {
        if *factor != 0.0 {
            for (sum, entry) in sum.iter_mut().zip(matrix) {
                *sum += factor * entry;
            }
        }
    }
}
