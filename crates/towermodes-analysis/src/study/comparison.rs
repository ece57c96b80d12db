//! Methods compared on one tower.

use super::follow::{FollowedMode, followed, not_found, solve_for};
use towermodes::Method;
use towermodes::Warning;
use towermodes::tower::Tower;
use towermodes::{Options, Solution, SolveError, Workspace, solve_with};

/// The method of a column of a comparison, with its number of segments.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColumnSpec {
    /// The method.
    pub method: Method,
    /// Number of segments or elements; none for the default of the method.
    pub segments: Option<usize>,
}

/// The frequencies of a tower by one method.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// The method.
    pub method: Method,
    /// Number of segments or elements used.
    pub segments: usize,
    /// Polynomial degree of the elements of the spectral beam; none for other methods.
    pub degree: Option<usize>,
    /// Degrees of freedom of the whole tower.
    pub degrees_of_freedom: usize,
    /// The frequency of each mode, Hz; none where so few segments do not have it.
    pub frequencies_hz: Vec<Option<f64>>,
}

/// Several methods compared on one tower.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The modes with the frequencies of the reference beam solution (spectral elements).
    pub modes: Vec<FollowedMode>,
    /// The methods.
    pub columns: Vec<Column>,
    /// Warnings of the reference solution (the differences to a mode that it does not resolve are
    /// not errors of the methods), and of methods that lack modes.
    pub warnings: Vec<Warning>,
}

impl Comparison {
    /// The relative difference f/f_reference − 1 of a frequency of a column, for a mode by its index
    /// from 0; 0 if both frequencies are 0.
    pub fn relative_difference(&self, column: &Column, mode: usize) -> Option<f64> {
        self.modes[mode].relative_difference(column.frequencies_hz[mode])
    }
}

/// Solves a tower by several methods for the lowest modes of the reference beam solution.
///
/// `options` apply to all methods: the number of modes, rotary inertia, the place of hinges. `done`
/// is called with each column and the options that solved it.
///
/// # Errors
/// [`SolveError`] of the first method that cannot solve the tower.
///
/// # Example
/// See the [crate's front page](crate).
pub fn compare(
    tower: &Tower,
    options: &Options,
    columns: &[ColumnSpec],
    done: impl FnMut(&Column, &Options),
) -> Result<Comparison, SolveError> {
    compare_with(tower, options, columns, &mut Workspace::default(), done)
}

/// Segments, or elements, of each method in a comparison of all methods unless told.
pub const COMPARED_SEGMENTS: usize = 60;

/// A column for every method with the same number of segments or elements; the spectral beam has
/// its own number.
pub fn all_methods(segments: usize) -> Vec<ColumnSpec> {
    let column = |method| ColumnSpec {
        method,
        segments: (method != Method::Spectral).then_some(segments),
    };
    Method::ALL.into_iter().map(column).collect()
}

/// Compares [all methods](all_methods). Borders of elements in the options do not apply: each
/// method chooses its own.
///
/// # Errors
/// As [`compare`].
pub fn compare_all_methods(
    tower: &Tower,
    options: &Options,
    segments: usize,
    workspace: &mut Workspace,
    done: impl FnMut(&Column, &Options),
) -> Result<Comparison, SolveError> {
    let options = Options {
        borders_m: None,
        ..options.clone()
    };
    compare_with(tower, &options, &all_methods(segments), workspace, done)
}

/// [`compare`] with a workspace, which may report progress.
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

/// The column of a solution.
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
