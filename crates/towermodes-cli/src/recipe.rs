//! Common parts of the commands that read a tower, compute a result and print it: the checks of
//! options and files, the formats, the messages, the output and the exit code.

use towermodes::{Tower, Warning};
use towermodes_files::{Note, ResultError, TowerInput};

use crate::args::{Deferred, Destination, Format, InputArguments};
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::tower_input;
use crate::messages::{note, warn};
use crate::output::{Finished, check_not_input, check_not_inputs};

/// A command that reads a tower, computes a result and prints it.
pub(crate) trait Analysis {
    /// The checked request of the options.
    type Plan;

    /// The input file, and the destination of the result.
    fn files(&self) -> (&InputArguments, &Destination);

    /// Checks the options before a file is read.
    fn check(&self, _format: Format) -> Result<(), Failure> {
        Ok(())
    }

    /// Changes the input by options before it becomes a tower.
    fn change(&self, _input: &mut TowerInput) -> Result<(), Failure> {
        Ok(())
    }

    /// Checks the options against the input.
    fn plan(&self, input: &mut TowerInput) -> Result<Self::Plan, Failure>;

    /// Computes the result. If this fails, the notes and warnings on the tower are printed before
    /// the error.
    fn answer(
        &self,
        tower: &Tower,
        input: &TowerInput,
        plan: Self::Plan,
        format: Format,
    ) -> Result<Answer, Failure>;
}

/// A result in its format, with its notes, warnings and verdict.
pub(crate) struct Answer {
    result: Finished,
    notes: Vec<Note>,
    warnings: Vec<Warning>,
    verdict: Result<(), Failure>,
}

impl Answer {
    /// A result in one of its formats.
    pub(crate) fn of(
        format: Format,
        table: impl FnOnce() -> String,
        json: impl FnOnce(&mut Vec<u8>) -> Result<(), ResultError>,
        csv: impl FnOnce(&mut Vec<u8>) -> Result<(), ResultError>,
    ) -> Result<Self, Failure> {
        let result = match format {
            Format::Table => Finished::Text(table()),
            Format::Json => Finished::data(json)?,
            Format::Csv => Finished::data(csv)?,
        };
        Ok(Self {
            result,
            notes: Vec::new(),
            warnings: Vec::new(),
            verdict: Ok(()),
        })
    }

    /// Adds notes to those of the reader.
    pub(crate) fn notes(self, notes: Vec<Note>) -> Self {
        Self { notes, ..self }
    }

    pub(crate) fn warnings(self, warnings: &[Warning]) -> Self {
        let warnings = warnings.to_vec();
        Self { warnings, ..self }
    }

    /// Adds a failure that is reported after the result.
    pub(crate) fn verdict(self, verdict: Result<(), Failure>) -> Self {
        Self { verdict, ..self }
    }
}

/// Runs a command.
pub(crate) fn run<A: Analysis>(arguments: &Deferred<A>) -> Result<(), Failure> {
    let (file, destination) = arguments.files();
    let output = destination.output();
    check_not_input(&file.file, output)?;
    let format = destination.format()?;
    arguments.check(format)?;
    let mut input = tower_input(file)?;
    check_not_inputs(input.files(), output)?;
    arguments.change(&mut input)?;
    let tower = input.tower()?;
    let plan = arguments.plan(&mut input)?;
    let answer = arguments.answer(&tower, &input, plan, format);
    let answer = explained(answer, (&tower, &input))?;
    note(&input.notes);
    note(&answer.notes);
    warn(&answer.warnings, &input);
    answer.result.deliver(output)?;
    answer.verdict
}
