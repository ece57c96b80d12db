//! The lowest modes of a tower by name, without shapes.

use towermodes::modes::SharedMotion;
use towermodes::{ModeName, Shares, SolveError, Solver, Tower};

/// The lowest modes of one tower; the memory is reused for the next tower.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Lowest {
    /// The modes by frequency.
    pub(crate) modes: Vec<NamedFrequency>,
    /// Whether the list is proved to be complete.
    pub(crate) certified: bool,
    /// Why more modes could not be computed although a requested one was missing.
    pub(crate) no_more: Option<SolveError>,
}

/// The frequency of a mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NamedFrequency {
    pub(crate) name: ModeName,
    /// The extrapolated frequency, Hz.
    pub(crate) hz: f64,
    /// The error of the frequency without extrapolation, Hz.
    pub(crate) error_hz: f64,
    /// The share of each type of motion in its energy.
    pub(crate) shares: Shares,
}

impl NamedFrequency {
    /// The share of its own type of motion in its energy.
    pub(crate) fn share(&self) -> f64 {
        self.shares.of(self.name.family)
    }
}

impl Lowest {
    /// Solves a tower.
    pub(crate) fn solve(&mut self, tower: &Tower, solver: &mut Solver) -> Result<(), SolveError> {
        let frequencies = solver.frequencies(tower)?;
        self.modes.clear();
        self.modes
            .extend(frequencies.modes.iter().map(|mode| NamedFrequency {
                name: mode.name(),
                hz: mode.extrapolated_hz,
                error_hz: mode.error_hz(),
                shares: mode.shares,
            }));
        self.certified = frequencies.certificate.complete;
        Ok(())
    }

    /// Solves a tower for `options.modes` modes, and for more, up to `most`, until all requested
    /// modes are among them or no more can be computed. `options.modes` becomes the number of
    /// computed modes.
    ///
    /// # Errors
    /// The error of the first solve. If a later solve fails, the modes already computed remain.
    pub(crate) fn solve_for(
        &mut self,
        wanted: &[ModeName],
        tower: &Tower,
        most: usize,
        solver: &mut Solver,
    ) -> Result<(), SolveError> {
        self.no_more = None;
        self.solve(tower, solver)?;
        while !wanted.iter().all(|name| self.mode(*name).is_some()) {
            let more = more_than(solver.options.modes).min(most);
            if more <= solver.options.modes {
                break;
            }
            solver.options.modes = more;
            let mut solved = self.solve(tower, solver);
            let is_last = solved.is_err();
            if let Err(SolveError::TooManyModes { available, .. }) = solved {
                solver.options.modes = available;
                solved = match available > self.modes.len() {
                    true => self.solve(tower, solver),
                    false => Ok(()),
                };
            }
            self.no_more = solved.err();
            if is_last {
                break;
            }
        }
        Ok(())
    }

    /// Whether several modes share the motion that this name states, so that a small change of the
    /// tower may give the name to another mode.
    pub(crate) fn is_shared(&self, name: ModeName) -> bool {
        let mode = self.mode(name);
        mode.is_some_and(|mode| mode.shares.is_coupled(name.family))
    }

    /// The modes that share the motion which a name states; none if only one mode has it.
    pub(crate) fn shared(&self, name: ModeName) -> Option<SharedMotion> {
        let all = self
            .modes
            .iter()
            .map(|mode| (mode.name, &mode.shares, mode.hz));
        SharedMotion::of(name, all)
    }

    /// The mode with a name, if it is in the list.
    pub(crate) fn mode(&self, name: ModeName) -> Option<&NamedFrequency> {
        self.modes.iter().find(|mode| mode.name == name)
    }
}

/// The number of modes of the next attempt to find a missing mode: 2 more at first, later up to
/// twice as many.
fn more_than(modes: usize) -> usize {
    (modes + 2).max(2 * modes.saturating_sub(4))
}
