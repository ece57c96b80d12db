//! The plan of a sweep: the base, the changes, the modes, the values.

use std::ops::Range;
use std::path::Path;

use towermodes::{Change, Operation, TowerDescription};
use towermodes_files::{
    FileFormat, Input, ReadError, ReadOptions, Setting, SiblingFiles, Source, SweepResults,
    SweepRows, SweepStudy, TowerInput, read, read_sweep_study, recognize,
};
use towermodes_sweep::{Base, Sweep, SweepSource, Table, rows_within};

use super::arguments::SweepArguments;
use crate::args::ReadingArguments;
use crate::failure::Failure;
use crate::input::set_numbers;
use crate::messages::{note, warn};

/// A checked sweep.
pub(super) struct Planned {
    /// The tower that is varied.
    pub(super) input: TowerInput,
    pub(super) sweep: Sweep,
    /// The values of the rows.
    pub(super) source: SweepSource,
}

impl Planned {
    /// Reads base, study and table, and solves the base.
    pub(super) fn of(arguments: &SweepArguments) -> Result<Self, Failure> {
        let (input, changes, source, results) = match &arguments.table {
            Some(table) => of_table(table, arguments)?,
            None => of_study(arguments)?,
        };
        // Errors have a position in the file.
        let tower = input.tower()?;
        note(&input.notes);
        warn(tower.warnings(), &input);
        check_settings(&arguments.reading, &changes, &input.description)?;
        let sweep = Sweep::new(Base::from(&input), changes, &results)?;
        Ok(Self {
            input,
            sweep,
            source,
        })
    }

    /// The selected rows; the range may end beyond the last row.
    pub(super) fn rows(&self, arguments: &SweepArguments) -> Result<Range<u64>, Failure> {
        let count = self.source.rows();
        match arguments.rows {
            Some(asked) => rows_within(asked.start..asked.end, count).map_err(Failure::from),
            None => Ok(0..count),
        }
    }
}

type Parts = (TowerInput, Vec<Change>, SweepSource, SweepResults);

/// The sweep of a tower file and a table.
fn of_table(table: &Path, arguments: &SweepArguments) -> Result<Parts, Failure> {
    let reading = &arguments.reading;
    let input = tower_of(&arguments.file, &reading.options(), reading)?;
    reading.check(&[input.format])?;
    let table = open(table, &input.description, arguments)?;
    let changes = table.changes().to_vec();
    let names = changes.iter().map(Change::name);
    ReadingArguments::check_columns(&reading.options(), names)?;
    let results = arguments.results(SweepResults::default());
    Ok((input, changes, SweepSource::Table(Box::new(table)), results))
}

/// The sweep of a study, with the files that it names.
fn of_study(arguments: &SweepArguments) -> Result<Parts, Failure> {
    let study = study_of(&arguments.file)?;
    let reading = &arguments.reading;
    if reading.options() != ReadOptions::default() {
        return Err(Failure::usage(
            "options for reading a tower, such as --part or --no-rna, do not apply to a sweep study; write them as keys of its table [sweep.reading]",
        ));
    }
    let beside = SiblingFiles::of(&arguments.file);
    let input = tower_of(&beside.path(&study.base.value), &study.reading, reading)?;
    check_reading(&study.reading, &input, reading)?;
    let results = arguments.results(study.results.clone());
    let (changes, source) = match &study.rows {
        SweepRows::Table(path) => {
            let table = open(&beside.path(&path.value), &input.description, arguments)?;
            let changes = table.changes().to_vec();
            (changes, SweepSource::Table(Box::new(table)))
        }
        SweepRows::Sampled { sampling, .. } => {
            if !arguments.ignore.is_empty() {
                return Err(Failure::usage("--ignore applies only to a table of values"));
            }
            let changes = study.changes(&input.description)?;
            let source = SweepSource::sampled(sampling.clone());
            let source = source.map_err(|error| Failure::from(study.undrawn(error)))?;
            (changes, source)
        }
    };
    let names = changes.iter().map(Change::name);
    ReadingArguments::check_columns(&study.reading, names)
        .map_err(|problem| Failure::usage(as_keys(problem)))?;
    Ok((input, changes, source, results))
}

/// Checks the options of `[sweep.reading]` against the tower and `--set`.
fn check_reading(
    given: &ReadOptions,
    input: &TowerInput,
    reading: &ReadingArguments,
) -> Result<(), Failure> {
    let names = reading.settings.iter().map(Setting::name);
    ReadingArguments::check_names(given, names)
        .map_err(|problem| Failure::usage(as_keys(problem)))?;
    ReadingArguments::check_options(given, &[input.format])
        .map_err(|problem| Failure::usage(as_keys(problem)))
}

/// A message in which options of the command line are replaced by keys of a study: `--tower-height`
/// by `[sweep.reading] tower_height`. `--set` has no key.
fn as_keys(message: &str) -> String {
    let words = message
        .split(' ')
        .map(|word| match word.strip_prefix("--") {
            Some(option) if option != "set" => {
                format!("[sweep.reading] {}", option.replace('-', "_"))
            }
            _ => word.to_owned(),
        });
    words.collect::<Vec<_>>().join(" ")
}

/// Refuses a setting of an input value that every row changes.
fn check_settings(
    reading: &ReadingArguments,
    changes: &[Change],
    base: &TowerDescription,
) -> Result<(), Failure> {
    for setting in &reading.settings {
        // The numbers are set already, so the name is right.
        let Ok(set) = Change::parse(setting.name(), base) else {
            continue;
        };
        let overwrites = |change: &&Change| {
            let numbers = change.parameters();
            change.operation() == Operation::Set
                && set.parameters().iter().any(|of| numbers.contains(of))
        };
        if let Some(change) = changes.iter().find(overwrites) {
            let all = set.parameters().iter();
            let parameter = all
                .filter(|of| change.parameters().contains(of))
                .map(|of| of.to_string());
            return Err(Failure::usage(format!(
                "--set {} has no effect: the column `{}` sets {} in each row; remove one of them",
                setting.name(),
                change.name(),
                parameter.take(1).collect::<String>()
            )));
        }
    }
    Ok(())
}

/// The study in a file.
fn study_of(file: &Path) -> Result<SweepStudy, Failure> {
    let source = match file == Path::new("-") {
        true => Source::from_stdin(),
        false => Source::from_path(file),
    };
    let source = source.map_err(ReadError::from)?;
    // A study is TOML; any other tower file needs a table.
    if !matches!(recognize(&source), None | Some(FileFormat::Toml)) {
        return Err(Failure::usage(
            "give a table of values after the tower file, or a sweep study: a TOML file with [sweep]",
        ));
    }
    read_sweep_study(&source).map_err(Failure::from)
}

/// The tower that is varied.
fn tower_of(
    file: &Path,
    options: &ReadOptions,
    reading: &ReadingArguments,
) -> Result<TowerInput, Failure> {
    let input = match file == Path::new("-") {
        true => crate::input::input(file, reading)?,
        false => read(file, options)?,
    };
    let Input::Tower(tower) = input else {
        return Err(Failure::usage(
            "this is a deck of a rotating blade; only towers can be swept",
        ));
    };
    let mut tower = *tower;
    if file != Path::new("-") {
        set_numbers(&mut tower, reading)?;
    }
    Ok(tower)
}

fn open(
    path: &Path,
    base: &TowerDescription,
    arguments: &SweepArguments,
) -> Result<Table, Failure> {
    Table::open(path, base, &arguments.ignore).map_err(Failure::from)
}
