//! The command line.

mod calibrate;
mod campbell;
mod check;
mod compare;
mod converge;
mod convert;
mod damping;
mod deferred;
mod design;
mod elastodyn;
mod ending;
mod explore;
mod found;
mod input;
mod model;
mod parameters;
mod parsers;
mod picture;
mod plot;
mod prescribed;
mod report;
mod rotor;
mod sensitivities;
mod soil;
mod solve;
mod sweep;
mod turbine;
mod verify;
mod words;

pub(crate) use calibrate::CalibrateArguments;
pub(crate) use campbell::CampbellArguments;
pub(crate) use check::CheckArguments;
pub(crate) use compare::CompareArguments;
pub(crate) use converge::ConvergeArguments;
pub(crate) use convert::{ConvertArguments, Target};
pub(crate) use damping::DampingArguments;
pub(crate) use design::DesignArguments;
pub(crate) use elastodyn::{
    DeckArguments, ElastoDynArguments, ElastoDynCommand, PatchArguments, ReportFormat,
    TowerArguments, ValidateArguments,
};
pub(crate) use ending::{Ending, EndingError};
pub(crate) use explore::ExploreArguments;
pub(crate) use found::{FoundArguments, FoundFormat};
pub(crate) use input::{InputArguments, ReadingArguments};
pub(crate) use parameters::ParametersArguments;
pub(crate) use picture::PictureFile;
pub(crate) use plot::{PictureFormat, PlotArguments, What};
pub(crate) use prescribed::Prescribed;
pub(crate) use report::{PageFormat, ReportArguments};
pub(crate) use rotor::RotorArguments;
pub(crate) use sensitivities::SensitivitiesArguments;
pub(crate) use solve::{SolveArguments, SolveFormat};
pub(crate) use sweep::{SweepArguments, SweepFormat};
pub(crate) use turbine::TurbineArguments;
pub(crate) use verify::{VerifyArguments, VerifyFormat};

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Arg, Args, Parser, Subcommand, ValueEnum};

use deferred::Deferred;
use parsers::schema_parser;

/// Natural frequencies and mode shapes of wind turbine towers, with error estimates and a proof
/// that no mode is missing.
#[derive(Debug, Parser)]
#[command(
    name = "towermodes",
    version,
    after_help = "Example:\n  towermodes solve examples/nrel-5mw.toml"
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// The commands of the program.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Compute the lowest natural frequencies and mode shapes of a tower or of a rotating blade.
    Solve(Deferred<SolveArguments>),
    /// List the numbers of a tower by name, for --set and for sweeps.
    Parameters(Deferred<ParametersArguments>),
    /// Show which numbers of a tower its frequencies depend on, and what tolerances do.
    Sensitivities(Deferred<SensitivitiesArguments>),
    /// Solve a tower many times with changed numbers: the rows of a table, or of a study.
    Sweep(Deferred<SweepArguments>),
    /// Find the lightest tower whose frequencies are in given bands.
    Design(Deferred<DesignArguments>),
    /// Fit numbers of a tower to measured frequencies.
    Calibrate(Deferred<CalibrateArguments>),
    /// Compare methods: frequencies, differences from the reference solution, degrees of freedom,
    /// run time.
    Compare(Deferred<CompareArguments>),
    /// Show how the error of a method decreases as the number of segments increases.
    Converge(Deferred<ConvergeArguments>),
    /// Check resonance margins (Campbell diagram).
    Campbell(Deferred<CampbellArguments>),
    /// Compute the damping ratios of the modes from the loss factors of the parts of the tower, and
    /// the aerodynamic damping by the rotor.
    Damping(Deferred<DampingArguments>),
    /// Draw the tower, its mode shapes, its Campbell diagram or the errors of methods as SVG or
    /// PNG.
    Plot(Deferred<PlotArguments>),
    /// Write a report for review, as one HTML page or as Markdown: input, assumptions, frequencies
    /// with errors, mode shapes, resonance margins.
    Report(Deferred<ReportArguments>),
    /// Change the numbers of a tower by sliders on a page in the browser, and see its modes move.
    Explore(Deferred<ExploreArguments>),
    /// Convert a tower to another format: TOML, BModes, ElastoDyn, windIO.
    Convert(Deferred<ConvertArguments>),
    /// Compare two models of the same tower along its height, or summarise one model.
    Check(Deferred<CheckArguments>),
    /// Create, update and validate tower files of ElastoDyn (OpenFAST).
    Elastodyn(ElastoDynArguments),
    /// Check the program against published, analytical and independently computed values.
    Verify(Deferred<VerifyArguments>),
    /// Print a completion script for a shell.
    #[command(
        after_help = "Example:\n  towermodes completions bash > ~/.local/share/bash-completion/completions/towermodes"
    )]
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
    /// Print the JSON schema of the result that a command writes with `--format json`.
    #[command(after_help = "Example:\n  towermodes schema solve > solve.schema.json")]
    Schema {
        /// Name of the result
        #[arg(value_name = "RESULT", default_value = "solve", value_parser = schema_parser())]
        of: String,
    },
    /// Print the manual page of the program or of one of its commands.
    #[command(after_help = "Example:\n  towermodes man solve | man -l -")]
    Man {
        /// The command [default: the program].
        #[arg(value_name = "COMMAND", value_parser = ["solve", "parameters", "sensitivities", "sweep", "design", "calibrate", "compare", "converge", "campbell", "damping", "plot", "report", "explore", "convert", "check", "elastodyn", "verify", "completions", "schema", "man"])]
        of: Option<String>,
    },
    /// Print every command with its arguments and options as a chapter of the book.
    #[command(
        hide = true,
        after_help = "Example:\n  towermodes reference > book/src/reference/command-line.md"
    )]
    Reference,
}

