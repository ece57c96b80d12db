//! The proof that a list of eigenvalues is complete, and the bound on each.
//!
//! The list holds k orthonormal vectors with small residuals, so there are k eigenvalues near it
//! (Kahan 1967). An eigenvalue count above the reach of the last one that gives k proves that there
//! are no more: the list is complete.

/// The result of the eigenvalue counts above a list of eigenvalues.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum CountCheck {
    /// The count equals the length of the list, and no eigenvalue is within this relative distance
    /// above the last one.
    Complete {
        /// (σ − λ_last)/λ_last of the shift σ with this count.
        margin: f64,
    },
    /// The count differs from the length of the list.
    Disagrees {
        /// Eigenvalues below `shift`.
        count: usize,
        /// The shift, just above the last eigenvalue of the list, rad²/s².
        shift: f64,
    },
}

/// Counts the eigenvalues below λ = `last`·(1 + margin), rad²/s², for each of `margins` in turn,
/// widest first, until the count is the expected one: a wide one proves a gap.
pub(crate) fn verify(
    last: f64,
    expected: usize,
    margins: &[f64],
    mut count_below: impl FnMut(f64) -> usize,
) -> CountCheck {
    let mut check = CountCheck::Disagrees {
        count: 0,
        shift: last,
    };
    for &margin in margins {
        let shift = last * (1.0 + margin);
        let count = count_below(shift);
        if count == expected {
            return CountCheck::Complete { margin };
        }
        check = CountCheck::Disagrees { count, shift };
    }
    check
}

/// The margins, widest first, of shifts above all eigenvalues of a list, the last of which may be
/// this far above its computed value, relative to it.
pub(super) fn beyond(reach: f64, margins: &[f64]) -> &[f64] {
    &margins[..margins.partition_point(|margin| *margin > reach)]
}

/// For each k the norm of the residual matrix of the first k orthonormal vectors, relative to θ_k:
/// k eigenvalues θ are within this of the computed ones (Kahan 1967). The Frobenius norm is an
/// upper bound of the spectral norm.
pub(super) fn residual_norms(thetas: &[f64], residuals: &[Residual]) -> impl Iterator<Item = f64> {
    let vectors = thetas.iter().zip(residuals);
    vectors.scan(0.0_f64, |norm, (theta, residual)| {
        *norm = norm.hypot(residual.value() * theta);
        Some(*norm / theta)
    })
}

/// How far an eigenvalue λ = 1/θ may be above its computed value, relative to it, if θ may be this
/// far below its own.
pub(super) fn reach(of_theta: f64) -> f64 {
    of_theta / (1.0 - of_theta)
}

/// A relative residual ρ of a vector u with eigenvalue λ = 1/θ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Residual {
    /// ‖M u − θ K u‖/θ in the norm of K⁻¹, where uᵀKu = 1.
    OfTheta(f64),
    /// ‖K u − λ M u‖/λ in the norm of M⁻¹, where uᵀMu = 1.
    OfLambda(f64),
}

impl Residual {
    pub(super) fn value(self) -> f64 {
        match self {
            Self::OfTheta(residual) | Self::OfLambda(residual) => residual,
        }
    }

    /// The distance of an eigenvalue λ to another one, relative to it: in θ or in λ.
    fn distance(self, lambda: f64, other: f64) -> f64 {
        match self {
            Self::OfTheta(_) => (1.0 - lambda / other).abs(),
            Self::OfLambda(_) => (1.0 - other / lambda).abs(),
        }
    }
}

/// The relative error bound of eigenvalue `index` of a complete list, from its relative residual ρ.
///
/// min(ρ, ρ²/gap): the residual bound, or Kato's and Temple's (Kato 1949) with the relative gap to
/// the neighbours, which is proved because the list is complete up to `margin` above its last
/// member.
pub(super) fn residual_bound(
    eigenvalues: &[f64],
    index: usize,
    residual: Residual,
    margin: f64,
) -> f64 {
    let value = eigenvalues[index];
    let distance = |other: f64| residual.distance(value, other);
    let below = index
        .checked_sub(1)
        .map_or(f64::INFINITY, |i| distance(eigenvalues[i]));
    let above = eigenvalues.get(index + 1).copied();
    let above = distance(above.unwrap_or(value * (1.0 + margin)));
    let residual = residual.value();
    residual.min(residual * residual / below.min(above))
}

/// The relative contribution of rounding to the bound, for a number of unknowns and a factor by
/// which the terms of the stiffness cancel.
///
/// A relative error η of the motions J u changes uᵀJᵀMJu by at most 2 η ‖M^½ J u‖ ‖M^½ |J| |u|‖,
/// relative to it by about η √(θ₁/θ), the ratio of this frequency to the lowest; and uᵀKu by η
/// times the `cancellation` of its terms. η is taken as √n ε (Higham & Mary 2019).
pub(super) fn rounding(eigenvalues: &[f64], index: usize, size: usize, cancellation: f64) -> f64 {
    let eta = (size as f64).sqrt() * f64::EPSILON;
    eta * ((eigenvalues[index] / eigenvalues[0]).sqrt() + cancellation)
}

#[cfg(test)]
mod tests {
    use super::{Residual, beyond, reach, residual_norms};

    #[test]
    fn a_count_within_the_residuals_proves_nothing() {
        // A residual of 1e-15 θ₁ is 1e-5 of θ₂, which is 1e10 times smaller; with its own 1e-5
        // that is √2·1e-5, so a count at 1e-6 or 1e-9 above λ₂ may miss λ₂ itself.
        let residuals = [Residual::OfTheta(1e-15), Residual::OfTheta(1e-5)];
        let norms: Vec<f64> = residual_norms(&[1.0, 1e-10], &residuals).collect();
        assert!((norms[0] - 1e-15).abs() < 1e-30);
        assert!((norms[1] - 2.0_f64.sqrt() * 1e-5).abs() < 1e-19);
        let margins = [1e-2, 1e-4, 1e-6, 1e-9];
        assert_eq!(beyond(reach(norms[1]), &margins), &[1e-2, 1e-4]);
        assert_eq!(beyond(reach(norms[0]), &margins), &margins);
        // θ half as large is λ twice as large.
        assert_eq!(reach(0.5), 1.0);
    }
}
