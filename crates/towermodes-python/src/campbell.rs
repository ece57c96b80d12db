//! Resonance margins of a tower.

use std::sync::Arc;

use pyo3::prelude::*;
use towermodes::{Solution, SolveError};
use towermodes_analysis::resonance::{
    Campbell as Diagram, CampbellOptions, ChosenRotor, GivenRotor, assess, reach_hz,
    solve_to_reach, verdicts_without,
};
use towermodes_cli::table;
use towermodes_files::{Note, ResultError, TowerInput, write_campbell_csv, write_campbell_json};
use towermodes_report::figures;
use towermodes_report::wording::computed_by;

use crate::answer::{Answer, Shown};
use crate::error::of_campbell;
use crate::interrupt::interruptible;
use crate::lock::released;
use crate::model::Model;
use crate::options::SolveOptions;
use crate::tower::Tower;

/// A Campbell diagram.
struct Campbell {
    model: Arc<Model>,
    solution: Solution,
    diagram: Diagram,
    notes: Vec<Note>,
}

/// Rotor data that replace those of the file, and the margin.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct RotorOptions {
    /// Lowest and highest operating speed.
    pub rpm: Option<(f64, f64)>,
    /// Number of blades.
    pub blades: Option<usize>,
    multiples: Vec<usize>,
    margin: f64,
}

impl RotorOptions {
    /// The rotor: the given data, and data of the file for those that are not given. Without
    /// operating speeds they are the ends of the diagram, computed for the tower with a rigid
    /// rotor.
    pub fn rotor<E>(
        &self,
        input: &TowerInput,
        solve: impl FnOnce() -> Result<Solution, E>,
    ) -> Result<ChosenRotor, E> {
        let given = GivenRotor {
            speeds_rpm: self.rpm,
            blades: self.blades,
        };
        match given.in_place_of(input.description.rotor, input.blades) {
            Some(chosen) => Ok(chosen),
            None => Ok(given.without_speeds(input.blades, &solve()?, input.tip_radius_m())),
        }
    }

    /// The options of the library.
    pub fn of_library(&self) -> CampbellOptions {
        CampbellOptions {
            margin: self.margin,
            multiples: self.multiples.clone(),
            ..CampbellOptions::default()
        }
    }
}

/// The notes of the reader on rotor data that are used, and on those that are assumed.
fn notes_on(input: &TowerInput, chosen: &ChosenRotor) -> Vec<Note> {
    let of_reader = &input.rotor_notes;
    let speeds = of_reader.speeds.iter().filter(|_| !chosen.speeds_are_given);
    let blades = of_reader.blades.iter().filter(|_| !chosen.blades_are_given);
    let assumed = chosen.blades_are_assumed.then(|| {
        let blades = chosen.rotor.blades;
        Note::assumption(format!(
            "the number of blades is not given; {blades} are assumed; blades= sets another number"
        ))
    });
    let notes = speeds.chain(blades).chain(&of_reader.others).cloned();
    notes.chain(assumed).collect()
}

/// The diagram of a tower.
#[pyfunction]
#[pyo3(signature = (tower, rotor: "dict[str, object]", options: "dict[str, object]"))]
pub fn campbell(
    py: Python<'_>,
    tower: &Tower,
    rotor: RotorOptions,
    options: SolveOptions,
) -> PyResult<Answer> {
    let model = Arc::clone(&tower.model);
    let Model { tower, input } = &*model;
    let mut limits = rotor.of_library();
    let solved = interruptible(py, options.of(input)?, |solver| {
        let chosen = rotor.rotor(input, || solver.solve_certain(tower))?;
        let solution = match options.has_modes() {
            true => solver.solve_certain(tower),
            false => solve_to_reach(solver, tower, reach_hz(&chosen.rotor, &limits)),
        };
        Ok::<_, SolveError>((solution?, chosen))
    })?;
    let (solution, chosen) = solved.map_err(|error| model.unsolved(&error))?;
    limits.speeds_are_known = chosen.speeds_are_known;
    let blade = input.blade.as_ref();
    let assessed = released(py, || {
        assess(tower, &solution, blade, &chosen.rotor, &limits)
    });
    let assessed = assessed.map_err(|error| of_campbell(&error))?;
    let mut notes = notes_on(input, &chosen);
    notes.extend(
        assessed
            .remarks
            .iter()
            .map(|remark| Note::new(remark.to_string())),
    );
    let without = released(py, || verdicts_without(tower, &assessed.campbell, false));
    notes.extend(without.into_iter().map(Note::suspicious));
    Ok(Answer::of(Campbell {
        model,
        solution,
        diagram: assessed.campbell,
        notes,
    }))
}

impl Shown for Campbell {
    fn table(&self) -> String {
        let has_blade = self.model.input.blade.is_some();
        let diagram = (&self.diagram, self.solution.modes.as_slice());
        table::campbell(&self.model.tower, diagram, has_blade, false)
    }

    fn json(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        let notes = [self.model.input.notes.as_slice(), &self.notes].concat();
        let (tower, warnings) = (&self.model.tower, &self.solution.warnings);
        write_campbell_json(tower, &self.diagram, None, &notes, warnings, out)
    }

    fn csv(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        write_campbell_csv(&self.diagram, out)
    }

    fn svg(&self) -> String {
        let (computed, conclusion) = (computed_by(&self.solution), self.diagram.conclusion());
        let figure = figures::campbell(&self.diagram);
        self.model.titled(figure, Some(&computed), &conclusion)
    }

    fn notes(&self) -> Vec<String> {
        self.model.notes_with(&self.notes)
    }

    fn warnings(&self) -> Vec<String> {
        self.model.located(&self.solution.warnings)
    }

    fn verdict(&self) -> &'static str {
        self.diagram.verdict().name()
    }

    fn not_checked(&self) -> Vec<String> {
        let reasons = self.diagram.not_checked.iter();
        reasons.map(ToString::to_string).collect()
    }

    fn conclusion(&self) -> Vec<String> {
        self.diagram.conclusion()
    }
}
