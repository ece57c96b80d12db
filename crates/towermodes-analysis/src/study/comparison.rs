//! Several methods side by side.

use super::follow::{FollowedMode, followed, not_found, solve_for};
use towermodes::Method;
use towermodes::Warning;
use towermodes::tower::Tower;
use towermodes::{Options, Solution, SolveError, Workspace, solve_with};

/// A method with its segments: what a column of a comparison is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColumnSpec {
    /// The method.
    pub method: Method,
    /// Number of segments or elements; `None` is the method's own choice.
    pub segments: Option<usize>,
}

/// What one method makes of the tower.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// The method.
    pub method: Method,
    /// Number of segments or elements used.
    pub segments: usize,
    /// Polynomial degree, if it is the spectral beam.
    pub degree: Option<usize>,
    /// Degrees of freedom of the whole tower.
    pub degrees_of_freedom: usize,
    /// The frequency of each followed mode, Hz; none where so few segments do not have it.
    pub frequencies_hz: Vec<Option<f64>>,
}

/// Several methods side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The modes, one a row, with the frequencies of the spectral beam.
    pub modes: Vec<FollowedMode>,
    /// The methods.
    pub columns: Vec<Column>,
    /// What the spectral beam warns of: a mode that it does not resolve is no measure for the
    /// others; and methods that lack modes.
    pub warnings: Vec<Warning>,
}

impl Comparison {
    /// Relative difference of a column's frequency to that of the spectral beam, f/f_spectral − 1;
    /// 0 where both are.
    pub fn relative_difference(&self, column: &Column, mode: usize) -> Option<f64> {
        self.modes[mode].relative_difference(column.frequencies_hz[mode])
    }
}

/// Solves a tower by several methods for the lowest modes of the spectral beam.
///
/// `options` holds for all: the number of modes, rotary inertia, the place of hinges. Each solved
/// column is told to `done`, with the options that solved it.
///
/// # Errors
/// [`SolveError`] of the first method that cannot solve it.
pub fn compare(
    tower: &Tower,
    options: &Options,
    columns: &[ColumnSpec],
    done: impl FnMut(&Column, &Options),
) -> Result<Comparison, SolveError> {
    compare_with(tower, options, columns, &mut Workspace::default(), done)
}

/// [`compare`] in memory that may be watched.
///
/// # Errors
/// As [`compare`].
pub fn compare_with(
    tower: &Tower,
    options: &Options,
    columns: &[ColumnSpec],
    workspace: &mut Workspace,
    mut done: impl FnMut(&Column, &Options),
) -> Result<Comparison, SolveError> {
    let with = |spec: &ColumnSpec| Options {
        method: spec.method,
        segments: spec.segments,
        degree: None,
        points: 2,
        ..options.clone()
    };
    let spectral = with(&ColumnSpec {
        method: Method::Spectral,
        segments: None,
    });
    let truth = solve_with(tower, &spectral, workspace)?;
    let mut comparison = Comparison {
        modes: followed(tower, &truth),
        columns: Vec::with_capacity(columns.len()),
        warnings: truth.warnings,
    };
    for spec in columns {
        let options = with(spec);
        let solution = solve_for(tower, &options, &comparison.modes, workspace)?;
        let column = column(&solution, &comparison.modes);
        comparison
            .warnings
            .extend(not_found(&comparison.modes, &solution));
        let modes = solution.modes.len();
        done(&column, &Options { modes, ..options });
        comparison.columns.push(column);
    }
    Ok(comparison)
}

/// What a solution has of the modes that are compared.
fn column(solution: &Solution, modes: &[FollowedMode]) -> Column {
    let frequency = |mode: &FollowedMode| mode.frequency_in(solution);
    Column {
        method: solution.method,
        segments: solution.segments,
        degree: solution.degree,
        degrees_of_freedom: solution.degrees_of_freedom,
        frequencies_hz: modes.iter().map(frequency).collect(),
    }
}
