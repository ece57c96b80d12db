//! The command line.

mod campbell;
mod check;
mod compare;
mod converge;
mod convert;
mod elastodyn;
mod ending;
mod input;
mod model;
mod parsers;
mod plot;
mod prescribed;
mod report;
mod rotor;
mod solve;
mod verify;

pub(crate) use campbell::CampbellArguments;
pub(crate) use check::CheckArguments;
pub(crate) use compare::CompareArguments;
pub(crate) use converge::{ConvergeArguments, DEFAULT_DEGREES, DEFAULT_SEGMENTS};
pub(crate) use convert::{ConvertArguments, Target};
pub(crate) use elastodyn::{
    DeckArguments, ElastoDynArguments, ElastoDynCommand, PatchArguments, ReportFormat,
    TowerArguments, ValidateArguments,
};
pub(crate) use ending::{Ending, EndingError};
pub(crate) use input::{InputArguments, ReadingArguments};
pub(crate) use plot::{PictureFormat, PlotArguments, What};
pub(crate) use prescribed::Prescribed;
pub(crate) use report::{PageFormat, ReportArguments};
pub(crate) use rotor::{ChosenRotor, RotorArguments};
pub(crate) use solve::{SolveArguments, SolveFormat};
pub(crate) use verify::{VerifyArguments, VerifyFormat};

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{Args, Parser, Subcommand, ValueEnum};

/// Natural frequencies and mode shapes of wind turbine towers, certified.
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

/// What the program does.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Find the lowest natural frequencies and mode shapes of a tower.
    Solve(SolveArguments),
    /// Put several methods side by side, with their differences to the exact beam, sizes and times.
    Compare(CompareArguments),
    /// Show how the error of a method falls as its segments get more.
    Converge(ConvergeArguments),
    /// Say how far the rotor's excitations stay from the natural frequencies: the Campbell diagram
    /// as a table.
    Campbell(CampbellArguments),
    /// Draw the tower, its mode shapes, its resonance diagram, or the errors of methods, as SVG or
    /// PNG.
    Plot(PlotArguments),
    /// Write the report that is handed over: input, assumptions, frequencies with errors, shapes
    /// that move, margins, as one HTML page or Markdown.
    Report(ReportArguments),
    /// Write a tower in another format: TOML, BModes, ElastoDyn, windIO.
    Convert(ConvertArguments),
    /// Compare two descriptions of one tower by height, or say what one describes.
    Check(CheckArguments),
    /// Make, mend and judge the tower files of ElastoDyn (OpenFAST).
    Elastodyn(ElastoDynArguments),
    /// Check the program against the values that are known from elsewhere.
    Verify(VerifyArguments),
    /// Print a completion script for a shell.
    #[command(
        after_help = "Example:\n  towermodes completions bash > ~/.local/share/bash-completion/completions/towermodes"
    )]
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
    /// Print the JSON schema of the result of a command with `--format json` (blade: of solve for a
    /// rotating blade; check-one: of check for one file; validate: of elastodyn validate).
    #[command(after_help = "Example:\n  towermodes schema solve > solve.schema.json")]
    Schema {
        /// The command.
        #[arg(default_value = "solve", value_parser = ["solve", "blade", "compare", "converge", "campbell", "check", "check-one", "validate", "verify"])]
        of: String,
    },
    /// Print the manual page, of the program or of one of its commands.
    #[command(after_help = "Example:\n  towermodes man solve | man -l -")]
    Man {
        /// The command.
        #[arg(value_parser = ["solve", "compare", "converge", "campbell", "plot", "report", "convert", "check", "elastodyn", "verify", "completions", "schema", "man"])]
        of: Option<String>,
    },
    /// Print every command with its arguments and options as a chapter of the book.
    #[command(
        hide = true,
        after_help = "Example:\n  towermodes reference > book/src/reference/command-line.md"
    )]
    Reference,
}

/// How a result is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people.
    Table,
    /// Everything there is, of solve the shapes too.
    Json,
    /// One line a mode, of campbell one a pair.
    Csv,
}

/// How and where a result goes.
#[derive(Debug, Args)]
pub(crate) struct Destination {
    /// How the result is written
    /// [default: as the ending of --output says: .json, .csv or .txt for the table; else the table]
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
    /// How the result is written: as told, or as the ending of the file says.
    ///
    /// # Errors
    /// The two do not go together, or the ending says nothing.
    pub(crate) fn format(&self) -> Result<Format, EndingError> {
        let asked = Format::asked(self.format, self.output())?;
        Ok(asked.unwrap_or(Format::Table))
    }

    /// The file the result goes to, if not to standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }
}

/// A path that is not `-`, which is standard output.
fn file_of(path: Option<&Path>) -> Option<&Path> {
    path.filter(|path| *path != Path::new("-"))
}

/// Prints help, or what is wrong with the command line; a file in place of a command gets the
/// command it needs.
pub(crate) fn report(error: &clap::Error) -> ExitCode {
    let _ = error.print();
    let file = std::env::args_os()
        .nth(1)
        .filter(|name| Path::new(name).is_file());
    if let (ErrorKind::InvalidSubcommand, Some(file)) = (error.kind(), file) {
        anstream::eprintln!(
            "\nto solve it: towermodes solve {}",
            Path::new(&file).display()
        );
    }
    ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2))
}
