//! `towermodes sensitivities`.

use towermodes::{Change, Options, SensitivityError, TowerDescription};
use towermodes_analysis::influence::{Influences, Tolerance, Tolerances, influences};
use towermodes_files::{TowerInput, write_sensitivities_csv, write_sensitivities_json};
use towermodes_report::figures;

use crate::args::{Format, Prescribed, SensitivitiesArguments};
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::tower_input;
use crate::messages::{note, warn};
use crate::output::{check_not_input, check_not_inputs, check_place, deliver};
use crate::plot::deliver_picture;
use crate::progress::Progress;
use crate::table;

/// Reads the tower, differentiates its frequencies and prints what each number does.
pub(crate) fn run(arguments: &SensitivitiesArguments) -> Result<(), Failure> {
    let output = arguments.destination.output();
    check_not_input(&arguments.input.file, output)?;
    let format = arguments.destination.format()?;
    let picture = arguments.picture()?;
    if let Some((path, _)) = picture {
        check_not_input(&arguments.input.file, Some(path))?;
        check_place(path)?;
    }
    let mut input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let tower = input.tower()?;
    let prescribed = Prescribed::of(&mut input);
    let options = arguments.options(prescribed)?;
    let changes = changes(&arguments.names, &input.description)?;
    let tolerances = tolerances(&arguments.tolerances, &input.description)?;
    let influences = influences_of(&input.description, changes.as_deref(), &options);
    let influences = explained(influences, (&tower, &input))?;
    if let Some(file) = picture {
        let figure = figures::tornado(&input.description, &influences, &tolerances);
        deliver_picture(figure, &tower, file)?;
    }
    // What is asked for by name is listed, whatever it does.
    let all = arguments.all || !arguments.names.is_empty();
    let result = written(format, &input, &influences, &tolerances, all)?;
    note(&input.notes);
    warn(tower.warnings(), &input);
    deliver(&result, output)
}

/// The influence of changes, or of every number, on the lowest modes; with progress.
pub(crate) fn influences_of(
    description: &TowerDescription,
    changes: Option<&[Change]>,
    options: &Options,
) -> Result<Influences, Failure> {
    let progress = Progress::of_one();
    let mut workspace = progress.workspace();
    let done = influences(description, changes, options, &mut workspace);
    drop((workspace, progress));
    done.map_err(failure)
}

fn written(
    format: Format,
    input: &TowerInput,
    influences: &Influences,
    tolerances: &Tolerances,
    all: bool,
) -> Result<Vec<u8>, Failure> {
    let mut result = Vec::new();
    match format {
        Format::Table => {
            let text = table::sensitivities(&input.description, influences, tolerances, all);
            result.extend(text.into_bytes());
        }
        Format::Json => write_sensitivities_json(input, influences, tolerances, &mut result)?,
        Format::Csv => write_sensitivities_csv(input, influences, tolerances, &mut result)?,
    }
    Ok(result)
}

/// The changes that are asked for; none for every number.
fn changes(
    names: &[String],
    description: &TowerDescription,
) -> Result<Option<Vec<Change>>, Failure> {
    if names.is_empty() {
        return Ok(None);
    }
    let mut changes = Vec::new();
    for name in names {
        let change = Change::parse(name, description)?;
        // A pattern lists its numbers one by one.
        match name.contains('*') && !name.contains('(') {
            false => changes.push(change),
            true => {
                let each = change.parameters().iter().map(ToString::to_string);
                let each = each.map(|name| Change::parse(&name, description));
                changes.extend(each.collect::<Result<Vec<_>, _>>()?);
            }
        }
    }
    Ok(Some(changes))
}

fn tolerances(
    given: &[(Option<String>, Tolerance)],
    description: &TowerDescription,
) -> Result<Tolerances, Failure> {
    let of_others = given.iter().rev().find(|(name, _)| name.is_none());
    let named = given
        .iter()
        .filter_map(|(name, tolerance)| Some((name.clone()?, *tolerance)));
    let named: Vec<(String, Tolerance)> = named.collect();
    let of_others = of_others.map(|(_, tolerance)| *tolerance);
    Tolerances::new(of_others, &named, description).map_err(Failure::from)
}

fn failure(error: SensitivityError) -> Failure {
    match error {
        SensitivityError::Tower(error) => Failure::from(error),
        SensitivityError::Solve(error) => Failure::from(error),
        error => Failure::from(error),
    }
}
