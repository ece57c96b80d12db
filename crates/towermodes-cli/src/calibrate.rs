//! `towermodes calibrate`.

use towermodes::{Change, TowerDescription};
use towermodes_design::calibration::{CalibrationError, Problem, calibrate};
use towermodes_files::{MeasuredFile, read_measured, write_calibration_json};

use crate::args::{CalibrateArguments, FoundFormat, Prescribed};
use crate::failure::Failure;
use crate::found::{check_output, study_source, write_tower};
use crate::input::tower_input;
use crate::messages::{note, warn};
use crate::output::{check_not_inputs, deliver};
use crate::progress::Progress;
use crate::studies::calibration::{document, located, problem};
use crate::table;

/// Fits numbers of a tower to measured frequencies, and writes the fitted tower.
pub(crate) fn run(arguments: &CalibrateArguments) -> Result<(), Failure> {
    check_output(&arguments.found, &arguments.input, &arguments.measured)?;
    let output = arguments.found.output();
    let file = study_source(&arguments.measured, &arguments.input)?;
    let file = read_measured(&file)?;
    let mut input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let tower = input.tower()?;
    let options = arguments.options(Prescribed::of(&mut input))?;
    note(&input.notes);
    warn(tower.warnings(), &input);
    let problem = problem_of(&input.description, &file, &arguments.free())?;
    let progress = Progress::of_one();
    let mut workspace = progress.workspace();
    let done = calibrate(&problem, &options, &mut workspace);
    drop((workspace, progress));
    let fit = done.map_err(|error| failure(error, &file))?;
    let mut result = Vec::new();
    match arguments.found.format {
        FoundFormat::Json => write_calibration_json(&document(&input, &fit), &mut result)?,
        FoundFormat::Table => {
            let text = table::calibration(&input.description.name, &fit);
            result.extend(text.into_bytes());
        }
    }
    if let Some(output) = output {
        write_tower(&input, &fit.description, output)?;
    }
    deliver(&result, None)
}

/// The problem of a file, with the unknowns of the command line if there are some.
fn problem_of(
    base: &TowerDescription,
    file: &MeasuredFile,
    free: &[&str],
) -> Result<Problem, Failure> {
    let free = free.iter().map(|name| Change::parse(name, base));
    let free = free.collect::<Result<_, _>>()?;
    let problem = problem(base, file, free)?;
    match problem.unknowns.is_empty() {
        false => Ok(problem),
        true => Err(Failure::usage(format!(
            "{}: no number is to be fitted; add for example \"foundation.rocking\" = {{}} to [calibrate.unknowns], or give --free NAME",
            file.source.name
        ))),
    }
}

/// Errors that the file explains name it, with the line.
fn failure(error: CalibrationError, file: &MeasuredFile) -> Failure {
    match error {
        CalibrationError::Tower(error) => Failure::from(error),
        CalibrationError::Solve(error) => Failure::from(error),
        error => {
            let is_usage = error.is_usage();
            match located(&error, file) {
                Some(error) if is_usage => Failure::from(error),
                Some(error) => Failure::unreached(error),
                None if is_usage => Failure::usage(format!("{}: {error}", file.source.name)),
                None => Failure::failed(error),
            }
        }
    }
}
