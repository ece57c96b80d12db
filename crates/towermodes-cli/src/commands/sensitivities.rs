//! `towermodes sensitivities`.

use std::path::PathBuf;

use clap::Args;
use towermodes::{Change, Options, Tower, TowerDescription};
use towermodes_analysis::influence::{Influences, Tolerance, Tolerances, influences};
use towermodes_files::{TowerInput, write_sensitivities_csv, write_sensitivities_json};
use towermodes_report::figures;

use super::plot::deliver_picture;
use crate::args::parsers::tolerance_parser;
use crate::args::{Destination, Format, InputArguments, PictureFile, SolverArguments, csv_lines};
use crate::failure::Failure;
use crate::output::{check_not_input, check_place};
use crate::progress::searching;
use crate::recipe::{Analysis, Answer};
use crate::table;

const EXAMPLES: &str = "Examples:
  towermodes sensitivities tower.toml
  towermodes sensitivities tower.toml 'stations[*].wall' rna.mass --modes 2
  towermodes sensitivities tower.toml --tolerance 2% --tolerance rna.mass=10e3
  towermodes sensitivities tower.toml --plot tornado.svg
  towermodes sensitivities tower.toml --output sensitivities.json

Each entry of the table is the change of a frequency in percent for a 1 % change of the input value (for a height: 1 % of the tower height). With --tolerance, each entry is the change caused by that tolerance; the last row is the root of the sum of squares.
NAME is the name of an input value (towermodes parameters lists them), or a combined change such as 'scale(stations[*].wall)'; by default all input values.

Exit codes: 0 done, 1 the computation or the output failed, 2 wrong usage or wrong input.";

/// The arguments of `sensitivities`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("format", |of| csv_lines(of, "One line per input and mode")))]
pub(crate) struct SensitivitiesArguments {
    #[command(flatten)]
    input: InputArguments,

    /// Names of input values, or combined changes such as scale(...) [default: all input values]
    #[arg(value_name = "NAME")]
    names: Vec<String>,

    /// Tolerance, plus or minus: `2%` applies to every input value except heights; `NAME=2%` or
    /// `NAME=AMOUNT` applies to one; may be repeated
    #[arg(long = "tolerance", value_name = "[NAME=]VALUE", value_parser = tolerance_parser)]
    tolerances: Vec<(Option<String>, Tolerance)>,

    /// List also the input values with elasticities of at most 1e-4 for all listed frequencies
    #[arg(long)]
    all: bool,

    /// Draw the influence of the input values on the lowest mode as a tornado diagram (.svg or
    /// .png)
    #[arg(long, value_name = "PATH")]
    plot: Option<PathBuf>,

    #[command(flatten)]
    solver: SolverArguments,

    #[command(flatten)]
    destination: Destination,
}

/// Modes in the table by default: more columns do not fit into a terminal.
const MODES: usize = 4;

/// The request of the command.
pub(crate) struct Plan {
    options: Options,
    /// None for every number.
    changes: Option<Vec<Change>>,
    tolerances: Tolerances,
}

impl Analysis for SensitivitiesArguments {
    type Plan = Plan;

    fn files(&self) -> (&InputArguments, &Destination) {
        (&self.input, &self.destination)
    }

    fn check(&self, _: Format) -> Result<(), Failure> {
        if let Some((path, _)) = PictureFile::requested(self.plot.as_deref())? {
            check_not_input(&self.input.file, Some(path))?;
            check_place(path)?;
        }
        Ok(())
    }

    fn plan(&self, input: &mut TowerInput) -> Result<Plan, Failure> {
        let options = self.solver.frequencies(input)?;
        Ok(Plan {
            options: Options {
                modes: self.solver.model.modes.unwrap_or(MODES),
                ..options
            },
            changes: changes(&self.names, &input.description)?,
            tolerances: tolerances(&self.tolerances, &input.description)?,
        })
    }

    /// Differentiates the frequencies of the tower, and shows what each number does.
    fn answer(
        &self,
        tower: &Tower,
        input: &TowerInput,
        plan: Plan,
        format: Format,
    ) -> Result<Answer, Failure> {
        let (description, tolerances) = (&input.description, &plan.tolerances);
        let influences = influences_of(description, plan.changes.as_deref(), &plan.options)?;
        if let Some(file) = PictureFile::requested(self.plot.as_deref())? {
            let figure = figures::tornado(description, &influences, tolerances);
            deliver_picture(figure, tower, file)?;
        }
        // A value that is requested by name is listed, whatever its effect.
        let all = self.all || !self.names.is_empty();
        let answer = Answer::of(
            format,
            || table::sensitivities(description, &influences, tolerances, all),
            |json| write_sensitivities_json(input, &influences, tolerances, json),
            |csv| write_sensitivities_csv(input, &influences, tolerances, csv),
        )?;
        Ok(answer.warnings(tower.warnings()))
    }
}

/// The influence of changes, or of every number, on the lowest modes; with progress.
pub(crate) fn influences_of(
    description: &TowerDescription,
    changes: Option<&[Change]>,
    options: &Options,
) -> Result<Influences, Failure> {
    let (mut solver, line) = searching(options.clone());
    let done = influences(description, changes, &mut solver);
    drop((solver, line));
    Ok(done?)
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
