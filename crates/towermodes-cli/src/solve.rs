//! `towermodes solve`.

use std::path::Path;

use towermodes::solve;
use towermodes_files::{Source, tower_from_toml, write_csv, write_json};

use crate::args::{Format, SolveArguments};
use crate::failure::{Failure, warn};
use crate::output::{check_not_input, deliver};
use crate::table;

/// Reads the tower, solves it, prints the result; warnings go to standard error.
pub(crate) fn run(arguments: &SolveArguments) -> Result<(), Failure> {
    check_not_input(&arguments.file, arguments.output())?;
    let source = source(&arguments.file)?;
    let tower = match tower_from_toml(&source.text) {
        Ok(tower) => tower,
        Err(mistakes) => return Err(Failure::Mistakes(source, mistakes)),
    };
    let solution = solve(&tower, &arguments.options()).map_err(Failure::Unsolved)?;
    let mut result = Vec::new();
    match arguments.format {
        Format::Table => result.extend(table::render(&tower, &solution).into_bytes()),
        Format::Json => write_json(&tower, &solution, &mut result)?,
        Format::Csv => write_csv(&solution, &mut result)?,
    }
    warn(&solution.warnings);
    deliver(&result, arguments.output())
}

fn source(file: &Path) -> Result<Source, Failure> {
    let source = if file == Path::new("-") {
        Source::from_stdin()
    } else {
        Source::from_path(file)
    };
    source.map_err(Failure::Unreadable)
}
