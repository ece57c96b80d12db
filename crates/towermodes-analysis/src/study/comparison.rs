//! Methods compared on one tower.

use super::follow::{FollowedMode, compared, followed, not_found, solve_for};
use towermodes::Method;
use towermodes::Warning;
use towermodes::tower::Tower;
use towermodes::{Options, Solution, SolveError, Solver};

/// The method of a column of a comparison, with its number of segments.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColumnSpec {
    /// The method.
    pub method: Method,
    /// Number of segments or elements; none for the default of the method.
    pub segments: Option<usize>,
}

impl ColumnSpec {
    /// A column for each method and number of segments; the spectral method chooses its own
    /// elements and has one column.
    pub fn each(methods: &[Method], segments: &[usize]) -> Vec<Self> {
        let of_method = |&method: &Method| {
            let is_spectral = method == Method::Spectral;
            let count = if is_spectral { 1 } else { segments.len() };
            segments.iter().take(count).map(move |&segments| Self {
                method,
                segments: (!is_spectral).then_some(segments),
            })
        };
        methods.iter().flat_map(of_method).collect()
    }

    /// The options of the solves of this column.
    fn applied_to(self, options: &Options) -> Options {
        Options {
            method: self.method,
            segments: self.segments,
            degree: None,
            points: 2,
            ..options.clone()
        }
    }
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
    /// Polynomial degree of the elements of the method spectral; none for other methods.
    pub degree: Option<usize>,
    /// Degrees of freedom of the whole tower.
    pub degrees_of_freedom: usize,
    /// The time of one solve, s; none until the caller of [`compare`] sets it.
    pub seconds_per_solve: Option<f64>,
    /// The frequency of each mode, Hz; none if the mesh does not have this mode.
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
    /// Warnings of the reference solution (differences from a mode that it does not resolve are not
    /// errors of the methods), and of methods that lack modes.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub warnings: Vec<Warning>,
}

/// Solves a tower by several methods for the lowest modes of the reference beam solution.
///
/// The options of the solver apply to all methods: the number of modes, rotary inertia, the
/// position of hinges. `done` is called with each column and the options of its solution, and may
/// measure its time.
///
/// # Errors
/// [`SolveError`] of the first method that cannot solve the tower.
///
/// # Example
/// See the [crate's front page](crate).
pub fn compare(
    tower: &Tower,
    columns: &[ColumnSpec],
    solver: &mut Solver,
    mut done: impl FnMut(&mut Column, &Options),
) -> Result<Comparison, SolveError> {
    let spectral = ColumnSpec {
        method: Method::Spectral,
        segments: None,
    };
    let options = solver.options.clone();
    let reference = solver.with(spectral.applied_to(&options), |solver| solver.solve(tower))?;
    let modes = followed(tower, &reference);
    let mut warnings = reference.warnings;
    let mut solved = Vec::with_capacity(columns.len());
    for spec in columns {
        let options = spec.applied_to(&options);
        let solution = solve_for(tower, &options, &modes, solver)?;
        warnings.extend(not_found(&modes, &solution));
        let mut column = column(&solution, &modes);
        let modes = solution.modes.len();
        done(&mut column, &Options { modes, ..options });
        solved.push(column);
    }
    Ok(Comparison {
        modes,
        columns: solved,
        warnings,
    })
}

/// The default number of segments or elements in a comparison of all methods.
pub const COMPARED_SEGMENTS: usize = 60;

/// A column for every method with the same number of segments or elements; the method
/// spectral chooses its own number.
pub fn all_methods(segments: usize) -> Vec<ColumnSpec> {
    ColumnSpec::each(&Method::ALL, &[segments])
}

/// Compares [all methods](all_methods). Element boundaries in the options are ignored: each method
/// chooses its own.
///
/// # Errors
/// As [`compare`].
pub fn compare_all_methods(
    tower: &Tower,
    segments: usize,
    solver: &mut Solver,
    done: impl FnMut(&mut Column, &Options),
) -> Result<Comparison, SolveError> {
    let options = Options {
        borders_m: None,
        ..solver.options.clone()
    };
    solver.with(options, |solver| {
        compare(tower, &all_methods(segments), solver, done)
    })
}

/// The column of a solution.
fn column(solution: &Solution, modes: &[FollowedMode]) -> Column {
    let (frequencies_hz, relative_differences) = compared(modes, solution);
    Column {
        method: solution.method,
        segments: solution.segments,
        degree: solution.degree,
        degrees_of_freedom: solution.degrees_of_freedom,
        seconds_per_solve: None,
        frequencies_hz,
        relative_differences,
    }
}
