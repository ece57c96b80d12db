//! Several methods side by side.

use super::follow::{FollowedMode, followed, solve_for};
use crate::Warning;
use crate::method::Method;
use crate::solve::{Options, SolveError, Workspace, solve_with};
use crate::tower::Tower;

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
    /// What the spectral beam warns of: a mode that it does not resolve is no measure for the others.
    pub warnings: Vec<Warning>,
}

impl Comparison {
    /// Relative difference of a column's frequency to that of the spectral beam, f/f_spectral − 1; 0 where both are.
    pub fn relative_difference(&self, column: &Column, mode: usize) -> Option<f64> {
        self.modes[mode].relative_difference(column.frequencies_hz[mode])
    }
}

/// Solves a tower by several methods for the lowest modes of the spectral beam.
///
/// `options` holds for all: the number of modes, rotary inertia, the place of hinges. Each solved column is told to `done`, with the
/// options that solved it.
///
/// # Errors
/// [`SolveError`] of the first method that cannot solve it.
pub fn compare(
    tower: &Tower,
    options: &Options,
    columns: &[ColumnSpec],
    mut done: impl FnMut(&Column, &Options),
) -> Result<Comparison, SolveError> {
    let mut workspace = Workspace::default();
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
    let truth = solve_with(tower, &spectral, &mut workspace)?;
    let mut comparison = Comparison {
        modes: followed(tower, &truth),
        columns: Vec::with_capacity(columns.len()),
        warnings: truth.warnings,
    };
    for spec in columns {
        let options = with(spec);
        let (column, modes) = column(tower, &options, &comparison.modes, &mut workspace)?;
        done(&column, &Options { modes, ..options });
        comparison.columns.push(column);
    }
    Ok(comparison)
}

/// A column, and how many modes had to be found for it.
fn column(
    tower: &Tower,
    options: &Options,
    modes: &[FollowedMode],
    workspace: &mut Workspace,
) -> Result<(Column, usize), SolveError> {
    let solution = solve_for(tower, options, modes, workspace)?;
    let frequency = |mode: &FollowedMode| mode.frequency_in(&solution);
    let column = Column {
        method: options.method,
        segments: solution.segments,
        degree: solution.degree,
        degrees_of_freedom: solution.degrees_of_freedom,
        frequencies_hz: modes.iter().map(frequency).collect(),
    };
    Ok((column, solution.modes.len()))
}
