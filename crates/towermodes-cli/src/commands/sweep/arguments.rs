//! The arguments of `sweep`.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::{Args, ValueEnum};
use towermodes::{MAX_SEGMENTS, Method, ModeName};
use towermodes_files::{SweepModes, SweepResults};
use towermodes_sweep::SliceFormat;

use crate::args::parsers::{method_parser, number_parser};
use crate::args::{Ending, EndingError, PictureFile, ReadingArguments, file_of};

const EXAMPLES: &str = "Examples:
  towermodes sweep tower.toml values.csv > frequencies.csv
  towermodes sweep study.toml --output results.csv --summary --plot frequencies.svg
  towermodes sweep study.toml --rows 0..50000 --output slice-0.csv
  towermodes sweep study.toml --check slice-*.csv --summary
  towermodes sweep study.toml --first-order

The columns of a table are names of input values: rna.mass replaces the value, scale(stations[*].wall) multiplies it, add(stations[*].height) adds to it; `towermodes parameters FILE` lists the names. A sweep study is a TOML file with [sweep]: base, sampling, distributions and correlations.

The results are one table, written as the rows are solved. A file gets its name when it is complete: a command that is interrupted leaves no file of this name. For many processors or hours of work, let each process write a slice of the rows (--rows) into a file of its own; existing files need not be computed again. --check reads the slices of one sweep: it refuses slices of another sweep and names the missing rows. If a row cannot be solved, its column `error` contains the error message.

Exit codes: 0 all rows are computed, possibly with rows that could not be solved (a warning gives their number), 1 the output failed, or with --check rows are missing or a slice is damaged, 2 wrong usage or wrong input. After Ctrl-C the exit status is 130.";

/// The arguments of `sweep`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct SweepArguments {
    /// The base tower, in any format; or a sweep study, a TOML file with [sweep]
    pub(crate) file: PathBuf,

    /// Table of values in CSV or Parquet, one row for each tower: the columns are names of
    /// input values; not with a sweep study
    pub(crate) table: Option<PathBuf>,

    /// Columns of the table that are not input values and are skipped, comma-separated
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub(crate) ignore: Vec<String>,

    /// Modes to report: a number K (the K lowest modes of the base tower), or names,
    /// comma-separated: 'fore-aft 1,torsion 1' [default: 4]
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

    /// Solve only the rows FIRST to END-1, numbered from 0; an END beyond the last row means the
    /// last row
    #[arg(long, value_name = "FIRST..END")]
    pub(crate) rows: Option<RowRange>,

    /// Write the results to this file; without --output they are printed as CSV
    #[arg(long, short, value_name = "PATH")]
    pub(crate) output: Option<PathBuf>,

    /// Format of the results [default: by the file extension, csv without one; with --first-order:
    /// table]
    #[arg(long, short, value_enum)]
    pub(crate) format: Option<SweepFormat>,

    /// Number of threads [default: the number of processors available to the process]
    #[arg(long, value_name = "N", value_parser = number_parser(1, 4096))]
    threads: Option<usize>,

    /// Omit the varied values from the results
    #[arg(long)]
    no_inputs: bool,

    /// Solve no rows, but read these files: refuse files that are not slices of this sweep, and
    /// name the missing rows
    #[arg(long = "check", value_name = "SLICES", num_args = 1..)]
    pub(crate) slices: Vec<PathBuf>,

    /// Print mean, standard deviation, quantiles, failed rows and, if the rotor is known, the share
    /// of the rows in which an excitation is closer than 5 % to a natural frequency
    #[arg(long)]
    pub(crate) summary: bool,

    /// Solve no rows, but print mean and standard deviation of each frequency from derivatives at
    /// the mean values of a study, the share of each varied input in the variance and, if the
    /// rotor is known, the probability that an excitation is closer than 5 % to the frequency
    #[arg(long)]
    pub(crate) first_order: bool,

    /// Draw the frequencies as SVG or PNG: with one varied input curves; with two, one of them with
    /// few values, a family of curves; otherwise histograms
    #[arg(long, value_name = "PATH")]
    pub(crate) plot: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) reading: ReadingArguments,
}

/// The format of the results, or of the scatter to first order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum SweepFormat {
    /// Text, for any program.
    Csv,
    /// Apache Parquet, smaller and faster to read.
    Parquet,
    /// With --first-order: human-readable table.
    Table,
    /// With --first-order: all digits, machine-readable.
    Json,
}

impl Ending for SweepFormat {
    const ENDINGS: &'static [(&'static str, Self)] =
        &[("csv", Self::Csv), ("parquet", Self::Parquet)];
    const DEFAULT: Self = Self::Csv;
}

/// Successive rows, as on the command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct RowRange {
    /// The first row, from 0.
    pub(crate) start: u64,
    /// The number after the last row.
    pub(crate) end: u64,
}

