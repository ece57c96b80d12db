//! The arguments of `sweep`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use towermodes::{MAX_SEGMENTS, Method, ModeName};
use towermodes_files::{SweepModes, SweepResults};
use towermodes_sweep::{MAX_ROWS_PER_PART, PartFormat, Shard, ShardError};

use super::input::ReadingArguments;
use super::parsers::{method_parser, number_parser};
use super::picture::PictureFile;

const EXAMPLES: &str = "Examples:
  towermodes sweep tower.toml values.csv > frequencies.csv
  towermodes sweep tower.toml values.csv --output results/ --summary --plot frequencies.svg
  towermodes sweep study.toml --output more-results/ --modes 6
  towermodes sweep study.toml --first-order

The columns of a table are names of numbers: rna.mass replaces the number, scale(stations[*].wall) multiplies it, add(stations[*].height) adds to it; `towermodes parameters FILE` lists the names. A study is a TOML file with [sweep]: base, sampling, distributions and correlations.

With --output the results are files. Each file has a part of the rows and is written completely or not at all. If the sweep was interrupted, the same command computes what is missing; several processes and machines may share the folder (--shard). If the folder is complete, nothing is computed: --summary and --plot show its results. A row that cannot be solved has the error message in the column error.

Exit codes: 0 all rows are computed, possibly with rows that could not be solved (a warning gives the number of those computed by this command, --summary that of all), 1 the output failed, or another program changed the folder, 2 wrong usage or wrong input. Ctrl-C ends the program by its signal; shells show 130.";

/// The arguments of `sweep`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct SweepArguments {
    /// The tower that is varied, in any format; or a study, a TOML file with [sweep]
    pub(crate) file: PathBuf,

    /// Table of values in CSV or Parquet, one row for each tower: the columns are names of numbers;
    /// not with a study
    pub(crate) table: Option<PathBuf>,

    /// Columns of the table that are not numbers of the tower and are left out, comma-separated
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub(crate) ignore: Vec<String>,

    /// Modes with columns in the results: how many of the lowest modes of the tower that is varied,
    /// or their names, comma-separated: 'fore-aft 1,torsion 1' [default: 4]
    #[arg(long, value_name = "K or NAMES", value_parser = modes_parser)]
    modes: Option<SweepModes>,

    /// Method of computation [default: rmje-exact; bmodes for BModes decks]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,

    /// Number of segments (bmodes and spectral: elements); the frequencies are extrapolated from
    /// several meshes, except with spectral [default: 20; spectral: one per part of the tower;
    /// BModes decks with bmodes: the elements of the deck]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Option<usize>,

    /// Neglect the rotary inertia of the sections in bending
    #[arg(long)]
    no_rotary_inertia: bool,

    /// Write the results to this folder, in parts; without it they are printed as CSV
    #[arg(long, short, value_name = "FOLDER")]
    pub(crate) output: Option<PathBuf>,

    /// Format of the parts [default: parquet if this program is built with it, otherwise csv]; of
    /// --first-order [default: table]
    #[arg(long, short, value_enum)]
    pub(crate) format: Option<SweepFormat>,

    /// Rows of each part [default: 16384]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_ROWS_PER_PART as usize))]
    rows_per_part: Option<usize>,

    /// Compute only shard I of N: the parts are divided into N equal shards, I is from 0 to N-1;
    /// for a job array
    #[arg(long, value_name = "I/N", value_parser = shard_parser)]
    pub(crate) shard: Option<Shard>,

    /// Number of threads [default: the processors that are available to the process]
    #[arg(long, value_name = "N", value_parser = number_parser(1, 4096))]
    threads: Option<usize>,

    /// Omit the varied values from the results
    #[arg(long)]
    no_inputs: bool,

    /// Remove the results in the folder and compute all rows again
    #[arg(long)]
    pub(crate) force: bool,

    /// Print mean, standard deviation, quantiles, failed rows and, if the rotor is known, the share
    /// of the rows in which an excitation is closer than 5 % to a natural frequency
    #[arg(long)]
    pub(crate) summary: bool,

    /// Solve no rows, but print mean and standard deviation of each frequency from derivatives at
    /// the mean values of a study, the share of each varied number in the variance and, if the
    /// rotor is known, the probability that an excitation is closer than 5 %
    #[arg(long)]
    pub(crate) first_order: bool,

    /// Draw the frequencies as SVG or PNG: curves for one varied number, or for two of which one
    /// has few values, histograms for more
    #[arg(long, value_name = "PATH")]
    pub(crate) plot: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) reading: ReadingArguments,
}

/// The format of the parts, or of the scatter to first order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum SweepFormat {
    /// Text, for any program.
    Csv,
    /// Apache Parquet, smaller and faster to read.
    Parquet,
    /// With --first-order: for people.
    Table,
    /// With --first-order: all digits, for other programs.
    Json,
}

impl SweepArguments {
    /// The number of threads.
    pub(crate) fn threads(&self) -> usize {
        let available = || std::thread::available_parallelism().map_or(1, usize::from);
        self.threads.unwrap_or_else(available)
    }

