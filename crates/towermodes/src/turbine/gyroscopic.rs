//! Eigenproblems (K + i w G − w² M) x = 0 with K and M symmetric and G skew, or all Hermitian: what
//! a search for their frequencies needs.

use crate::scalar::Complex;

/// H(w) = K + i w G − w² M, Hermitian for real w (rad/s).
pub(super) trait Gyroscopic {
    /// Number of unknowns.
    fn degrees_of_freedom(&self) -> usize;

    /// The number of negative eigenvalues of H.
    fn count(&mut self, w: f64) -> usize;

    /// The same, with the factors that [`solve`](Self::solve) needs.
    fn factorize(&mut self, w: f64) -> usize;

    /// Solves H x = r with the last factors, in place.
    fn solve(&mut self, x: &mut [Complex]);

    /// out = H′ x with H′ = i G − 2 w M; returns xᴴ M x.
    fn derivative(&mut self, w: f64, x: &[Complex], out: &mut [Complex]) -> f64;
}
