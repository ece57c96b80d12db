//! A tower with its input.

use towermodes::{Parameter, SolveError, Tower as CheckedTower, Warning};
use towermodes_files::{Note, TowerInput};
use towermodes_report::figures::{TitleWords, titled};
use towermodes_report::svg::{Figure, Look};
use towermodes_sweep::{named, number_at};

use crate::error::{MADE_HERE, explained, of_solve};
use crate::pickle::PICKLED;
use pyo3::prelude::*;

/// A tower and its input.
pub struct Model {
    /// The tower.
    pub tower: CheckedTower,
    /// Its description, the notes of the reader and the places of the values.
    pub input: TowerInput,
}

impl Model {
    /// The notes of the reader.
    pub fn notes(&self) -> Vec<String> {
        self.input.notes.iter().map(Note::to_string).collect()
    }

    /// The notes with the notes on a computation.
    pub fn notes_with(&self, own: &[Note]) -> Vec<String> {
        let own = own.iter().map(Note::to_string);
        self.notes().into_iter().chain(own).collect()
    }

    /// The notes of the reader on the tower and its turbine.
    pub fn notes_with_turbine(&self) -> Vec<String> {
        self.notes_with(&self.input.turbine_notes)
    }

    /// Why there is no turbine.
    pub fn missing_turbine(&self) -> String {
        let reason = self.input.turbine_missing.as_ref().map(Note::to_string);
        reason.unwrap_or_else(|| "the tower has no turbine with flexible blades".to_owned())
    }

    /// A picture with the name of the tower above it, as SVG.
    pub fn titled(&self, figure: Figure, computed: Option<&str>, conclusion: &[String]) -> String {
        let words = TitleWords {
            title: None,
            computed,
            conclusion,
        };
        titled(figure, &self.tower, &words).to_svg(Look::Standalone)
    }

    /// Warnings with file and line of the input if these are known, otherwise with the name of the
    /// input value.
    pub fn located(&self, warnings: &[Warning]) -> Vec<String> {
        let located = |warning: &Warning| {
            let line = warning.place().and_then(|place| self.input.line_of(place));
            // The lines of a text that the package made itself mean nothing to the user.
            let line = line.filter(|(file, _)| ![MADE_HERE, PICKLED].contains(file));
            match line {
                Some((file, line)) => format!("{file}:{line}: {warning}"),
                None => named(warning, |place| {
                    let numbers = Parameter::all(&self.input.description);
                    number_at(place, numbers.into_iter())
                }),
            }
        };
        warnings.iter().map(located).collect()
    }

    /// The exception if this tower cannot be solved, with the warnings on unusual input.
    pub fn unsolved(&self, error: &SolveError) -> PyErr {
        explained(of_solve(error), &self.located(self.tower.warnings()))
    }
}
