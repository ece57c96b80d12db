//! As many of the modes asked for as can be told from rounding.

use super::error::SolveError;
use super::options::Options;
use super::solution::Solution;
use super::tower::solve_with;
use super::workspace::Workspace;
use crate::Warning;
use crate::eigen::EigenError;
use crate::tower::Tower;

/// [`solve_with`], but where rounding hides the stiffest of the modes asked for, the lower ones
/// that it does not hide, as many as there are, with a [`Warning::OnlyCertain`]. A tower with
/// hardly any mass has four bending modes, those of the machine on it, and the next ones far above.
///
/// The certificate is that of the modes listed.
///
/// # Errors
/// As [`solve_with`], for reasons other than that, or if not even one mode is certain.
pub fn solve_certain(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Solution, SolveError> {
    let (mut hidden, mut listed) = (options.modes, 0);
    let mut result = solve_with(tower, options, workspace);
    let mut certain = None;
    while is_hidden(&result) && hidden - listed > 1 {
        let modes = listed + (hidden - listed) / 2;
        let fewer = Options {
            modes,
            ..options.clone()
        };
        match solve_with(tower, &fewer, workspace) {
            Ok(solution) => (listed, certain) = (modes, Some(solution)),
            Err(SolveError::Eigen(EigenError::Unresolved { .. })) => hidden = modes,
            Err(other) => return Err(other),
        }
    }
    if let Some(mut solution) = certain {
        solution.warnings.push(Warning::OnlyCertain {
            listed,
            wanted: options.modes,
        });
        result = Ok(solution);
    }
    result
}

fn is_hidden(result: &Result<Solution, SolveError>) -> bool {
    matches!(
        result,
        Err(SolveError::Eigen(EigenError::Unresolved { .. }))
    )
}
