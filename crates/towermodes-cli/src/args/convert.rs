//! The arguments of `convert`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::ending::{Ending, EndingError};
use super::file_of;
use super::input::InputArguments;
use super::parsers::height_parser;

const EXAMPLES: &str = "Examples:
  towermodes convert deck.bmi --output tower.toml
  towermodes convert tower.toml --output tower.bmi
  towermodes convert IEA-15-240-RWT.yaml --to elastodyn --output Tower.dat
  towermodes convert tower.toml --to windio

What the target cannot hold is said on standard error. A BModes deck is two files: the second one, of sections, stands beside the first.";

/// The arguments of `convert`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct ConvertArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// The format to write
    /// [default: as the ending of --output says: .toml, .bmi, .dat for a tower file of ElastoDyn,
    /// .yaml]
    #[arg(long, value_enum, required_unless_present = "output")]
    to: Option<Target>,

    /// Height at which the flexible tower of --to elastodyn begins, m [default: the tower's base]
    #[arg(long, value_name = "M", value_parser = height_parser)]
    pub(crate) from_height: Option<f64>,

    /// Write the result to a file instead of standard output (-); --to bmodes needs one
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
    /// The format to write: as told, or as the ending of the file says; none if neither says one.
    ///
    /// # Errors
    /// The two do not go together, or the ending says nothing.
    pub(crate) fn to(&self) -> Result<Option<Target>, EndingError> {
        Target::asked(self.to, self.output())
    }

    /// Refuses what would do nothing to the format.
    ///
    /// # Errors
    /// What is wrong.
    pub(crate) fn check(&self, to: Target) -> Result<(), &'static str> {
        if self.from_height.is_some() && to != Target::Elastodyn {
            return Err(
                "--from-height is for --to elastodyn; the other formats have the whole tower",
            );
        }
        Ok(())
    }

    /// The file the result goes to, if not to standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }
}

/// A format that towers are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Target {
    /// This program's own: holds everything.
    Toml,
    /// A deck of BModes 3.00.
    Bmodes,
    /// A tower file of ElastoDyn.
    Elastodyn,
    /// A turbine in windIO 2.0 with nothing but its tower and machine.
    #[value(name = "windio")]
    WindIo,
}
