//! The lowest modes of a tower by name, without shapes.

use towermodes::{ModeName, Options, SolveError, Tower, Workspace, solve_with};

/// The lowest modes of one tower, in memory that is used again for the next.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Lowest {
    /// The modes by frequency.
    pub(crate) modes: Vec<NamedFrequency>,
    /// Whether the list is proved to be complete.
    pub(crate) certified: bool,
    /// Degrees of freedom, which bound the number of modes.
    degrees_of_freedom: usize,
}

/// The frequency of a mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NamedFrequency {
    pub(crate) name: ModeName,
    /// The extrapolated frequency, Hz.
    pub(crate) hz: f64,
    /// The error of the frequency without extrapolation, Hz.
    pub(crate) error_hz: f64,
}

impl Lowest {
    /// Solves a tower.
    pub(crate) fn solve(
        &mut self,
        tower: &Tower,
        options: &Options,
        workspace: &mut Workspace,
    ) -> Result<(), SolveError> {
        let solution = solve_with(tower, options, workspace)?;
        self.modes.clear();
        self.modes
            .extend(solution.modes.iter().map(|mode| NamedFrequency {
                name: ModeName {
                    family: mode.family,
                    order: mode.order,
                },
                hz: mode.extrapolated_hz,
                error_hz: mode.error_hz(),
            }));
        self.certified = solution.certificate.complete;
        self.degrees_of_freedom = solution.degrees_of_freedom;
        Ok(())
    }

    /// The mode with a name, if it is in the list.
    pub(crate) fn mode(&self, name: ModeName) -> Option<&NamedFrequency> {
        self.modes.iter().find(|mode| mode.name == name)
    }
}

/// A larger number of modes to look for a mode that is not among those found: 2 more, 4 more, twice
/// as many; none if the tower has no more or the limit is reached.
pub(crate) fn wider(modes: usize, found: &Lowest, most: usize) -> Option<usize> {
    let more = (modes + 2).max(2 * modes.saturating_sub(4));
    let more = more.min(most).min(found.degrees_of_freedom);
    (more > modes && more > found.modes.len()).then_some(more)
}
