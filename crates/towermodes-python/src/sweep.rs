//! Many towers solved at once.

use std::num::NonZero;
use std::ops::ControlFlow;
use std::thread::available_parallelism;
use std::time::Instant;

use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use towermodes::{Change, ModeName};
use towermodes_files::{SweepModes, SweepResults};
use towermodes_sweep::{
    Base, Columns, FailedRows, Results, RowSource, RunError, Sweep, SweepError, run,
};

use crate::error::{of_solve, of_tower, usage};
use crate::interrupt::BETWEEN_REPORTS;
use crate::lock::{attached, released};
use crate::options::method_named;
use crate::tower::Tower;

/// How the towers are solved, and the modes that have columns.
#[derive(Clone, FromPyObject, IntoPyObject)]
#[pyo3(from_item_all)]
pub struct SweepOptions {
    modes: Option<usize>,
    names: Vec<String>,
    segments: Option<usize>,
    method: Option<String>,
    rotary_inertia: bool,
    threads: Option<usize>,
}

impl Default for SweepOptions {
    fn default() -> Self {
        Self {
            modes: None,
            names: Vec::new(),
            segments: None,
            method: None,
            rotary_inertia: true,
            threads: None,
        }
    }
}

/// Family, order and column name of each mode.
pub type Names = Vec<(&'static str, usize, String)>;

/// The rows that failed; the end of the message of each row in the text of all messages; this text
/// in UTF-8.
type Failed<'py> = (
    Bound<'py, PyArray1<u64>>,
    Bound<'py, PyArray1<u64>>,
    Bound<'py, PyArray1<u8>>,
);

/// Number of rows with remarks, and the first remarks.
type Remarks = (u64, Vec<(u64, String)>);

/// Modes, frequencies, errors and shares (rows, modes), masses, certificates, failures; rows with
/// unusual input, and rows with coupled motions.
type Solved<'py> = (
    Names,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<bool>>,
    Failed<'py>,
    [Remarks; 2],
);

/// Solves the tower with the input values of each row; the rows are counted from
/// `first_row` on.
#[pyfunction]
#[pyo3(signature = (
    tower, columns: "list[tuple[str, Incomplete]]", first_row, options: "dict[str, object]", *, progress = None,
))]
pub fn sweep<'py>(
    py: Python<'py>,
    tower: &Tower,
    columns: Vec<(String, PyReadonlyArray1<'py, f64>)>,
    first_row: u64,
    options: SweepOptions,
    progress: Option<Py<PyAny>>,
) -> PyResult<Solved<'py>> {
    let input = &tower.model.input;
    let names = columns.iter().map(|(name, _)| name.as_str());
    let changes = Change::parse_all(names, &input.description);
    let changes = changes.map_err(|error| usage(error.to_string()))?;
    // The package made these arrays and shows them to nobody before the sweep ends.
    let numbers: Result<Vec<&[f64]>, _> = columns.iter().map(|(_, one)| one.as_slice()).collect();
    let columns = Columns::new(numbers?);
    let columns = columns.map_err(|error| usage(error.to_string()))?;
    let columns = columns.from_row(first_row);
    let (results, threads) = (options.over(SweepResults::default())?, options.threads());
    let solved = released(py, || {
        let sweep = Sweep::new(Base::from(input), changes, &results).map_err(refused)?;
        solve(&sweep, &columns, threads, progress.as_ref())
    })?;
    arrays(py, solved)
}

impl SweepOptions {
    /// The requested modes and the method: from these options, otherwise from the study, otherwise
    /// the defaults.
    ///
    /// # Errors
    /// `ValueError` for an unknown mode or method.
    pub fn over(&self, study: SweepResults) -> PyResult<SweepResults> {
        let name = |name: &String| name.parse::<ModeName>();
        let names: Result<Vec<ModeName>, _> = self.names.iter().map(name).collect();
        let names = names.map_err(|error| usage(error.to_string()))?;
        let method = self.method.as_deref().map(method_named).transpose()?;
        Ok(SweepResults {
            modes: match self.modes {
                Some(count) => SweepModes::Lowest(count),
                None if names.is_empty() => study.modes,
                None => SweepModes::Named(names),
            },
            segments: self.segments.or(study.segments),
            method: method.or(study.method),
            rotary_inertia: self.rotary_inertia && study.rotary_inertia,
            inputs: study.inputs,
        })
    }

