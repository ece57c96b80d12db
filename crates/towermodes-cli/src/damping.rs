//! `towermodes damping`.

use towermodes_analysis::damping::damping;
use towermodes_files::{Note, write_damping_csv, write_damping_json};

use crate::args::{DampingArguments, Format, Prescribed};
use crate::campbell::notes_on;
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::tower_input;
use crate::messages::{note, warn};
use crate::output::{check_not_input, check_not_inputs, deliver};
use crate::progress::solve;
use crate::table;

/// Reads and solves the tower, and computes the damping of its modes.
pub(crate) fn run(arguments: &DampingArguments) -> Result<(), Failure> {
    let output = arguments.destination.output();
    check_not_input(&arguments.input.file, output)?;
    let format = arguments.destination.format()?;
    let mut input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let given = arguments.given();
    given.set(&mut input.description)?;
    let known = &input.description.damping;
    arguments.check_rotor(known)?;
    let tower = input.tower()?;
    let prescribed = Prescribed::of(&mut input);
    let options = arguments.options(prescribed)?;
    let solution = solve(&tower, &options);
    let solution = explained(solution, (&tower, &input))?;
    let chosen = arguments.rotor(&input);
    let rotor = chosen.as_ref().map(|chosen| &chosen.rotor);
    let damping = damping(&input.description, &solution, rotor);
    let damping = damping.map_err(Failure::failed)?;
    let mut notes = std::mem::take(&mut input.notes);
    let chosen = chosen.filter(|_| input.description.damping.rotor.is_some());
    notes.extend(chosen.iter().flat_map(|chosen| notes_on(&input, chosen)));
    let remarks = damping.remarks.iter();
    notes.extend(remarks.map(|remark| Note::new(remark.to_string())));
    let mut result = Vec::new();
    match format {
        Format::Table => result.extend(table::damping(&tower, &damping).into_bytes()),
        Format::Json => write_damping_json(tower.name(), &damping, &notes, &mut result)?,
        Format::Csv => write_damping_csv(&damping, &mut result)?,
    }
    note(&notes);
    warn(&solution.warnings, &input);
    deliver(&result, output)
}
