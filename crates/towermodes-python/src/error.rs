//! Errors of the library as Python exceptions; the classes are in `python/towermodes/_errors.py`.

use std::io;

use pyo3::exceptions::{PyFileNotFoundError, PyIsADirectoryError, PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;
use towermodes::turbine::TurbineError;
use towermodes::{EigenError, Parameter, SolveError, TowerError};
use towermodes_analysis::agreement::AgreementError;
use towermodes_analysis::elastodyn::{MakeError, ShapesError};
use towermodes_analysis::resonance::CampbellError;
use towermodes_analysis::whirl::CoupledError;
use towermodes_files::{
    ConvertError, Diagnostic, FileError, ReadError, ResultError, Source, TowerInput, entry_at,
};
use towermodes_report::wording::remedy;
use towermodes_sweep::{Remedy, SliceError, TableError, TableProblem, number_at};

use crate::lock::attached;

/// The module that defines the exceptions.
const MODULE: &str = "towermodes._errors";

/// ENOENT and EISDIR, which are the same on all systems.
const NO_ENTRY: i32 = 2;
const IS_DIRECTORY: i32 = 21;

/// A mistake as Python receives it: line, column, message, hint.
type Mistake = (Option<usize>, Option<usize>, String, Option<String>);

/// The name of a text that the package has generated itself: its line numbers are of no use to the
/// user.
pub const MADE_HERE: &str = "<description>";

fn class<'py>(
    py: Python<'py>,
    cell: &'static PyOnceLock<Py<PyType>>,
    name: &str,
) -> PyResult<&'py Bound<'py, PyType>> {
    cell.import(py, MODULE, name)
}

