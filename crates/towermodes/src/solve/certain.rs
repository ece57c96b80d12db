//! As many of the modes requested as double precision resolves.

use super::error::SolveError;
use super::options::Options;
use super::solution::Solution;
use super::tower::solve_with;
use super::workspace::Workspace;
use crate::eigen::EigenError;
use crate::tower::Tower;
use crate::tower::Warning;

/// [`solve_with`], but if the stiffest of the modes requested are not resolvable in double
/// precision, only the lower ones that are, with a [`Warning::OnlyCertain`]. For instance, a tower
/// with hardly any mass has four bending modes, those of the RNA on it, and the next ones far
/// above.
///
/// The certificate is that of the modes listed.
///
/// # Errors
/// As [`solve_with`] for any other reason, or if not even one mode is resolvable.
///
/// # Example
/// See [`solve`](crate::solve()), which has the same arguments but for the workspace.
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
