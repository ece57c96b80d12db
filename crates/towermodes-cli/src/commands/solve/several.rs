//! `towermodes solve` for several files: one table with a column for each file.
//!
//! A file that fails is reported, and the others are solved. The exit code is the largest of all
//! failures.

use std::path::Path;

use towermodes::{Solution, Tower, Warning};
use towermodes_files::{
    FileFormat, Input, Note, SolvedFile, TowerInput, write_several_csv, write_several_json,
};

use super::{SolveArguments, SolveFormat};
use crate::failure::Failure;
use crate::input::input;
use crate::messages::{note, warn_texts, warning_text};
use crate::output::{Finished, check_not_input, check_not_inputs};
use crate::progress::Progress;
use crate::table;
use crate::terminal;

/// Reads and solves the files and prints one result; messages go to standard error.
pub(super) fn run(arguments: &SolveArguments, format: SolveFormat) -> Result<(), Failure> {
    arguments.check_for_several(format)?;
    let read: Vec<_> = arguments
        .files
        .iter()
        .map(|file| (name_of(file), tower_of(file, arguments)))
        .collect();
    check_overwriting(&read, arguments)?;
    check_reading(&read, arguments)?;
    let names = read.iter().map(|(file, _)| file.clone());
    let progress = Progress::of(names);
    let solved: Vec<_> = read
        .into_iter()
        .map(|(file, input)| {
            let solved = input.and_then(|input| solved(&file, input, arguments, format, &progress));
            progress.done();
            (file, solved)
        })
        .collect();
    drop(progress);
    let (solved, failed) = reported(solved);
    if !solved.is_empty() {
        result(&solved, arguments, format)?.deliver(arguments.destination.output())?;
    }
    match failed {
        None => Ok(()),
        Some(code) => {
            let (failed, files) = (arguments.files.len() - solved.len(), arguments.files.len());
            let has = if failed == 1 { "has" } else { "have" };
            Err(Failure::failed(format!("{failed} of {files} files {has} no result")).code(code))
        }
    }
}

/// A file name for messages and tables.
fn name_of(file: &Path) -> String {
    match file == Path::new("-") {
        true => "<standard input>".to_owned(),
        false => file.display().to_string(),
    }
}

/// The tower of one of the files.
fn tower_of(file: &Path, arguments: &SolveArguments) -> Result<TowerInput, Failure> {
    let tower = match input(file, &arguments.reading)? {
        Input::Tower(tower) => *tower,
        Input::Substructure(_) => {
            return Err(Failure::usage(
                "this is a SubDyn file, which describes a substructure without a tower; solve this file in a separate command",
            ));
        }
        Input::Mooring(_) => {
            return Err(Failure::usage(
                "this file describes only mooring lines, which have no modes; solve this file in a separate command",
            ));
        }
        Input::Blade(_) => {
            return Err(Failure::usage(
                "this is a deck of a rotating blade, not of a tower; solve this file in a separate command",
            ));
        }
    };
    Ok(tower)
}

/// Refuses an output that is one of the input files. This is checked before anything is solved: the
/// result must not overwrite an input file, even if that file fails.
fn check_overwriting(
    read: &[(String, Result<TowerInput, Failure>)],
    arguments: &SolveArguments,
) -> Result<(), Failure> {
    for (file, (_, input)) in arguments.files.iter().zip(read) {
        check_not_input(file, arguments.destination.output())?;
        match input {
            Ok(tower) => check_not_inputs(tower.files(), arguments.destination.output())?,
            Err(failure) => failure.file().map_or(Ok(()), |file| {
                check_not_input(file, arguments.destination.output())
            })?,
        }
    }
    Ok(())
}

/// Checks that each reading option applies to at least one of the files.
fn check_reading(
    read: &[(String, Result<TowerInput, Failure>)],
    arguments: &SolveArguments,
) -> Result<(), Failure> {
    let inputs = read.iter().filter_map(|(_, input)| input.as_ref().ok());
    let formats: Vec<FileFormat> = inputs.map(|input| input.format).collect();
    match formats.is_empty() {
        true => Ok(()),
        false => arguments.reading.check(&formats).map_err(Failure::from),
    }
}

/// A tower with its solution.
struct Solved {
    tower: Tower,
    solution: Solution,
    input: TowerInput,
}

fn solved(
    file: &str,
    input: TowerInput,
    arguments: &SolveArguments,
    format: SolveFormat,
    progress: &Progress,
) -> Result<Solved, Failure> {
    let options = arguments.options(&input, format)?;
    let tower = input.tower()?;
    let solution = progress.solver(options).solve_certain(&tower);
    let solution = solution.map_err(|error| {
        // They may explain the error.
        tell(file, &input, tower.warnings());
        Failure::from(error)
    })?;
    Ok(Solved {
        tower,
        solution,
        input,
    })
}

/// Prints the failures, the notes and the warnings; returns what was solved and the largest exit
/// code of a failure.
fn reported(all: Vec<(String, Result<Solved, Failure>)>) -> (Vec<(String, Solved)>, Option<u8>) {
    let mut solved = Vec::new();
    let mut worst = None;
    for (file, of_file) in all {
        match of_file {
            Ok(of_file) => {
                let warnings = &of_file.solution.warnings;
                tell(&file, &of_file.input, warnings);
                solved.push((file, of_file));
            }
            Err(failure) => worst = worst.max(Some(failure.report_of(&file))),
        }
    }
    (solved, worst)
}

/// Prints the notes and warnings on one file, each with the name of the file.
fn tell(file: &str, input: &TowerInput, warnings: &[Warning]) {
    let notes = input
        .notes
        .iter()
        .cloned()
        .map(|of_file| match of_file.place {
            Some(_) => of_file,
            None => Note {
                message: format!("{file}: {}", of_file.message),
                ..of_file
            },
        });
    note(&notes.collect::<Vec<_>>());
    let warnings = warnings.iter();
    let warnings = warnings.map(|warning| match warning_text(warning, input) {
        Some(placed) => placed,
        None => format!("{file}: {warning}"),
    });
    warn_texts(&warnings.collect::<Vec<_>>());
}

/// The result in the requested format.
fn result(
    solved: &[(String, Solved)],
    arguments: &SolveArguments,
    format: SolveFormat,
) -> Result<Finished, Failure> {
    let files: Vec<SolvedFile<'_>> = solved
        .iter()
        .map(|(file, solved)| SolvedFile {
            file,
            tower: &solved.tower,
            solution: &solved.solution,
            notes: &solved.input.notes,
        })
        .collect();
    match format {
        SolveFormat::Json => Finished::data(|json| write_several_json(&files, json)),
        SolveFormat::Csv => Finished::data(|csv| write_several_csv(&files, csv)),
        SolveFormat::Table | SolveFormat::Bmodes => {
            let width = terminal::width_of(arguments.destination.output());
            Ok(Finished::Text(table::several(&files, width)))
        }
    }
}
