//! The program.

use std::ffi::OsString;

use pyo3::prelude::*;

use crate::lock::released;

/// Runs the program with the words of a command line, the first of which is the name of the
/// program; returns the exit code.
#[pyfunction]
#[pyo3(signature = (words: "list[str]") -> "int")]
pub fn run(py: Python<'_>, words: Vec<OsString>) -> u8 {
    released(py, || towermodes_cli::run(words))
}
