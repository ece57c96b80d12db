//! Eigenvalues from good guesses of their vectors, with the proof that none is missing.
//!
//! One step for a guess v with Rayleigh quotient σ is x = (K − σM)⁻¹ M v, whose quotient ρ is the
//! better value (Rayleigh quotient iteration; Parlett, *The Symmetric Eigenvalue Problem*, 1998,
//! ch. 4): the error is cubed. In the norm of M⁻¹ the residual of x at ρ is
//!
//! r² = vᵀMv/xᵀMx − (ρ − σ)²,
//!
//! so an eigenvalue is within r of ρ, and within r²/gap where no other is within the gap. The
//! factorization of K − σM counts the eigenvalues below σ; with disjoint intervals ρ ± r this
//! proves that the list is complete.

use super::certificate::{CountCheck, beyond, verify};
use super::pencil::ShiftInvert;
use super::vector::scale;

/// Limit of the steps; a good guess needs fewer.
const MAX_STEPS: usize = 6;
/// A shift nearer to the eigenvalue than this fraction of the gap is kept: a step with it reduces
/// the error by as much, and saves a factorization.
const NEAR: f64 = 0.01;
/// The permitted relative error of an eigenvalue on another mesh, for an estimate …
pub(crate) const OF_ESTIMATES: f64 = 1e-14;
/// … and of one that is listed.
pub(super) const OF_LISTS: f64 = 1e-15;
/// Eigenvalues that are nearer to each other, relatively, are left to the Lanczos process.
const NEAREST: f64 = 1e-4;
/// The relative gap above the highest eigenvalue known, which decides about one step more.
const GAP_ABOVE: f64 = 0.1;

/// Guesses of eigenvectors, and the eigenvalues that were found from them.
#[derive(Debug, Default)]
pub(crate) struct Refinement {
    /// A guess of each wanted eigenvector, lowest first.
    pub(crate) vectors: Vec<Vec<f64>>,
    /// The eigenvalues of the last [`refine`].
    pub(crate) lambdas: Vec<f64>,
    /// r/ρ of each eigenvalue.
    pub(super) residuals: Vec<f64>,
    /// Products with the mass matrix in the last [`refine`].
    pub(super) products: usize,
    load: Vec<f64>,
}

/// An eigenvalue found.
struct Refined {
    /// ρ.
    lambda: f64,
    /// r.
    residual: f64,
    /// The last shift σ, and how many eigenvalues are below it.
    shift: f64,
    count: usize,
}

/// Computes the `wanted` lowest eigenvalues from guesses of their vectors, where the eigenvalues of
/// a similar pencil are `known`, to a relative tolerance. False if the guesses do not lead to a
/// list that is proved complete: then another process must find it.
pub(crate) fn refine(
    pencil: &mut dyn ShiftInvert,
    known: &[f64],
    wanted: usize,
    tolerance: f64,
    workspace: &mut Refinement,
) -> bool {
    workspace.reset(pencil.size(), wanted);
    if (0..wanted).any(|index| relative_gap(known, index) < NEAREST) {
        return false;
    }
    let mut is_complete = false;
    let mut end = f64::INFINITY;
    // The highest first: its guess is the worst.
    for index in (0..wanted).rev() {
        let gap = relative_gap(known, index);
        let Some(refined) = workspace.refine_one(pencil, (gap, tolerance), index) else {
            return false;
        };
        let above = refined.lambda + refined.residual;
        if index + 1 == wanted {
            is_complete = refined.count == wanted && above < refined.shift;
        }
        // Two guesses may lead to one eigenvalue. Its two values differ by rounding, which is not
        // in the residuals.
        if above * (1.0 + NEAREST) >= end {
            return false;
        }
        end = refined.lambda - refined.residual;
        workspace.lambdas[index] = refined.lambda;
        workspace.residuals[index] = refined.residual / refined.lambda;
    }
    let last = workspace.lambdas[wanted - 1];
    let margins = beyond(workspace.residuals[wanted - 1], &super::MARGINS);
    let count = |shift| pencil.count_below(shift);
    end > 0.0
        && (is_complete
            || matches!(
                verify(last, wanted, margins, count),
                CountCheck::Complete { .. }
            ))
}

/// The relative distance of an eigenvalue to its neighbours.
fn relative_gap(known: &[f64], index: usize) -> f64 {
    let own = known[index];
    let distance = |other: f64| (1.0 - other / own).abs();
    let below = index.checked_sub(1).map(|below| distance(known[below]));
    let above = known.get(index + 1).map(|above| distance(*above));
    below.unwrap_or(1.0).min(above.unwrap_or(GAP_ABOVE))
}

impl Refinement {
    fn reset(&mut self, size: usize, wanted: usize) {
        for of_modes in [&mut self.lambdas, &mut self.residuals] {
            of_modes.clear();
            of_modes.resize(wanted, 0.0);
        }
        self.load.resize(size, 0.0);
        self.products = 0;
    }

    /// Iterates from a guess until the eigenvalue is accurate; then the vector with xᵀKx = 1
    /// replaces the guess.
    fn refine_one(
        &mut self,
        pencil: &mut dyn ShiftInvert,
        (gap, tolerance): (f64, f64),
        index: usize,
    ) -> Option<Refined> {
        let Self {
            vectors,
            load,
            products,
            ..
        } = self;
        let x = &mut vectors[index][..];
        let mut energies = pencil.energies(x);
        let (mut shift, mut count) = (f64::NAN, 0);
        for _ in 0..MAX_STEPS {
            let [stiffness, mass] = energies;
            let quotient = stiffness / mass;
            if !(quotient > 0.0 && quotient.is_finite()) {
                return None;
            }
            // A shift near the eigenvalue is used once more. The first shift is NaN, so it is not
            // near.
            let is_near = (quotient - shift).abs() <= NEAR * gap * quotient;
            *products += 1;
            if is_near {
                (_, energies) = pencil.inverse_step(None, x, load);
            } else {
                shift = quotient;
                (count, energies) = pencil.inverse_step(Some(shift), x, load);
            }
            let lambda = energies[0] / energies[1];
            let squared = mass / energies[1] - (lambda - shift) * (lambda - shift);
            let residual_squared = squared.max(0.0);
            if residual_squared <= tolerance * gap * lambda * lambda {
                scale(x, 1.0 / energies[0].sqrt());
                return Some(Refined {
                    lambda,
                    residual: residual_squared.sqrt(),
                    shift,
                    count,
                });
            }
            // The vector has grown as the shift is near to the eigenvalue.
            let factor = 1.0 / energies[1].sqrt();
            scale(x, factor);
            energies = energies.map(|energy| energy * factor * factor);
        }
        None
    }
}