/// The format of a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Human-readable table.
    Table,
    /// All results.
    Json,
    /// One line per value of the table.
    Csv,
}

/// The option `--format` of a command, with a description of the lines of its CSV.
pub(super) fn csv_lines(format: Arg, lines: &'static str) -> Arg {
    let described = |format: &Format| {
        let value = format.to_possible_value()?;
        Some(match format {
            Format::Csv => value.help(lines),
            _ => value,
        })
    };
    let values = Format::value_variants().iter().filter_map(described);
    let parser = PossibleValuesParser::new(values.collect::<Vec<_>>());
    format.value_parser(parser.try_map(|name| Format::from_str(&name, false)))
}

/// The format of a result and the file it is written to.
#[derive(Debug, Args)]
pub(crate) struct Destination {
    /// Format of the result
    /// [default: from the extension of --output: .json, .csv or .txt (table); otherwise the table]
    #[arg(long, short, value_enum)]
    format: Option<Format>,

    /// Write the result to a file instead of standard output (-)
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

impl Ending for Format {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("json", Self::Json),
        ("csv", Self::Csv),
        ("txt", Self::Table),
    ];
}

impl Destination {
    /// The format of the result: the option, or else the extension of the output file.
    ///
    /// # Errors
    /// The option and the extension contradict each other, or the extension is unknown.
    pub(crate) fn format(&self) -> Result<Format, EndingError> {
        let asked = Format::asked(self.format, self.output())?;
        Ok(asked.unwrap_or(Format::Table))
    }

    /// The file that the result is written to; none for standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }
}

/// The path of a file; none for `-`, which is standard output.
fn file_of(path: Option<&Path>) -> Option<&Path> {
    path.filter(|path| *path != Path::new("-"))
}

/// Prints the help or the error of the command line. If a file is given instead of a command, the
/// message shows the `solve` command for it. Returns the exit code.
pub(crate) fn report(error: &clap::Error, command_line: &[OsString]) -> u8 {
    let _ = error.print();
    let file = command_line.get(1);
    let file = file.filter(|name| Path::new(name).is_file());
    if let (ErrorKind::InvalidSubcommand, Some(file)) = (error.kind(), file) {
        anstream::eprintln!(
            "\nto solve it: towermodes solve {}",
            Path::new(file).display()
        );
    }
    u8::try_from(error.exit_code()).unwrap_or(2)
}
