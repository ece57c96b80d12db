//! Towers whose numbers are found: the lightest within bands of frequencies, and the one that has
//! the measured frequencies.

use std::path::PathBuf;
use std::sync::Arc;

use pyo3::prelude::*;
use towermodes::{Change, SensitivityError, TowerDescription};
use towermodes_cli::studies::{calibration, design};
use towermodes_cli::table;
use towermodes_design::calibration::{Calibration as Fit, CalibrationError, calibrate};
use towermodes_design::design::{DesignError, design as designed};
use towermodes_files::{
    CalibrationDocument, DesignDocument, ReadError, Source, read_design_study, read_measured,
    write_calibration_json, write_design_json,
};

use crate::error::{MADE_HERE, of_read, of_result, of_solve, of_tower, unsolved, usage};
use crate::interrupt::interruptible;
use crate::lock::released;
use crate::options::SolveOptions;
use crate::tower::{Model, Tower};

/// The text of a file, and its name.
#[pyfunction]
#[pyo3(signature = (path: "str"))]
pub fn source(py: Python<'_>, path: PathBuf) -> PyResult<(String, String)> {
    let source = released(py, || Source::from_path(&path));
    let source = source.map_err(|error| of_read(ReadError::from(error)))?;
    Ok((source.text, source.name))
}

/// The lightest tower whose frequencies are in given bands.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct Design {
    document: DesignDocument,
    table: String,
    found: Arc<Model>,
}

#[pymethods]
impl Design {
    /// The design of a study.
    #[new]
    fn new(py: Python<'_>, tower: &Tower, text: String, name: String) -> PyResult<Self> {
        let input = &tower.model.input;
        let study = read_design_study(&Source { name, text }).map_err(of_read)?;
        let problem = design::problem(&study, input).map_err(|error| match error {
            design::StudyError::Input(error) => of_read(error),
            error => usage(error.to_string()),
        })?;
        let options = design::options(&study, input);
        let found = interruptible(py, |workspace| {
            designed(&input.description, &problem, &options, workspace)
        })?;
        let found = found.map_err(|error| {
            let located = design::located(&error, &study).filter(|_| has_lines(&study.source));
            no_design(error, located)
        })?;
        let warnings = design::warnings(&found);
        Ok(Self {
            document: design::document(input, &problem, &found, &warnings),
            table: table::design(&input.description.name, &problem, &found),
            found: changed(tower, found.tower)?,
        })
    }

    /// The tower found.
    #[getter]
    fn tower(&self) -> Tower {
        let model = Arc::clone(&self.found);
        Tower { model }
    }

    /// The table of the program.
    fn table(&self) -> &str {
        &self.table
    }

    /// The JSON of the program.
    fn json(&self) -> PyResult<String> {
        let mut json = Vec::new();
        write_design_json(&self.document, &mut json).map_err(|error| of_result(&error))?;
        Ok(String::from_utf8_lossy(&json).into_owned())
    }
}

/// A tower whose numbers are fitted to measured frequencies.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct Calibration {
    document: CalibrationDocument,
    table: String,
    found: Arc<Model>,
}

#[pymethods]
impl Calibration {
    /// The fit of measurements; `free` are the numbers to be fitted, if not those of the file.
    #[new]
    #[pyo3(signature = (tower, text, name, free, options: "dict[str, object]"))]
    fn new(
        py: Python<'_>,
        tower: &Tower,
        text: String,
        name: String,
        free: Vec<String>,
        options: SolveOptions,
    ) -> PyResult<Self> {
        let input = &tower.model.input;
        let file = read_measured(&Source { name, text }).map_err(of_read)?;
        let free = free
            .iter()
            .map(|name| Change::parse(name, &input.description));
        let free: Result<Vec<Change>, _> = free.collect();
        let free = free.map_err(|error| usage(error.to_string()))?;
        let problem = calibration::problem(&input.description, &file, free).map_err(of_read)?;
        let options = options.of(input)?;
        let fit = interruptible(py, |workspace| calibrate(&problem, &options, workspace))?;
        let fit: Fit = fit.map_err(|error| {
            let located = calibration::located(&error, &file).filter(|_| has_lines(&file.source));
            no_fit(error, located)
        })?;
        Ok(Self {
            document: calibration::document(input, &fit),
            table: table::calibration(&input.description.name, &fit),
            found: changed(tower, fit.description)?,
        })
    }

    /// The fitted tower.
    #[getter]
    fn tower(&self) -> Tower {
        let model = Arc::clone(&self.found);
        Tower { model }
    }

    /// The table of the program.
    fn table(&self) -> &str {
        &self.table
    }

    /// The JSON of the program.
    fn json(&self) -> PyResult<String> {
        let mut json = Vec::new();
        let done = write_calibration_json(&self.document, &mut json);
        done.map_err(|error| of_result(&error))?;
        Ok(String::from_utf8_lossy(&json).into_owned())
    }
}

/// Whether the lines of a text mean something to the user.
fn has_lines(source: &Source) -> bool {
    source.name != MADE_HERE
}

/// A tower with other numbers.
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
            Some("widen the bounds of the variables, the bands or the limits that are named"),
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

fn no_derivatives(error: &SensitivityError) -> PyErr {
    match error {
        SensitivityError::Tower(error) => of_tower(error),
        SensitivityError::Solve(error) => of_solve(error),
        error => usage(error.to_string()),
    }
}
