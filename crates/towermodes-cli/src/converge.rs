//! `towermodes converge`.

use towermodes::study::converge;
use towermodes_files::{write_convergence_csv, write_convergence_json};

use crate::args::{ConvergeArguments, Format};
use crate::failure::{Failure, note, warn};
use crate::input::tower;
use crate::output::{Progress, check_not_input, deliver};
use crate::table;

/// Reads the tower, solves it more and more finely, prints the errors.
pub(crate) fn run(arguments: &ConvergeArguments) -> Result<(), Failure> {
    let fineness = arguments.fineness().map_err(Failure::Usage)?;
    let output = arguments.destination.output();
    check_not_input(&arguments.input.file, output)?;
    let (tower, notes) = tower(&arguments.input)?;
    let progress = Progress::start();
    let convergence = converge(&tower, &arguments.options(), &fineness, |level| {
        progress.say(&level.asked.number().to_string());
    })
    .map_err(Failure::Unsolved)?;
    let mut result = Vec::new();
    match arguments.destination.format {
        Format::Table => result.extend(table::convergence(&tower, &convergence).into_bytes()),
        Format::Json => write_convergence_json(&convergence, &mut result)?,
        Format::Csv => write_convergence_csv(&convergence, &mut result)?,
    }
    note(&notes);
    warn(&convergence.warnings);
    deliver(&result, output)
}
