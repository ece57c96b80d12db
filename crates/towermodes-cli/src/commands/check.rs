//! `towermodes check`.

use std::path::{Path, PathBuf};

use clap::Args;
use towermodes_analysis::Verdict;
use towermodes_analysis::agreement::{AgreementLimits, agree, examine, omit_one_sided};
use towermodes_files::{FileFormat, NOTHING_LEFT_OUT, Note, TowerInput, write_result_json};

use crate::args::{InputArguments, TextFormat};
use crate::failure::Failure;
use crate::input::{input_of, tower_input};
use crate::messages::{note, warn};
use crate::output::Finished;
use crate::table;

const EXAMPLES: &str = "Examples:
  towermodes check tower.toml
  towermodes check IEA-15-240-RWT.yaml IEA_15MW_RWT_Tower_st.dat --part tower --tower-base 15
  towermodes check tower.toml Tower.dat --format json

With two files: FAIL if a difference exceeds its limit, WARN if it exceeds half of it. The limit is 0.5 % for mass, mass per length, frequencies, RNA mass and inertia, the mass of platform or substructure, and the water depth. It is 1 % for EI, the tower-top flexibility, and the hydrostatic and mooring stiffness. For the height of the centre of mass it is 0.5 % of the height range that both models cover. If the heights of the tower bases or of the tower tops differ: WARN, or FAIL if more than 1 % of the height of the longer tower is outside the height range of the other.

Exit codes: 0 verdict pass or warn; 1 verdict fail, or the computation or the output failed; 2 wrong usage or wrong input.";

/// The arguments of `check`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct CheckArguments {
    #[command(flatten)]
    input: InputArguments,

    /// Second model of the same tower, in any format; without it the command summarises the first
    other: Option<PathBuf>,

    /// Format of the result
    #[arg(long, short, value_enum, default_value_t = TextFormat::Table)]
    format: TextFormat,
}

/// Compares two models of the same tower, or summarises one.
pub(crate) fn run(arguments: &CheckArguments) -> Result<(), Failure> {
    match &arguments.other {
        None => of_one(arguments),
        Some(other) => of_two(arguments, other),
    }
}

fn of_one(arguments: &CheckArguments) -> Result<(), Failure> {
    let input = tower_input(&arguments.input)?;
    let tower = input.tower()?;
    let examination = examine(&input.description)?;
    let result = match arguments.format {
        TextFormat::Table => Finished::Text(table::examination(&tower, &examination)),
        TextFormat::Json => Finished::data(|json| write_result_json(&examination, json))?,
    };
    note(&input.notes);
    warn(tower.warnings(), &input);
    result.deliver(None)
}

fn of_two(arguments: &CheckArguments, other: &Path) -> Result<(), Failure> {
    let reading = &arguments.input.reading;
    if [&arguments.input.file, other]
        .iter()
        .all(|file| *file == Path::new("-"))
    {
        return Err(Failure::usage(
            "standard input (-) can be given for only one of the two files",
        ));
    }
    let mut first = input_of(&arguments.input.file, reading)?;
    let mut second = input_of(other, reading)?;
    reading.check(&[first.format, second.format])?;
    let gravity_is_implied = [&first, &second].map(|input| input.format == FileFormat::ElastoDyn);
    let descriptions = [&mut first.description, &mut second.description];
    let omitted = omit_one_sided(descriptions, gravity_is_implied);
    let omitted = omitted
        .iter()
        .map(|omitted| Note::suspicious(omitted.to_string()));
    first.notes.extend(omitted);
    note(&notes_of_both(&first, &second));
    // Errors have a position in the file.
    let tower_of = |input: &TowerInput| input.tower().map_err(Failure::from);
    let towers = [tower_of(&first)?, tower_of(&second)?];
    let limits = AgreementLimits::default();
    let agreement = agree(&first.description, &second.description, &limits);
    let agreement = agreement.map_err(|error| {
        // They may explain the error.
        for (tower, input) in towers.iter().zip([&first, &second]) {
            warn(tower.warnings(), input);
        }
        Failure::failed(error.to_string())
    })?;
    let result = match arguments.format {
        TextFormat::Table => {
            let names = [&arguments.input.file, other].map(|path| path.display().to_string());
            Finished::Text(table::agreement(&names, &agreement))
        }
        TextFormat::Json => Finished::data(|json| write_result_json(&agreement, json))?,
    };
    result.deliver(None)?;
    match agreement.verdict {
        Verdict::Fail => Err(Failure::failed("the two models do not agree")
            .hint("see `fail` above, in the line of the compared heights or in the table")),
        _ => Ok(()),
    }
}

/// The notes of two files, each once. The note that a file has no data to omit is reported only if
/// neither file has such data.
fn notes_of_both(first: &TowerInput, second: &TowerInput) -> Vec<Note> {
    let is_on_nothing = |note: &&Note| note.message == NOTHING_LEFT_OUT;
    let neither_has = [first, second]
        .iter()
        .all(|input| input.notes.iter().any(|n| is_on_nothing(&n)));
    let more = second
        .notes
        .iter()
        .filter(|note| !first.notes.contains(note));
    let notes = first.notes.iter().chain(more);
    notes
        .filter(|note| neither_has || !is_on_nothing(note))
        .cloned()
        .collect()
}