/// An exception of a class with its arguments, or the reason why it cannot be made.
fn raised<'py, A>(class: PyResult<&Bound<'py, PyType>>, arguments: A) -> PyErr
where
    A: pyo3::call::PyCallArgs<'py>,
{
    match class.and_then(|class| class.call1(arguments)) {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}

fn tower_error(message: &str, path: Option<&str>, hint: Option<&str>, list: Vec<Mistake>) -> PyErr {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    attached(|py| {
        let class = class(py, &CLASS, "TowerError");
        raised(class, (message, path, hint, list))
    })
}

/// The exception for a file without a valid tower.
pub fn of_read(error: ReadError) -> PyErr {
    match error {
        ReadError::Unreadable(error) => of_file(error),
        ReadError::Mistakes {
            ref source_file,
            ref mistakes,
        } => {
            let own = |mistake: &Diagnostic| located(source_file, mistake);
            let list: Vec<Mistake> = mistakes.iter().map(own).collect();
            let hint = list.first().and_then(|first| first.3.clone());
            // Text in memory has no path.
            let path = Some(source_file.name.as_str()).filter(|name| !name.starts_with('<'));
            let message = said(&error);
            tower_error(&message, path, hint.as_deref(), list)
        }
    }
}

/// The text of an error. For a mistake in a dict it states the name of the entry instead of line
/// and column.
pub fn said(error: &ReadError) -> String {
    match error {
        ReadError::Mistakes {
            source_file,
            mistakes,
        } if source_file.name == MADE_HERE => {
            let own = |mistake: &Diagnostic| of_entry(mistake, &source_file.text);
            let sentences: Vec<String> = mistakes.iter().map(own).collect();
            sentences.join("\n")
        }
        error => error.to_string(),
    }
}

/// A mistake with the name of its entry, for example `rna.inertia.zz: ...`. The keys of the table
/// `[tower]` are separate arguments.
fn of_entry(mistake: &Diagnostic, text: &str) -> String {
    match entry_at(text, mistake.span.start) {
        Some(entry) => {
            let entry = entry.strip_prefix("tower.").unwrap_or(&entry);
            format!("{entry}: {mistake}")
        }
        None => mistake.to_string(),
    }
}

fn located(source: &Source, mistake: &Diagnostic) -> Mistake {
    let place = mistake.line_and_column(&source.text);
    let (line, column) = match source.name.as_str() {
        MADE_HERE => (None, None),
        _ => (Some(place.0), Some(place.1)),
    };
    (line, column, mistake.message(), mistake.hint.clone())
}

fn of_file(error: FileError) -> PyErr {
    let message = error.to_string();
    match error {
        FileError::Missing { name } => {
            PyFileNotFoundError::new_err((NO_ENTRY, "no such file", name))
        }
        FileError::Directory { name } => {
            PyIsADirectoryError::new_err((IS_DIRECTORY, "is a directory, not a file", name))
        }
        FileError::System { error, name } => of_system(&error, &name, &message),
        FileError::Special { name, .. }
        | FileError::TooLarge { name }
        | FileError::Pointer { name, .. }
        | FileError::WebPage { name }
        | FileError::Workbook { name }
        | FileError::NotText { name, .. } => tower_error(&message, Some(&name), None, Vec::new()),
        _ => PyOSError::new_err(message),
    }
}

/// The exception for an error of the operating system on a file; Python chooses the class of the
/// exception by the error number.
fn of_system(error: &io::Error, file: &str, otherwise: &str) -> PyErr {
    let Some(number) = error.raw_os_error() else {
        return PyOSError::new_err(otherwise.to_owned());
    };
    // The exception has the number itself.
    let text = error.to_string();
    let text = text.strip_suffix(&format!(" (os error {number})"));
    let text = text.map_or_else(|| error.to_string(), str::to_owned);
    PyOSError::new_err((number, text, file.to_owned()))
}

/// The exception for a table with mistakes, or for rows that the table does not have.
pub fn of_slice(error: SliceError) -> PyErr {
    let message = match error.remedy().map(argument_for) {
        Some(remedy) => format!("{error}; {remedy}"),
        None => error.to_string(),
    };
    match &error {
        SliceError::Table(TableError { name, problem }) => match &**problem {
            TableProblem::Io(error) => of_system(error, name, &message),
            _ => usage(message),
        },
        _ => usage(message),
    }
}

/// The argument of `sweep` that corresponds to a remedy.
fn argument_for(remedy: Remedy) -> String {
    match remedy {
        Remedy::IgnoreColumn { name } => {
            format!("skip the column by ignore=[{name:?}], or write # before its name")
        }
        Remedy::Csv => "write it as CSV".to_owned(),
    }
}

/// The exception for an invalid description that is not from a file.
pub fn of_tower(error: &TowerError) -> PyErr {
    let message = format!("{}: {}", error.place, error.problem);
    tower_error(&message, None, error.hint(), Vec::new())
}

/// The error with the name of the wrong input value: `stations[13].wall`; for a missing value, with
/// the name of the entry that requires it.
pub fn of_numbers(error: &TowerError, input: &TowerInput) -> PyErr {
    let numbers = Parameter::all(&input.description).into_iter();
    match (number_at(error.place, numbers), input.tower()) {
        (Some(name), _) => {
            let message = format!("{name}: {}", error.problem);
            tower_error(&message, None, error.hint(), Vec::new())
        }
        (None, Err(located)) => of_read(located),
        (None, Ok(_)) => of_tower(error),
    }
}

/// The exception for a tower that a computation or a format does not accept.
pub fn refused(error: &impl ToString) -> PyErr {
    tower_error(&error.to_string(), None, None, Vec::new())
}

/// The exception for a wrong argument.
pub fn usage(message: impl Into<String>) -> PyErr {
    PyValueError::new_err(message.into())
}

/// The exception for a tower that cannot be solved.
pub fn of_solve(error: &SolveError) -> PyErr {
    static OF_OPTIONS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let (message, hint) = (error.to_string(), hint(error));
    match error.is_usage() {
        true => attached(|py| raised(class(py, &OF_OPTIONS, "OptionError"), (message, hint))),
        false => unsolved(&message, hint),
    }
}

/// An exception with warnings as its notes, which a traceback shows, because the warnings may
/// explain the error.
pub fn explained(error: PyErr, warnings: &[String]) -> PyErr {
    attached(|py| {
        for warning in warnings {
            // Python 3.10 has no notes.
            let note = format!("warning: {warning}");
            let _ = error.value(py).call_method1("add_note", (note,));
        }
    });
    error
}

/// The exception for a turbine that cannot be solved.
pub fn of_turbine(error: &TurbineError) -> PyErr {
    match error {
        TurbineError::Limit { .. } | TurbineError::Speed { .. } => usage(error.to_string()),
        TurbineError::Tower(inner) => of_tower(inner),
        error => refused(error),
    }
}

/// The exception for a coupled diagram that cannot be computed.
pub fn of_coupled(error: &CoupledError) -> PyErr {
    match error {
        CoupledError::Options(inner) => of_campbell(inner),
        CoupledError::Turbine(inner) => of_turbine(inner),
        CoupledError::At { .. } => refused(error),
        error => usage(error.to_string()),
    }
}

/// The exception for a design or a calibration without a solution.
pub fn unsolved(message: &str, hint: Option<&str>) -> PyErr {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    attached(|py| raised(class(py, &CLASS, "SolveError"), (message, hint)))
}

/// The remedy, with arguments of Python instead of options of the command line.
fn hint(error: &SolveError) -> Option<&'static str> {
    match error {
        SolveError::TooManyModes { .. } => {
            Some("increase segments (for the method spectral: degree) or reduce modes")
        }
        SolveError::TooLarge { .. } | SolveError::TooSlow { .. } => {
            Some("reduce modes or segments, or give limits=False")
        }
        SolveError::Buckles { .. } => Some(
            "reduce the mass, increase the diameter or the wall thickness (for a substructure check supports, sections and marine growth), or leave out gravity",
        ),
        SolveError::Eigen(EigenError::TooStiff | EigenError::NotFinite) => remedy(error),
        SolveError::Eigen(_) => Some("reduce modes, or check the units of all values"),
        error => remedy(error),
    }
}

/// The exception for a Campbell diagram that cannot be computed.
pub fn of_campbell(error: &CampbellError) -> PyErr {
    match error {
        CampbellError::Blade { error: inner, .. } if !inner.is_usage() => of_solve(inner),
        CampbellError::Rotor(inner) => of_tower(inner),
        error => usage(error.to_string()),
    }
}

/// The exception for two towers that cannot be compared.
pub fn of_agreement(error: &AgreementError) -> PyErr {
    match error {
        AgreementError::Solve { error, .. } => of_solve(error),
        error => refused(error),
    }
}

/// The exception for a tower that cannot be written in a format.
pub fn of_convert(error: ConvertError) -> PyErr {
    match error {
        ConvertError::Input(error) => of_read(error),
        ConvertError::Shapes(MakeError::Shapes(ShapesError::Solve(error))) => of_solve(&error),
        error => refused(&error),
    }
}

/// The exception for a result that cannot be written.
pub fn of_result(error: &ResultError) -> PyErr {
    PyOSError::new_err(error.to_string())
}
