//! Towers with computed input values: the lightest tower that a design finds within frequency
//! bands, and the tower of a calibration to measured frequencies.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use towermodes::{Change, SensitivityError, TowerDescription};
use towermodes_cli::studies::design::StudyError;
use towermodes_cli::{studies, table};
use towermodes_design::calibration::{CalibrationError, calibrate as fitted};
use towermodes_design::design::{DesignError, design as designed};
use towermodes_files::{
    ReadError, Source, read_design_study, read_measured, write_calibration_json, write_design_json,
};

use crate::error::{of_read, of_result, of_solve, of_tower, said, unsolved, usage};
use crate::interrupt::reported;
use crate::lock::released;
use crate::model::Model;
use crate::options::SolveOptions;
use crate::tower::Tower;

/// The text of a file, and its name.
#[pyfunction]
#[pyo3(signature = (path: "str"))]
pub fn source(py: Python<'_>, path: PathBuf) -> PyResult<(String, String)> {
    let source = released(py, || Source::from_path(&path));
    let source = source.map_err(|error| of_read(ReadError::from(error)))?;
    Ok((source.text, source.name))
}

/// A tower with input values from a design or a calibration.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct Found {
    json: Vec<u8>,
    table: String,
    model: Arc<Model>,
}

#[pymethods]
impl Found {
    /// The tower with the computed values.
    #[getter]
    fn tower(&self) -> Tower {
        let model = Arc::clone(&self.model);
        Tower { model }
    }

    /// The table, as the program writes it.
    fn table(&self) -> &str {
        &self.table
    }

    /// The JSON, as the program writes it.
    fn json(&self) -> String {
        String::from_utf8_lossy(&self.json).into_owned()
    }
}

/// The tower that a design computes.
#[pyfunction]
#[pyo3(signature = (tower, text, name, *, progress = None))]
pub fn design(
    py: Python<'_>,
    tower: &Tower,
    text: String,
    name: String,
    progress: Option<Py<PyAny>>,
) -> PyResult<Found> {
    let input = &tower.model.input;
    let study = read_design_study(&Source { name, text }).map_err(of_read)?;
    let problem = studies::design::problem(&study, input).map_err(|error| match error {
        StudyError::Input(error) | StudyError::Window(error) => of_read(error),
        error => usage(error.to_string()),
    })?;
    let options = studies::design::options(&study, input);
    let found = reported(py, progress, options, |solver| {
        designed(&input.description, &problem, solver)
    })?;
    let found = found.map_err(|error| {
        let located = studies::design::located(&error, &study, &input.description);
        no_design(error, located.map(|error| said(&error)))
    })?;
    let warnings = studies::design::warnings(&found);
    let document = studies::design::document(input, &problem, &found, &warnings);
    let mut json = Vec::new();
    write_design_json(&document, &mut json).map_err(|error| of_result(&error))?;
    Ok(Found {
        json,
        table: table::design(&input.description.name, &problem, &found),
        model: changed(tower, found.tower)?,
    })
}

/// The fit to measurements; `free` are the input values to be fitted instead of those of the file.
#[pyfunction]
#[pyo3(signature = (tower, text, name, free, options: "dict[str, object]", *, progress = None))]
pub fn calibrate(
    py: Python<'_>,
    tower: &Tower,
    text: String,
    name: String,
    free: Vec<String>,
    options: SolveOptions,
    progress: Option<Py<PyAny>>,
) -> PyResult<Found> {
    let input = &tower.model.input;
    let file = read_measured(&Source { name, text }).map_err(of_read)?;
    let free = free
        .iter()
        .map(|name| Change::parse(name, &input.description));
    let free: Result<Vec<Change>, _> = free.collect();
    let free = free.map_err(|error| usage(error.to_string()))?;
    let problem = studies::calibration::problem(&input.description, &file, free);
    let problem = problem.map_err(of_read)?;
    let fit = reported(py, progress, options.of(input)?, |solver| {
        fitted(&problem, solver)
    })?;
    let fit = fit.map_err(|error| {
        let located = studies::calibration::located(&error, &file);
        no_fit(error, located.map(|error| said(&error)))
    })?;
    let document = studies::calibration::document(input, &fit);
    let mut json = Vec::new();
    write_calibration_json(&document, &mut json).map_err(|error| of_result(&error))?;
    Ok(Found {
        json,
        table: table::calibration(&input.description.name, &fit),
        model: changed(tower, fit.description)?,
    })
}

/// A tower with changed input values.
fn changed(tower: &Tower, description: TowerDescription) -> PyResult<Arc<Model>> {
    let mut input = tower.model.input.clone();
    input.description = description;
    Tower::of_changed(input).map(|tower| tower.model)
}

fn no_design(error: DesignError, located: Option<String>) -> PyErr {
    let message = located.unwrap_or_else(|| error.to_string());
    match error {
        DesignError::Tower(error) => of_tower(&error),
        DesignError::Solve(error) => of_solve(&error),
        DesignError::Sensitivity(error) => no_derivatives(&error),
        DesignError::Infeasible(_) => unsolved(
            &message,
            Some("widen the named bounds of the variables, frequency bands or limits"),
        ),
        DesignError::NoDerivative { .. } | DesignError::NoCombination { .. } => {
            unsolved(&message, None)
        }
        _ => usage(message),
    }
}

fn no_fit(error: CalibrationError, located: Option<String>) -> PyErr {
    let message = located.unwrap_or_else(|| error.to_string());
    match error {
        CalibrationError::Tower(error) => of_tower(&error),
        CalibrationError::Solve(error) => of_solve(&error),
        CalibrationError::Sensitivity(error) => no_derivatives(&error),
        error if error.is_usage() => usage(message),
        _ => unsolved(&message, None),
    }
}

pub fn no_derivatives(error: &SensitivityError) -> PyErr {
    match error {
        SensitivityError::Tower(error) => of_tower(error),
        SensitivityError::Solve(error) => of_solve(error),
        error => usage(error.to_string()),
    }
}
