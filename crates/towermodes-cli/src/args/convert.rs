//! The arguments of `convert`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use towermodes_files::OutputFormat;

use super::ending::{Ending, EndingError};
use super::file_of;
use super::input::InputArguments;
use super::parsers::height_parser;

const EXAMPLES: &str = "Examples:
  towermodes convert deck.bmi --output tower.toml
  towermodes convert tower.toml --output tower.bmi
  towermodes convert IEA-15-240-RWT.yaml --to elastodyn --output Tower.dat
  towermodes convert tower.toml --to windio

Data that the target format cannot store are reported on standard error. A BModes deck consists of two files: the section file is written to the same folder.

Exit codes: 0 done; 1 the tower cannot be written in this format, or the output failed; 2 wrong usage or wrong input.";

/// The arguments of `convert`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct ConvertArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Format to write
    /// [default: from the extension of --output: .toml, .bmi, .dat (ElastoDyn tower file), .yaml]
    #[arg(long, value_enum, required_unless_present = "output")]
    to: Option<Target>,

    /// Height at which the flexible tower begins, m; only for --to elastodyn
    /// [default: the tower base]
    #[arg(long, value_name = "M", value_parser = height_parser)]
    pub(crate) from_height: Option<f64>,

    /// Write the result to a file instead of standard output (-); required for --to bmodes
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

impl Ending for Target {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("toml", Self::Toml),
        ("bmi", Self::Bmodes),
        ("dat", Self::Elastodyn),
        ("yaml", Self::WindIo),
        ("yml", Self::WindIo),
    ];
    const OPTION: &'static str = "--to";
}

impl ConvertArguments {
    /// The format to write: the option, or else the extension of the output file; none if neither
    /// gives one.
    ///
    /// # Errors
    /// The option and the extension contradict each other, or the extension is unknown.
    pub(crate) fn to(&self) -> Result<Option<Target>, EndingError> {
        Target::asked(self.to, self.output())
    }

    /// Checks that the options apply to the format.
    ///
    /// # Errors
    /// The message for an option that does not.
    pub(crate) fn check(&self, to: Target) -> Result<(), &'static str> {
        if self.from_height.is_some() && to != Target::Elastodyn {
            return Err(
                "--from-height applies only to --to elastodyn; the other formats contain the whole tower",
            );
        }
        Ok(())
    }

    /// The file that the result is written to; none for standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }
}

/// A format to write towers in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Target {
    /// The tower file of this program; stores all data.
    Toml,
    /// BModes 3.00 deck.
    Bmodes,
    /// ElastoDyn tower file.
    Elastodyn,
    /// windIO 2.0 turbine that contains only tower and RNA.
    #[value(name = "windio")]
    WindIo,
}

impl Target {
    /// The format of the library.
    pub(crate) fn format(self) -> OutputFormat {
        match self {
            Self::Toml => OutputFormat::Toml,
            Self::Bmodes => OutputFormat::Bmodes,
            Self::Elastodyn => OutputFormat::ElastoDyn,
            Self::WindIo => OutputFormat::WindIo,
        }
    }
}
