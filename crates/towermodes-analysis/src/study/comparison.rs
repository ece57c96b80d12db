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
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Column {
    /// The method.
    pub method: Method,
    /// Number of segments or elements used.
    pub segments: usize,
    /// Polynomial degree of the elements of the spectral beam; none for other methods.
    pub degree: Option<usize>,
    /// Degrees of freedom of the whole tower.
    pub degrees_of_freedom: usize,
    /// The time of one solve, s; none until the caller of [`compare`] sets it.
    pub seconds_per_solve: Option<f64>,
    /// The frequency of each mode, Hz; none where so few segments do not have it.
    pub frequencies_hz: Vec<Option<f64>>,
    /// The relative difference f/f_reference − 1 of each mode; 0 if both frequencies are 0.
    pub relative_differences: Vec<Option<f64>>,
}

/// Several methods compared on one tower.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Comparison {
    /// The modes with the frequencies of the reference beam solution (spectral elements).
    pub modes: Vec<FollowedMode>,
    /// The methods.
    #[cfg_attr(feature = "serde", serde(rename = "methods"))]
    pub columns: Vec<Column>,
    /// Warnings of the reference solution (the differences to a mode that it does not resolve are
    /// not errors of the methods), and of methods that lack modes.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub warnings: Vec<Warning>,
}

/// Solves a tower by several methods for the lowest modes of the reference beam solution.
///
/// `options` apply to all methods: the number of modes, rotary inertia, the place of hinges. `done`
/// is called with each column and the options that solved it, and may time it.
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
    done: impl FnMut(&mut Column, &Options),
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
    done: impl FnMut(&mut Column, &Options),
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
    mut done: impl FnMut(&mut Column, &Options),
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
        let mut column = column(&solution, &comparison.modes);
        comparison
            .warnings
            .extend(not_found(&comparison.modes, &solution));
        let modes = solution.modes.len();
        done(&mut column, &Options { modes, ..options });
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
        seconds_per_solve: None,
        frequencies_hz: modes.iter().map(frequency).collect(),
        relative_differences: modes
            .iter()
            .map(|mode| mode.relative_difference(frequency(mode)))
            .collect(),
    }
}
