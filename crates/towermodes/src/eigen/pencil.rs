//! The interface between a model and the eigensolver.

use crate::lanes::LANES;

/// A symmetric eigenvalue problem K u = λ M u with K positive definite; M may be indefinite, then
/// the eigenvalues are the positive ones.
///
/// λ = ω² in rad²/s²; vectors have length [`size`](Self::size). Implementations keep their working
/// memory inside, hence `&mut self`; results must not depend on earlier calls.
pub trait Pencil {
    /// Number of unknowns.
    fn size(&self) -> usize;

    /// out = M x.
    fn mass_times(&mut self, x: &[f64], out: &mut [f64]);

    /// out = K x.
    fn stiffness_times(&mut self, x: &[f64], out: &mut [f64]);

    /// Whether K is the identity, so that products with it are not needed.
    fn stiffness_is_identity(&self) -> bool {
        false
    }

    /// The number of eigenvalues below `shift` (rad²/s²), by the inertia of K − shift·M.
    fn count_below(&mut self, shift: f64) -> usize;

    /// Factors K for [`solve`](Self::solve) and returns the number of its negative eigenvalues (0
    /// if K is positive definite).
    fn factorize(&mut self) -> usize;

    /// x ← K⁻¹ x, after [`factorize`](Self::factorize).
    fn solve(&mut self, x: &mut [f64]);

    /// The factor by which relative errors of the terms of xᵀ K x = 1, and of the motions in them,
    /// are amplified: more than 0 where terms cancel, as with geometric stiffness, or where motions
    /// cancel at something stiff. `scratch` is memory to work in.
    fn stiffness_cancellation(&mut self, _x: &[f64], _scratch: &mut Vec<f64>) -> f64 {
        0.0
    }

    /// A starting vector that has a component in every low mode.
    fn start(&mut self, out: &mut [f64]);
}

/// A pencil that can be factored at any shift.
pub trait ShiftInvert: Pencil {
    /// Factors K − `shift`·M for [`solve_shifted`](Self::solve_shifted), in place of what was
    /// factored before, and returns the number of eigenvalues below `shift` (rad²/s²).
    fn factorize_shifted(&mut self, shift: f64) -> usize;

    /// x ← (K − shift·M)⁻¹ x.
    fn solve_shifted(&mut self, x: &mut [f64]);

    /// xᵀ K x and xᵀ M x.
    fn energies(&mut self, x: &[f64]) -> [f64; 2];

    /// One step of inverse iteration: x ← (K − σM)⁻¹ M x, factored first if a shift σ (rad²/s²) is
    /// given, else with the last σ. The number of eigenvalues below σ (0 if it is not factored),
    /// and the energies of the new x. `load` is memory to work in, as long as x.
    fn inverse_step(
        &mut self,
        shift: Option<f64>,
        x: &mut [f64],
        load: &mut [f64],
    ) -> (usize, [f64; 2]) {
        if let Some(step) = self.fused_step(shift, x) {
            return step;
        }
        let count = shift.map_or(0, |shift| self.factorize_shifted(shift));
        self.mass_times(x, load);
        x.copy_from_slice(load);
        self.solve_shifted(x);
        (count, self.energies(x))
    }

    /// The same in fewer passes over the model; none, and no effect, where there is no such way.
    fn fused_step(&mut self, _shift: Option<f64>, _x: &mut [f64]) -> Option<(usize, [f64; 2])> {
        None
    }

    /// Steps with shifts of their own, each with a vector, or without one if only the eigenvalues
    /// below the shift are counted. None, and no effect, where single steps take no longer.
    fn inverse_steps(
        &mut self,
        _shifts: &[f64; LANES],
        _x: [Option<&mut [f64]>; LANES],
    ) -> Option<[(usize, [f64; 2]); LANES]> {
        None
    }
}
