//! Common parts of the commands that compute input values of a tower: a tower file, a file with the
//! task, and an output file for the tower with the computed values.

use std::path::Path;

use towermodes::TowerDescription;
use towermodes_files::{ReadError, Source, TowerInput, rewritten};

use crate::args::{FoundArguments, InputArguments};
use crate::failure::Failure;
use crate::messages::{note, report};
use crate::output::{check_not_input, check_place, replace};

/// Refuses an output that cannot be written or would overwrite an input, before anything is
/// computed.
pub(crate) fn check_output(
    found: &FoundArguments,
    tower: &InputArguments,
    study: &Path,
) -> Result<(), Failure> {
    found.check()?;
    check_not_input(&tower.file, found.output())?;
    check_not_input(study, found.output())?;
    found.output().map_or(Ok(()), check_place)
}

/// The text of the design or calibration file.
pub(crate) fn study_source(study: &Path, tower: &InputArguments) -> Result<Source, Failure> {
    let stdin = Path::new("-");
    let source = match study == stdin {
        true if tower.file == stdin => {
            return Err(Failure::usage(
                "only one of the two files can be standard input (-)",
            ));
        }
        true => Source::from_stdin(),
        false => Source::from_path(study),
    };
    source.map_err(ReadError::from).map_err(Failure::from)
}

/// Writes a tower with changed input values, in the text of its original file if possible.
pub(crate) fn write_tower(
    input: &TowerInput,
    changed: &TowerDescription,
    output: &Path,
) -> Result<(), Failure> {
    let file = rewritten(input, changed);
    note(&file.notes);
    replace(output, file.text.as_bytes())?;
    let how = file.anew.map_or(String::new(), |reason| {
        format!(" (without the comments of the old file, because {reason})")
    });
    report(&format!("written: {}{how}\n", output.display()));
    Ok(())
}
