//! `towermodes check`.

use std::path::Path;

use towermodes::Rna;
use towermodes_analysis::Verdict;
use towermodes_analysis::agreement::{AgreementLimits, agree, examine};
use towermodes_files::{FileFormat, NOTHING_LEFT_OUT, Note, TowerInput, write_result_json};

use crate::args::{CheckArguments, ReportFormat};
use crate::failure::{Failure, note, warn};
use crate::input::{input_of, tower_input};
use crate::output::deliver;
use crate::table;

/// Compares two models of the same tower, or summarises one.
pub(crate) fn run(arguments: &CheckArguments) -> Result<(), Failure> {
    match &arguments.other {
        None => of_one(arguments),
        Some(other) => of_two(arguments, other),
    }
}

fn of_one(arguments: &CheckArguments) -> Result<(), Failure> {
    let input = tower_input(&arguments.input)?;
    let tower = input.tower().map_err(Failure::Input)?;
    let examination = examine(&input.description).map_err(Failure::Tower)?;
    let mut result = Vec::new();
    match arguments.format {
        ReportFormat::Table => {
            result.extend(table::examination(&tower, &examination).into_bytes());
        }
        ReportFormat::Json => write_result_json(&examination, &mut result)?,
    }
    note(&input.notes);
    warn(tower.warnings(), &input);
    deliver(&result, None)
}

/// Whether a note reports that there was no data to omit.
fn is_on_nothing(note: &Note) -> bool {
    note.message == NOTHING_LEFT_OUT
}

fn of_two(arguments: &CheckArguments, other: &Path) -> Result<(), Failure> {
    let reading = &arguments.input.reading;
    let mut first = input_of(&arguments.input.file, reading)?;
    let mut second = input_of(other, reading)?;
    let checked = reading.check(&[first.format, second.format]);
    checked.map_err(Failure::Usage)?;
    leave_lone_machine_out(&mut first, &mut second);
    leave_lone_gravity_out(&mut first, &mut second);
    let useless = [&first, &second].map(|input| input.notes.iter().any(is_on_nothing));
    if useless.contains(&false) {
        // Data omitted from one of the two files are omitted data.
        for input in [&mut first, &mut second] {
            input.notes.retain(|note| !is_on_nothing(note));
        }
    }
    let mut notes = first.notes.clone();
    let more = second
        .notes
        .iter()
        .filter(|note| !first.notes.contains(note));
    notes.extend(more.cloned());
    note(&notes);
    for input in [&first, &second] {
        // Errors have a position in the file.
        input.tower().map_err(Failure::Input)?;
    }
    let limits = AgreementLimits::default();
    let agreement = agree(&first.description, &second.description, &limits)
        .map_err(|error| Failure::Refused(error.to_string()))?;
    let mut result = Vec::new();
    match arguments.format {
        ReportFormat::Table => {
            let names = [&arguments.input.file, other].map(|path| path.display().to_string());
            result.extend(table::agreement(&names, &agreement).into_bytes());
        }
        ReportFormat::Json => write_result_json(&agreement, &mut result)?,
    }
    deliver(&result, None)?;
    match agreement.verdict {
        Verdict::Fail => Err(Failure::Disagree),
        _ => Ok(()),
    }
}

/// Omits an RNA that only one of the two files has: the towers are compared without it.
fn leave_lone_machine_out(first: &mut TowerInput, second: &mut TowerInput) {
    let has_machine = |input: &TowerInput| input.description.rna != Rna::default();
    let which = match (has_machine(first), has_machine(second)) {
        (true, false) => "first",
        (false, true) => "second",
        _ => return,
    };
    let message = format!(
        "only the {which} file has a rotor-nacelle assembly; it is omitted, and the towers are compared without RNA"
    );
    first.notes.push(Note::new(message));
    first.description.rna = Rna::default();
    second.description.rna = Rna::default();
}

/// Omits the gravity of an ElastoDyn model, which always has gravity, if the other file has none.
fn leave_lone_gravity_out(first: &mut TowerInput, second: &mut TowerInput) {
    let has_gravity = |input: &TowerInput| input.description.gravity_m_per_s2 != 0.0;
    let (which, lone) = match (has_gravity(first), has_gravity(second)) {
        (true, false) => ("first", &mut *first),
        (false, true) => ("second", &mut *second),
        _ => return,
    };
    if lone.format != FileFormat::ElastoDyn {
        return;
    }
    lone.description.gravity_m_per_s2 = 0.0;
    let message = format!(
        "only the {which} file has gravity; it is omitted, and the towers are compared without gravity"
    );
    first.notes.push(Note::new(message));
}
