//! `towermodes calibrate`.

use std::path::PathBuf;

use clap::Args;
use towermodes::{Change, TowerDescription};
use towermodes_design::calibration::{CalibrationError, Problem, calibrate};
use towermodes_files::{MeasuredFile, read_measured, write_calibration_json};

use crate::args::{FoundArguments, InputArguments, SolverArguments, TextFormat};
use crate::failure::Failure;
use crate::found::{check_output, study_source, write_tower};
use crate::input::tower_input;
use crate::messages::{note, warn};
use crate::output::{Finished, check_not_inputs};
use crate::progress::Progress;
use crate::studies::calibration::{document, located, problem};
use crate::table;

const EXAMPLES: &str = "Examples:
  towermodes calibrate tower.toml measured.toml
  towermodes calibrate tower.toml measured.toml --output fitted.toml
  towermodes calibrate tower.toml measured.toml --free rna.mass
  towermodes calibrate tower.toml measured.toml --format json

MEASURED is a TOML file with the measured frequencies and the input values to be fitted; for example:
  [calibrate.unknowns]
  \"rna.mass\" = { prior = [350e3, 5e3] }
  \"foundation.rocking\" = { bounds = [1e9, 1e12] }

  [[measured]]
  mode = \"fore-aft 1\"
  frequency = 0.2585
  deviation = 0.001

A prior consists of a mean and a standard deviation; a measurement consists of a frequency and a standard deviation in Hz. A good fit does not show that the model is valid. `towermodes parameters FILE` lists the names of the input values.

Exit codes: 0 the values are fitted, 1 the measurements do not determine them, the computation or the output failed, 2 wrong usage or wrong input.";

/// The arguments of `calibrate`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct CalibrateArguments {
    #[command(flatten)]
    input: InputArguments,

    /// TOML file with the measured frequencies ([[measured]]) and the input values to fit
    measured: PathBuf,

    /// Fit only these input values; their priors and bounds come from MEASURED [default: all of
    /// [calibrate.unknowns]]
    #[arg(long, value_name = "NAME,...")]
    free: Vec<String>,

    #[command(flatten)]
    solver: SolverArguments,

    #[command(flatten)]
    found: FoundArguments,
}

impl CalibrateArguments {
    /// The names of `--free`, separated by commas outside parentheses.
    pub(crate) fn free(&self) -> Vec<&str> {
        let names = self.free.iter().flat_map(|names| separated(names));
        names.filter(|name| !name.is_empty()).collect()
    }
}

fn separated(names: &str) -> Vec<&str> {
    let mut depth = 0_i32;
    let is_end = |c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        c == ',' && depth <= 0
    };
    names.split(is_end).map(str::trim).collect()
}

/// Fits input values of a tower to measured frequencies, and writes the fitted tower.
pub(crate) fn run(arguments: &CalibrateArguments) -> Result<(), Failure> {
    check_output(&arguments.found, &arguments.input, &arguments.measured)?;
    let output = arguments.found.output();
    let file = study_source(&arguments.measured, &arguments.input)?;
    let file = read_measured(&file)?;
    let input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let tower = input.tower()?;
    let options = arguments.solver.frequencies(&input)?;
    note(&input.notes);
    warn(tower.warnings(), &input);
    let problem = problem_of(&input.description, &file, &arguments.free())?;
    let progress = Progress::of_one();
    let mut solver = progress.solver(options);
    let done = calibrate(&problem, &mut solver);
    drop((solver, progress));
    let fit = done.map_err(|error| failure(error, &file))?;
    let result = match arguments.found.format {
        TextFormat::Json => {
            Finished::data(|json| write_calibration_json(&document(&input, &fit), json))?
        }
        TextFormat::Table => Finished::Text(table::calibration(&input.description.name, &fit)),
    };
    if let Some(output) = output {
        write_tower(&input, &fit.description, output)?;
    }
    result.deliver(None)
}

/// The problem of a calibration file; the unknowns of the command line, if given, replace those of
/// the file.
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
            "{}: no input value is to be fitted; add for example \"foundation.rocking\" = {{}} to [calibrate.unknowns], or give --free NAME",
            file.source.name
        ))),
    }
}

/// Adds the line of the calibration file to an error that such a line explains.
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

#[cfg(test)]
mod tests {
    use super::separated;

    #[test]
    fn commas_in_parentheses_do_not_separate() {
        let names = separated("a.b, add(c, d),e");
        assert_eq!(names, ["a.b", "add(c, d)", "e"]);
    }
}
