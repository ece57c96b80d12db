//! Eigenproblems (K + i w G − w² M) x = 0 with K and M symmetric and G skew, or all Hermitian: the
//! interface for the search for their frequencies.

use crate::scalar::Complex;

/// A matrix added to H(w): R = a M + b N.
///
/// N is positive and not less than ±H′(w): 2 w M where nothing turns, 2 (|s| + Ω) M for blades at
/// the frequency s of their own frame, because |xᴴ C x| ≤ xᴴ M x, and the largest gyroscopic
/// couples of hub and generator. So H(w ± r) is between H(w) − r N − r² M and H(w) + r N.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Raise {
    /// a, rad²/s².
    pub(crate) by_inertia: f64,
    /// b, rad/s.
    pub(crate) by_change: f64,
}

impl Raise {
    /// The matrix that makes H(w) a lower bound of H(w ± r), for r in rad/s: −r N − r² M.
    pub(crate) fn below(r: f64) -> Self {
        Self {
            by_inertia: -r * r,
            by_change: -r,
        }
    }

    /// The matrix that makes H(w) an upper bound of H(w ± r), for r in rad/s: r N.
    pub(crate) fn above(r: f64) -> Self {
        Self {
            by_inertia: 0.0,
            by_change: r,
        }
    }

    /// The coefficient of the inertia of parts that do not rotate, in R.
    pub(crate) fn inertia(self, w: f64) -> f64 {
        self.by_inertia + 2.0 * self.by_change * w
    }

    /// The coefficient of the inertia of a blade at a frequency in its own frame, in R.
    pub(super) fn inertia_of_blade(self, own: f64, speed: f64) -> f64 {
        self.by_inertia + 2.0 * self.by_change * (own.abs() + speed.abs())
    }
}

/// H(w) = K + i w G − w² M, Hermitian for real w (rad/s).
pub(crate) trait Gyroscopic {
    /// Number of unknowns.
    fn degrees_of_freedom(&self) -> usize;

    /// The number of negative eigenvalues of H.
    fn count(&mut self, w: f64) -> usize {
        self.count_raised(w, Raise::default())
    }

    /// The number of negative eigenvalues of H + R.
    fn count_raised(&mut self, w: f64, raise: Raise) -> usize;

    /// As above, with the factors that [`solve`](Self::solve) needs.
    fn factorize(&mut self, w: f64) -> usize;

    /// Solves H x = r with the last factors, in place.
    fn solve(&mut self, x: &mut [Complex]);

    /// out = H′ x with H′ = i G − 2 w M; returns xᴴ M x.
    fn derivative(&mut self, w: f64, x: &[Complex], out: &mut [Complex]) -> f64;
}
