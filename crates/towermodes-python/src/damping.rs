//! The damping of the modes of a tower.

use std::sync::Arc;

use pyo3::prelude::*;
use towermodes::{Options, Solution};
use towermodes_analysis::damping::{GivenDamping, ModalDamping, damping as damped};
use towermodes_analysis::resonance::GivenRotor;
use towermodes_cli::table;
use towermodes_files::{Note, ResultError, write_damping_csv, write_damping_json};

use crate::answer::{Answer, Shown};
use crate::error::usage;
use crate::interrupt::interruptible;
use crate::model::Model;
use crate::options::SolveOptions;
use crate::tower::Tower;

/// The damping of modes.
struct Damping {
    model: Arc<Model>,
    solution: Solution,
    damping: ModalDamping,
    notes: Vec<Note>,
}

/// Damping data that replace those of the file.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct DampingOptions {
    loss_factors: Vec<(String, f64)>,
    chord_moment_m3: Option<f64>,
    lift_slope: Option<f64>,
    air_density_kg_per_m3: Option<f64>,
    rpm: Option<(f64, f64)>,
    blades: Option<usize>,
}

impl DampingOptions {
    fn of_library(&self) -> GivenDamping {
        GivenDamping {
            loss_factors: self.loss_factors.clone(),
            chord_moment_m3: self.chord_moment_m3,
            lift_slope: self.lift_slope,
            air_density_kg_per_m3: self.air_density_kg_per_m3,
        }
    }

    fn rotor(&self) -> GivenRotor {
        GivenRotor {
            speeds_rpm: self.rpm,
            blades: self.blades,
        }
    }
}

fn solved(py: Python<'_>, model: &Model, options: Options) -> PyResult<Solution> {
    let options = Options {
        energy_parts: true,
        ..options
    };
    let solution = interruptible(py, options, |solver| solver.solve_certain(&model.tower))?;
    solution.map_err(|error| model.unsolved(&error))
}

/// The damping of the modes of a tower.
#[pyfunction]
#[pyo3(signature = (tower, given: "dict[str, object]", options: "dict[str, object]"))]
pub fn damping(
    py: Python<'_>,
    tower: &Tower,
    given: DampingOptions,
    options: SolveOptions,
) -> PyResult<Answer> {
    let model = Arc::clone(&tower.model);
    let input = &model.input;
    let mut description = input.description.clone();
    let set = given.of_library().set(&mut description);
    set.map_err(|error| usage(error.to_string()))?;
    let chosen = given.rotor();
    let chosen = chosen.in_place_of(description.rotor, input.blades);
    let chosen = chosen.filter(|_| description.damping.rotor.is_some());
    if let Some(chosen) = &chosen {
        let checked = chosen.rotor.validate();
        checked.map_err(|error| usage(error.to_string()))?;
    }
    let solution = solved(py, &model, options.of(input)?)?;
    let rotor = chosen.as_ref().map(|chosen| &chosen.rotor);
    let damping = damped(&description, &solution, rotor);
    let damping = damping.map_err(|error| usage(error.to_string()))?;
    let remarks = damping.remarks.iter();
    let notes = remarks.map(|remark| Note::new(remark.to_string()));
    Ok(Answer::of(Damping {
        notes: notes.collect(),
        model,
        solution,
        damping,
    }))
}

impl Shown for Damping {
    fn table(&self) -> String {
        table::damping(&self.model.tower, &self.damping)
    }

    fn json(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        let notes = [self.model.input.notes.as_slice(), &self.notes].concat();
        write_damping_json(self.model.tower.name(), &self.damping, &notes, out)
    }

    fn csv(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        write_damping_csv(&self.damping, out)
    }

    fn notes(&self) -> Vec<String> {
        self.model.notes_with(&self.notes)
    }

    fn warnings(&self) -> Vec<String> {
        self.model.located(&self.solution.warnings)
    }
}