    /// These options, completed with the options of a study.
    pub fn with(&self, results: &SweepResults) -> Self {
        let (modes, names) = match &results.modes {
            SweepModes::Lowest(count) => (Some(*count), Vec::new()),
            SweepModes::Named(names) => (None, names.iter().map(ModeName::to_string).collect()),
        };
        Self {
            modes,
            names,
            segments: results.segments,
            method: results.method.map(|method| method.name().to_owned()),
            rotary_inertia: results.rotary_inertia,
            threads: self.threads,
        }
    }

    fn threads(&self) -> usize {
        self.threads
            .unwrap_or_else(|| available_parallelism().map_or(1, NonZero::get))
    }
}

/// The exception for a sweep that cannot begin.
pub fn refused(error: SweepError) -> PyErr {
    match error {
        SweepError::Base(error) => of_tower(&error),
        SweepError::Unsolved(error) => of_solve(&error),
        error => usage(error.to_string()),
    }
}

/// Runs the sweep. Ctrl-C ends it, and so does an exception of the Python function that is called
/// about once a second with the number of finished rows and of all rows.
fn solve(
    sweep: &Sweep,
    columns: &Columns<'_>,
    threads: usize,
    progress: Option<&Py<PyAny>>,
) -> PyResult<Results> {
    let (mut interrupted, mut reported) = (None, Instant::now());
    let rows = columns.rows();
    let results = run(sweep, columns, threads, &mut |done| {
        if let Some(progress) = progress
            && interrupted.is_none()
            && (done == rows || reported.elapsed() >= BETWEEN_REPORTS)
        {
            reported = Instant::now();
            let called = attached(|py| progress.call1(py, (done, rows)).map(drop));
            if let Err(exception) = called {
                interrupted = Some(exception);
                return ControlFlow::Break(());
            }
        }
        look(&mut interrupted)
    });
    match (results, interrupted) {
        (_, Some(exception)) => Err(exception),
        (Ok(results), None) => Ok(results),
        (Err(error @ RunError::Memory { .. }), None) => {
            Err(PyMemoryError::new_err(error.to_string()))
        }
        (Err(error), None) => Err(usage(error.to_string())),
    }
}

/// Checks for a signal: the exception of its handler ends a sweep.
fn look(interrupted: &mut Option<PyErr>) -> ControlFlow<()> {
    match attached(|py| py.check_signals()) {
        Ok(()) => ControlFlow::Continue(()),
        Err(exception) => {
            *interrupted = Some(exception);
            ControlFlow::Break(())
        }
    }
}

/// Family, order and column of the mode with a name such as `fore-aft 1`.
#[pyfunction]
pub fn mode_named(name: &str) -> PyResult<(&'static str, usize, String)> {
    let mode: Result<ModeName, _> = name.parse();
    let mode = mode.map_err(|error| usage(error.to_string()))?;
    Ok((mode.family.name(), mode.order, mode.column()))
}

/// The names of modes.
pub fn mode_names(modes: &[ModeName]) -> Names {
    let name = |mode: &ModeName| (mode.family.name(), mode.order, mode.column());
    modes.iter().map(name).collect()
}

/// The failures without a Python object for each row, which would need more memory than the
/// results.
fn failed(py: Python<'_>, failures: FailedRows) -> Failed<'_> {
    let (rows, ends, text) = failures.into_columns();
    let [rows, ends] = [rows, ends].map(|numbers| PyArray1::from_vec(py, numbers));
    (rows, ends, PyArray1::from_vec(py, text))
}

/// The results as arrays that own their memory without a copy.
fn arrays(py: Python<'_>, results: Results) -> PyResult<Solved<'_>> {
    let shape = [results.rows(), results.modes.len()];
    Ok((
        mode_names(&results.modes),
        PyArray1::from_vec(py, results.frequency_hz).reshape(shape)?,
        PyArray1::from_vec(py, results.error_hz).reshape(shape)?,
        PyArray1::from_vec(py, results.share).reshape(shape)?,
        PyArray1::from_vec(py, results.mass_kg),
        PyArray1::from_vec(py, results.certified),
        failed(py, results.failures),
        [results.warnings, results.shared].map(|remarks| (remarks.rows, remarks.first)),
    ))
}