impl FromStr for RowRange {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || {
            format!(
                "`{text}` is not a range of rows; write FIRST..END, for example 0..50000 for the first 50000 rows"
            )
        };
        let (start, end) = text.split_once("..").ok_or_else(wrong)?;
        let number = |digits: &str| digits.trim().parse::<u64>().map_err(|_| wrong());
        let (start, end) = (number(start)?, number(end)?);
        match start < end {
            true => Ok(Self { start, end }),
            false => Err(format!(
                "there is no row in {text}; END is the row after the last one"
            )),
        }
    }
}

impl SweepArguments {
    /// The number of threads.
    pub(crate) fn threads(&self) -> usize {
        let available = || std::thread::available_parallelism().map_or(1, usize::from);
        self.threads.unwrap_or_else(available)
    }

    /// The requested results: these options, otherwise the options of the study.
    pub(crate) fn results(&self, study: SweepResults) -> SweepResults {
        SweepResults {
            modes: self.modes.clone().unwrap_or(study.modes),
            segments: self.segments.or(study.segments),
            method: self.method.or(study.method),
            rotary_inertia: study.rotary_inertia && !self.no_rotary_inertia,
            inputs: study.inputs && !self.no_inputs,
        }
    }

    /// The format of the results.
    ///
    /// # Errors
    /// A file extension of another format.
    pub(crate) fn slice_format(&self) -> Result<SliceFormat, EndingError> {
        // `check` refuses the formats of --first-order.
        Ok(match SweepFormat::asked(self.format, self.output())? {
            Some(SweepFormat::Parquet) => SliceFormat::Parquet,
            _ => SliceFormat::Csv,
        })
    }

    /// The file of the results; none for standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }

    /// The path of the picture with its format, if a picture is requested.
    pub(crate) fn picture(&self) -> Option<(&Path, PictureFile)> {
        let path = self.plot.as_deref()?;
        Some((path, PictureFile::of(path)?))
    }

    /// Checks the options that need a file, and the file extension of the picture.
    ///
    /// # Errors
    /// The message for an option that has no effect, or whose effect is impossible.
    pub(crate) fn check(&self) -> Result<(), &'static str> {
        if self.first_order {
            return self.check_first_order();
        }
        if matches!(self.format, Some(SweepFormat::Table | SweepFormat::Json)) {
            return Err(
                "--format table and json need --first-order; the results of rows are csv or parquet",
            );
        }
        if self.plot.is_some() && self.picture().is_none() {
            return Err(PictureFile::UNKNOWN);
        }
        if !self.slices.is_empty() {
            let of_solves =
                self.output.is_some() || self.format.is_some() || self.threads.is_some();
            return match of_solves {
                true => Err("--check solves no rows; omit --output, --format and --threads"),
                false => Ok(()),
            };
        }
        if self.output().is_some() {
            return Ok(());
        }
        let needs = [
            (
                self.summary,
                "--summary needs --output FILE or --check SLICES; standard output is the table of results",
            ),
            (
                self.plot.is_some(),
                "--plot needs --output FILE or --check SLICES; standard output is the table of results",
            ),
            (
                self.format == Some(SweepFormat::Parquet),
                "--format parquet needs --output FILE; standard output is CSV",
            ),
        ];
        let wrong = needs.into_iter().find(|(is_given, _)| *is_given);
        wrong.map_or(Ok(()), |(_, message)| Err(message))
    }
}

impl SweepArguments {
    /// Refuses options that apply only to rows and their results.
    fn check_first_order(&self) -> Result<(), &'static str> {
        let of_rows = [
            self.output.is_some(),
            self.rows.is_some(),
            self.threads.is_some(),
            self.no_inputs,
            !self.slices.is_empty(),
            self.summary,
            self.plot.is_some(),
        ];
        if of_rows.contains(&true) {
            return Err(
                "--first-order solves no rows; omit --output, --rows, --threads, --no-inputs, --check, --summary and --plot",
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

#[cfg(test)]
mod tests {
    use towermodes_files::SweepModes;

    use super::{RowRange, modes_parser};

    #[test]
    fn rows_are_a_range_without_its_end() {
        let found = "10..20".parse();
        assert_eq!(found, Ok(RowRange { start: 10, end: 20 }));
        for wrong in ["20..10", "5..5", "10-20", "10..", "..5", "a..b", "-1..4"] {
            assert!(wrong.parse::<RowRange>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn modes_are_a_number_or_names() {
        assert_eq!(modes_parser("6"), Ok(SweepModes::Lowest(6)));
        let named = modes_parser("fore-aft 1, torsion 1").expect("names");
        assert!(matches!(&named, SweepModes::Named(names) if names[1].to_string() == "torsion 1"));
        assert!(modes_parser("0").is_err());
        assert!(modes_parser("bending 1").is_err());
    }
}
