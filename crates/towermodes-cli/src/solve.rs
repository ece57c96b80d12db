//! `towermodes solve`.

use towermodes::solve;
use towermodes_files::{write_csv, write_json};

use crate::args::{Format, SolveArguments};
use crate::failure::{Failure, warn};
use crate::input::tower;
use crate::output::{check_not_input, deliver};
use crate::table;

/// Reads the tower, solves it, prints the result; warnings go to standard error.
pub(crate) fn run(arguments: &SolveArguments) -> Result<(), Failure> {
    let options = arguments.options().map_err(Failure::Usage)?;
    let output = arguments.destination.output();
    check_not_input(&arguments.file, output)?;
    let tower = tower(&arguments.file)?;
    let solution = solve(&tower, &options).map_err(Failure::Unsolved)?;
    let mut result = Vec::new();
    match arguments.destination.format {
        Format::Table => result.extend(table::solution(&tower, &solution).into_bytes()),
        Format::Json => write_json(&tower, &solution, &mut result)?,
        Format::Csv => write_csv(&solution, &mut result)?,
    }
    warn(&solution.warnings);
    deliver(&result, output)
}
