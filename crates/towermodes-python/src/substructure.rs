//! The modes of a SubDyn file: a substructure without its tower.

use std::path::PathBuf;

use pyo3::prelude::*;
use towermodes::frame::{Frame, FrameOptions, FrameSolution, solve_frame};
use towermodes_cli::table;
use towermodes_files::{
    Input, Interface, ReadOptions, ResultError, SiblingFiles, SolvedSubstructure, Source,
    SubdynInput, read_source, write_substructure_csv, write_substructure_json,
};

use crate::answer::{Answer, Shown};
use crate::error::{of_read, refused, usage};
use crate::lock::released;

/// A substructure with its modes.
struct Substructure {
    input: SubdynInput,
    frame: Frame,
    solution: FrameSolution,
}

impl Substructure {
    fn solved(&self) -> SolvedSubstructure<'_> {
        SolvedSubstructure {
            name: &self.input.title,
            frame: &self.frame,
            solution: &self.solution,
        }
    }
}

impl Shown for Substructure {
    fn table(&self) -> String {
        table::substructure(&self.solved())
    }

    fn json(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        write_substructure_json(&self.solved(), &self.input.notes, out)
    }

    fn csv(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        write_substructure_csv(&self.solved(), out)
    }

    fn notes(&self) -> Vec<String> {
        self.input.notes.iter().map(ToString::to_string).collect()
    }
}

/// The lowest modes of a SubDyn file.
#[pyfunction]
#[pyo3(signature = (path: "str", modes, clamped, subdyn))]
pub fn solve_substructure(
    py: Python<'_>,
    path: PathBuf,
    modes: usize,
    clamped: bool,
    subdyn: bool,
) -> PyResult<Answer> {
    let read = || {
        let source = Source::from_path(&path)?;
        read_source(source, &SiblingFiles::of(&path), &ReadOptions::default())
    };
    let input = match released(py, read).map_err(of_read)? {
        Input::Substructure(input) => *input,
        Input::Tower(_) | Input::Blade(_) | Input::Mooring(_) => {
            return Err(usage(
                "this is no SubDyn file; towermodes.read reads files of towers",
            ));
        }
    };
    let interface = match (clamped, input.interface_joints.is_empty()) {
        (false, _) => Interface::Free,
        (true, false) => Interface::Held,
        (true, true) => {
            return Err(usage(
                "clamped holds the interface joints, but the file has none (NInterf is 0)",
            ));
        }
    };
    let frame = input.frame(interface).map_err(of_read)?;
    let options = FrameOptions {
        modes,
        recipe: subdyn.then(|| input.recipe()),
        ..FrameOptions::default()
    };
    let solution = released(py, || solve_frame(&frame, &options));
    let solution = solution.map_err(|error| refused(&error))?;
    let mut solved = Substructure {
        input,
        frame,
        solution,
    };
    let mechanism = solved.solved().mechanism();
    solved.input.notes.extend(mechanism);
    Ok(Answer::of(solved))
}
