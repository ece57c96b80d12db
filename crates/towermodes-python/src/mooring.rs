//! The static equilibrium of the mooring lines of a MoorDyn or MAP++ file.

use std::path::PathBuf;

use pyo3::prelude::*;
use towermodes::mooring::{Mooring, MooringState};
use towermodes_cli::table;
use towermodes_files::{
    Input, MooringInput, Note, ReadOptions, ResultError, SiblingFiles, SolvedMooring, Source,
    read_source, write_mooring_csv, write_mooring_json,
};

use crate::answer::{Answer, Shown};
use crate::error::{of_read, usage};
use crate::lock::released;

/// A mooring system in static equilibrium.
struct AtRest {
    mooring: Mooring,
    state: MooringState,
    notes: Vec<Note>,
}

impl AtRest {
    fn of(input: &MooringInput) -> PyResult<Self> {
        let mooring = input.mooring().map_err(of_read)?;
        let state = input.at_rest(&mooring).map_err(of_read)?;
        let mut notes = input.notes.clone();
        notes.extend(input.warnings(&mooring, &state));
        Ok(Self {
            mooring,
            state,
            notes,
        })
    }

    fn solved(&self) -> SolvedMooring<'_> {
        SolvedMooring {
            mooring: &self.mooring,
            state: &self.state,
        }
    }
}

impl Shown for AtRest {
    fn table(&self) -> String {
        table::mooring(&self.solved())
    }

    fn json(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        write_mooring_json(&self.solved(), &self.notes, out)
    }

    fn csv(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        write_mooring_csv(&self.solved(), out)
    }

    fn notes(&self) -> Vec<String> {
        self.notes.iter().map(ToString::to_string).collect()
    }
}

/// The lines of a MoorDyn or MAP++ file at the reference position of the platform.
#[pyfunction]
#[pyo3(signature = (path: "str"))]
pub fn solve_mooring(py: Python<'_>, path: PathBuf) -> PyResult<Answer> {
    let read = || {
        let source = Source::from_path(&path)?;
        read_source(source, &SiblingFiles::of(&path), &ReadOptions::default())
    };
    match released(py, read).map_err(of_read)? {
        Input::Mooring(input) => AtRest::of(&input).map(Answer::of),
        Input::Tower(_) | Input::Blade(_) | Input::Substructure(_) => Err(usage(
            "this is no file of MoorDyn or MAP++; towermodes.read reads files of towers",
        )),
    }
}
