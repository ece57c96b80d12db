//! Towers from texts in any format.

use std::path::Path;

use pyo3::prelude::*;
use towermodes_files::{Input, ReadOptions, SiblingFiles, Source, TowerInput, read_source};

use crate::error::{of_read, usage};

/// The input of a text.
///
/// # Errors
/// `TowerError` with the mistakes of the text.
pub fn input_of_text(text: String, name: String) -> PyResult<TowerInput> {
    let source = Source { name, text };
    let files = SiblingFiles::of(Path::new(""));
    let input = read_source(source, &files, &ReadOptions::default());
    tower_input(input.map_err(of_read)?)
}

/// The tower of a file that may describe a blade.
///
/// # Errors
/// `ValueError` for a blade.
pub fn tower_input(input: Input) -> PyResult<TowerInput> {
    match input {
        Input::Tower(input) => Ok(*input),
        Input::Substructure(_) => Err(usage(
            "this is a SubDyn file, a substructure without a tower; solve_substructure solves it",
        )),
        Input::Mooring(_) => Err(usage(
            "this file describes mooring lines without a tower; solve_mooring solves it",
        )),
        Input::Blade(_) => Err(usage(
            "this is a deck of a rotating blade, not of a tower; the program solves it: towermodes solve FILE",
        )),
    }
}
