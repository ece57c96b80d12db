//! Reduces the number of requested modes to those that double precision resolves.

use super::error::SolveError;
use super::results::solution::Solution;
use super::solver::Solver;
use crate::eigen::EigenError;
use crate::tower::{Tower, Warning};

impl Solver {
    /// [`solve`](Self::solve), but if the stiffest of the modes requested are not resolvable in
    /// double precision, only the lower ones that are, with a [`Warning::OnlyCertain`]. For
    /// instance, a tower with hardly any mass has four bending modes, those of the RNA on it, and
    /// the next ones far above.
    ///
    /// The certificate is that of the modes listed.
    ///
    /// # Errors
    /// As [`solve`](crate::solve()) for any other reason, or if not even one mode is resolvable.
    pub fn solve_certain(&mut self, tower: &Tower) -> Result<Solution, SolveError> {
        let wanted = self.options.modes;
        let found = self.most_certain(tower);
        self.options.modes = wanted;
        found
    }

    /// As above by bisection; changes the number of modes in the options.
    fn most_certain(&mut self, tower: &Tower) -> Result<Solution, SolveError> {
        let wanted = self.options.modes;
        let (mut hidden, mut listed) = (wanted, 0);
        let mut result = self.solve(tower);
        let mut certain = None;
        while is_hidden(&result) && hidden - listed > 1 {
            self.options.modes = listed + (hidden - listed) / 2;
            match self.solve(tower) {
                Ok(solution) => (listed, certain) = (self.options.modes, Some(solution)),
                Err(SolveError::Eigen(EigenError::Unresolved { .. })) => {
                    hidden = self.options.modes;
                }
                Err(other) => return Err(other),
            }
        }
        if let Some(mut solution) = certain {
            let warning = Warning::OnlyCertain { listed, wanted };
            solution.warnings.push(warning);
            result = Ok(solution);
        }
        result
    }
}

fn is_hidden(result: &Result<Solution, SolveError>) -> bool {
    matches!(
        result,
        Err(SolveError::Eigen(EigenError::Unresolved { .. }))
    )
}
