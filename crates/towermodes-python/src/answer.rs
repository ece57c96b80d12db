//! Results in the forms of the program: a table, JSON, CSV, a picture, sentences.

use pyo3::prelude::*;
use towermodes_files::ResultError;

use crate::error::of_result;

/// A result of the library with its notes and warnings.
pub trait Shown: Send + Sync + 'static {
    /// The table, as the program writes it.
    fn table(&self) -> String;

    /// The JSON, as the program writes it.
    fn json(&self, out: &mut Vec<u8>) -> Result<(), ResultError>;

    /// The CSV, as the program writes it; nothing if there is none.
    fn csv(&self, _out: &mut Vec<u8>) -> Result<(), ResultError> {
        Ok(())
    }

    /// The picture as SVG; nothing if there is none.
    fn svg(&self) -> String {
        String::new()
    }

    /// Notes of the reader and on the computation.
    fn notes(&self) -> Vec<String> {
        Vec::new()
    }

    /// Possible mistakes of the input, and limits of the results.
    fn warnings(&self) -> Vec<String> {
        Vec::new()
    }

    /// The worst verdict: `pass`, `warn`, `fail`, or `undecided` if nothing is checked.
    fn verdict(&self) -> &'static str {
        ""
    }

    /// Why nothing is checked; empty if the distances are checked.
    fn not_checked(&self) -> Vec<String> {
        Vec::new()
    }

    /// The conclusion in sentences.
    fn conclusion(&self) -> Vec<String> {
        Vec::new()
    }
}

/// A result in the forms of the program.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct Answer(Box<dyn Shown>);

impl Answer {
    pub fn of(result: impl Shown) -> Self {
        Self(Box::new(result))
    }
}

#[pymethods]
impl Answer {
    /// The table, as the program writes it.
    pub fn table(&self) -> String {
        self.0.table()
    }

    /// The JSON, as the program writes it.
    pub fn json(&self) -> PyResult<String> {
        text(|out| self.0.json(out))
    }

    /// The CSV, as the program writes it; nothing if there is none.
    pub fn csv(&self) -> PyResult<String> {
        text(|out| self.0.csv(out))
    }

    /// The picture as SVG; nothing if there is none.
    pub fn svg(&self) -> String {
        self.0.svg()
    }

    /// Notes of the reader and on the computation.
    #[getter]
    pub fn notes(&self) -> Vec<String> {
        self.0.notes()
    }

    /// Possible mistakes of the input, and limits of the results.
    #[getter]
    pub fn warnings(&self) -> Vec<String> {
        self.0.warnings()
    }

    /// The worst verdict: `pass`, `warn`, `fail`, or `undecided` if nothing is checked.
    #[getter]
    pub fn verdict(&self) -> &'static str {
        self.0.verdict()
    }

    /// Why nothing is checked; empty if the distances are checked.
    #[getter]
    pub fn not_checked(&self) -> Vec<String> {
        self.0.not_checked()
    }

    /// The conclusion in sentences.
    #[getter]
    pub fn conclusion(&self) -> Vec<String> {
        self.0.conclusion()
    }
}

/// The output of a writer, as text.
///
/// # Errors
/// The result cannot be written.
pub fn text(write: impl FnOnce(&mut Vec<u8>) -> Result<(), ResultError>) -> PyResult<String> {
    let mut out = Vec::new();
    write(&mut out).map_err(|error| of_result(&error))?;
    Ok(String::from_utf8_lossy(&out).into_owned())
}
