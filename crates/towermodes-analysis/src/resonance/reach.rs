//! The highest frequency of the excitations of a rotor, and the check that the list of modes
//! extends to it.

use super::campbell::{Campbell, CampbellOptions, is_strong};
use crate::verdict::Verdict;
use towermodes::tower::Rotor;
use towermodes::{Solution, SolveError, Solver, Tower};

impl Campbell {
    /// The frequency range (from, to), Hz, in which the tower may have modes that are not in the
    /// list although an excitation comes close to this range; none if the list covers all
    /// excitations.
    #[must_use]
    pub fn uncovered_range_hz(&self) -> Option<[f64; 2]> {
        let known_hz = self.known_to_hz?;
        let options = CampbellOptions {
            margin: self.margin,
            multiples: self.multiples.clone(),
            ..CampbellOptions::default()
        };
        let reach_hz = reach_hz(&self.rotor, &options);
        (known_hz < reach_hz).then_some([known_hz, reach_hz])
    }

    /// The worst verdict of all pairs; at best [`Verdict::Warn`] if the list of modes does not
    /// [cover all excitations](Self::uncovered_range_hz); [`Verdict::Undecided`] if a reason is in
    /// [`Campbell::not_checked`].
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if !self.not_checked.is_empty() {
            return Verdict::Undecided;
        }
        let worst = self.margins.iter().map(|margin| margin.verdict).max();
        let worst = worst.unwrap_or(Verdict::Pass);
        match self.uncovered_range_hz() {
            Some(_) => worst.max(Verdict::Warn),
            None => worst,
        }
    }
}

/// The frequency, Hz, above which every tower mode passes.
///
/// With the highest operating speed Ω, the multiple n and the margin m, the distance n Ω/f − 1 is
/// −m at f = n Ω/(1 − m), and −2 m (below which the strong excitations warn) at f = n Ω/(1 − 2 m).
/// The result is the largest of these.
#[must_use]
pub fn reach_hz(rotor: &Rotor, options: &CampbellOptions) -> f64 {
    let reach = |multiple: usize| {
        let warned = match is_strong(multiple, rotor) && options.margin < 0.5 {
            true => 2.0 * options.margin,
            // With 50 % or more no frequency is 2 m above the excitation.
            false => options.margin,
        };
        multiple as f64 * rotor.highest_rpm / 60.0 / (1.0 - warned)
    };
    let reaches = options.multiples_of(rotor).into_iter().map(reach);
    reaches.fold(0.0, f64::max)
}

/// The largest number of modes for which [`solve_to_reach`] solves.
pub const MOST_MODES: usize = 40;

/// Solves for the number of modes in the options, and then for twice as many (at most
/// [`MOST_MODES`]) until the list is complete up to `reach_hz` ([`reach_hz()`]) or the tower has no
/// more modes. Afterwards the options contain the last number of modes.
///
/// # Errors
/// Those of [`Solver::solve_certain`].
pub fn solve_to_reach(
    solver: &mut Solver,
    tower: &Tower,
    reach_hz: f64,
) -> Result<Solution, SolveError> {
    let reaches = |solution: &Solution| solution.certificate.below_hz >= reach_hz;
    solver.until(MOST_MODES, |solver| solver.solve_certain(tower), reaches)
}

/// The frequency, Hz, below which the list of modes is complete; none if it has all modes.
pub(super) fn known_to_hz(solution: &Solution) -> Option<f64> {
    let listed = solution.modes.len();
    if listed >= solution.degrees_of_freedom {
        return None;
    }
    let certificate = &solution.certificate;
    match solution.modes.last() {
        // Proved modes that are not listed lie beside the last one.
        Some(last) if certificate.count > listed => Some(last.frequency_hz),
        _ => Some(certificate.below_hz),
    }
}
