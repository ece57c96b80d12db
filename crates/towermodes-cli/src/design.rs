//! `towermodes design`.

use towermodes::Workspace;
use towermodes_design::design::{DesignError, design};
use towermodes_files::{DesignStudy, read_design_study, write_design_json};

use crate::args::{DesignArguments, FoundFormat};
use crate::failure::{Failure, note, note_texts, warn};
use crate::found::{check_output, study_source, write_tower};
use crate::input::tower_input;
use crate::output::{check_not_inputs, deliver};
use crate::studies::design::{StudyError, document, located, options, problem, warnings};
use crate::table;

/// Finds the lightest tower of a study, and writes it.
pub(crate) fn run(arguments: &DesignArguments) -> Result<(), Failure> {
    check_output(&arguments.found, &arguments.input, &arguments.study)?;
    let output = arguments.found.output();
    let study = study_source(&arguments.study, &arguments.input)?;
    let study = read_design_study(&study).map_err(Failure::Input)?;
    let input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let tower = input.tower().map_err(Failure::Input)?;
    note(&input.notes);
    warn(tower.warnings(), &input);
    let problem = problem(&study, &input).map_err(refused)?;
    let options = options(&study, &input);
    let mut workspace = Workspace::default();
    let found = design(&input.description, &problem, &options, &mut workspace);
    let found = found.map_err(|error| failure(error, &study))?;
    let warnings = warnings(&found);
    let mut result = Vec::new();
    match arguments.found.format {
        FoundFormat::Json => {
            let document = document(&input, &problem, &found, &warnings);
            write_design_json(&document, &mut result)?;
        }
        FoundFormat::Table => {
            let text = table::design(&input.description.name, &problem, &found);
            result.extend(text.into_bytes());
        }
    }
    note_texts(&warnings);
    if let Some(output) = output {
        write_tower(&input, &found.tower, output)?;
    }
    deliver(&result, None)
}

fn refused(error: StudyError) -> Failure {
    match error {
        StudyError::Input(error) => Failure::Input(error),
        StudyError::NoRotorSpeeds => Failure::NoRotorSpeeds,
        StudyError::Window(message) => Failure::WrongStudy(message),
    }
}

/// Errors that a line of the study explains name it.
fn failure(error: DesignError, study: &DesignStudy) -> Failure {
    match located(&error, study) {
        Some(message) => Failure::WrongStudy(message),
        None => Failure::Design(error),
    }
}
