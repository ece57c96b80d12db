//! Solves with more and more modes until a condition holds.

use super::error::SolveError;
use super::options::Options;
use super::solution::Solution;
use super::tower::solve_with;
use super::workspace::Workspace;
use crate::tower::Tower;

/// Solves for the modes requested and then for twice as many, until `has_all` holds or the tower
/// has no more modes. The shapes have two points.
///
/// # Errors
/// [`SolveError`]; asking for more modes than there are is no error here.
pub fn solve_until(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
    has_all: impl Fn(&Solution) -> bool,
) -> Result<Solution, SolveError> {
    let mut options = Options {
        points: 2,
        ..options.clone()
    };
    let mut there_are_no_more = false;
    loop {
        let solution = match solve_with(tower, &options, workspace) {
            // Another mesh or degree of the same solve may have fewer still.
            Err(SolveError::TooManyModes { available, .. })
                if (1..options.modes).contains(&available) =>
            {
                options.modes = available;
                there_are_no_more = true;
                continue;
            }
            result => result?,
        };
        if there_are_no_more || has_all(&solution) {
            return Ok(solution);
        }
        options.modes *= 2;
    }
}