    /// What is computed and written: these options, else those of a study.
    pub(crate) fn results(&self, study: SweepResults) -> SweepResults {
        let rows_per_part = self.rows_per_part.map(|rows| rows as u64);
        SweepResults {
            modes: self.modes.clone().unwrap_or(study.modes),
            segments: self.segments.or(study.segments),
            method: self.method.or(study.method),
            rotary_inertia: study.rotary_inertia && !self.no_rotary_inertia,
            inputs: study.inputs && !self.no_inputs,
            rows_per_part: rows_per_part.or(study.rows_per_part),
        }
    }

    /// The format of the parts.
    pub(crate) fn part_format(&self) -> PartFormat {
        match self.format {
            Some(SweepFormat::Csv) => PartFormat::Csv,
            Some(SweepFormat::Parquet) => PartFormat::Parquet,
            None if cfg!(feature = "parquet") => PartFormat::Parquet,
            // `check` refuses the formats of --first-order.
            _ => PartFormat::Csv,
        }
    }

    /// The folder of the results; none for standard output.
    pub(crate) fn folder(&self) -> Option<&Path> {
        super::file_of(self.output.as_deref())
    }

    /// The path of the picture with its format, if a picture is requested.
    pub(crate) fn picture(&self) -> Option<(&Path, PictureFile)> {
        let path = self.plot.as_deref()?;
        Some((path, PictureFile::of(path)?))
    }

    /// Checks the options that need a folder, and the file extension of the picture.
    ///
    /// # Errors
    /// The message for an option that has no effect, or cannot have the requested one.
    pub(crate) fn check(&self) -> Result<(), &'static str> {
        if self.first_order {
            return self.check_first_order();
        }
        if matches!(self.format, Some(SweepFormat::Table | SweepFormat::Json)) {
            return Err(
                "--format table and json need --first-order; the results of rows are csv or parquet",
            );
        }
        if self.folder().is_some() {
            return match self.plot.is_some() && self.picture().is_none() {
                true => Err(PictureFile::UNKNOWN),
                false => Ok(()),
            };
        }
        let needs = [
            (
                self.shard.is_some(),
                "--shard needs --output FOLDER, which all shards write to",
            ),
            (
                self.summary,
                "--summary needs --output FOLDER; standard output is the table of results",
            ),
            (
                self.plot.is_some(),
                "--plot needs --output FOLDER; standard output is the table of results",
            ),
            (self.force, "--force needs --output FOLDER"),
            (
                self.rows_per_part.is_some(),
                "--rows-per-part needs --output FOLDER",
            ),
            (
                self.format == Some(SweepFormat::Parquet),
                "--format parquet needs --output FOLDER; standard output is CSV",
            ),
        ];
        let wrong = needs.into_iter().find(|(is_given, _)| *is_given);
        wrong.map_or(Ok(()), |(_, message)| Err(message))
    }
}

impl SweepArguments {
    /// Refuses options for rows and their results.
    fn check_first_order(&self) -> Result<(), &'static str> {
        let of_rows = [
            self.output.is_some(),
            self.rows_per_part.is_some(),
            self.shard.is_some(),
            self.threads.is_some(),
            self.no_inputs,
            self.force,
            self.summary,
            self.plot.is_some(),
        ];
        if of_rows.contains(&true) {
            return Err(
                "--first-order solves no rows; omit --output, --rows-per-part, --shard, --threads, --no-inputs, --force, --summary and --plot",
            );
        }
        if matches!(self.format, Some(SweepFormat::Csv | SweepFormat::Parquet)) {
            return Err("--first-order has the formats table and json");
        }
        match self.table.is_some() {
            true => Err(
                "--first-order needs a study with distributions in [sweep.vary]; the rows of a table have none",
            ),
            false => Ok(()),
        }
    }
}

/// The names of modes, or their number.
fn modes_parser(text: &str) -> Result<SweepModes, String> {
    if let Ok(count) = text.trim().parse::<usize>() {
        return match count {
            0 => Err("must be at least 1".to_owned()),
            count => Ok(SweepModes::Lowest(count)),
        };
    }
    let name = |name: &str| {
        name.trim()
            .parse::<ModeName>()
            .map_err(|error| error.to_string())
    };
    let names: Result<Vec<ModeName>, String> = text.split(',').map(name).collect();
    names.map(SweepModes::Named)
}

/// A shard of the parts.
fn shard_parser(text: &str) -> Result<Shard, String> {
    text.parse().map_err(|error: ShardError| error.to_string())
}

#[cfg(test)]
mod tests {
    use towermodes_files::SweepModes;

    use super::modes_parser;

    #[test]
    fn modes_are_a_number_or_names() {
        assert_eq!(modes_parser("6"), Ok(SweepModes::Lowest(6)));
        let named = modes_parser("fore-aft 1, torsion 1").expect("names");
        assert!(matches!(&named, SweepModes::Named(names) if names[1].to_string() == "torsion 1"));
        assert!(modes_parser("0").is_err());
        assert!(modes_parser("bending 1").is_err());
    }
}
