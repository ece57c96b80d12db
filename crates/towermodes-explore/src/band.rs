//! The frequencies of the tower in softer and stiffer soil.

use towermodes::{SolveError, Solver};
use towermodes_analysis::soil_band::{DEFAULT_FACTORS, SoilBand, soil_band};

use super::explorer::Explorer;
use super::refusal::Refusal;
use super::state::State;

impl Explorer {
    /// Frequencies and verdicts for half and twice the stiffness of soil and foundation, as
    /// `campbell` gives them.
    ///
    /// # Errors
    /// [`Refusal`]: the tower has no soil, or cannot be solved.
    pub fn band(&self, state: &State) -> Result<SoilBand, Refusal> {
        let solved = self.solved(state)?;
        let limits = &self.exploration.campbell;
        let rotor = solved.assessment.as_ref().map(|of| &of.campbell);
        let rotor = rotor.filter(|of| of.not_checked.is_empty());
        let rotor = rotor.map(|of| (&of.rotor, limits));
        let (description, solution) = (&solved.input.description, &solved.solution);
        let mut options = self.options(&solved.input);
        options.modes = options.modes.max(solution.modes.len());
        options.points = 2;
        // A solver of its own: the page asks on while it runs.
        let mut solver = Solver::new(options);
        let solve = |tower: &_| -> Result<_, SolveError> { solver.solve_certain(tower) };
        let band = soil_band(description, solution, &DEFAULT_FACTORS, rotor, solve);
        band.map_err(|error| Refusal::of(&error))
    }
}
