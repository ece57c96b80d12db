//! The arguments of `convert`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::file_of;
use super::input::InputArguments;
use super::parsers::height_parser;

const EXAMPLES: &str = "Examples:
  towermodes convert deck.bmi --to toml --output tower.toml
  towermodes convert tower.toml --to bmodes --output tower.bmi
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
    #[arg(long, value_enum)]
    pub(crate) to: Target,

    /// Height at which the flexible tower of --to elastodyn begins, m [default: the tower's base]
    #[arg(long, value_name = "M", value_parser = height_parser)]
    pub(crate) from_height: Option<f64>,

    /// Write the result to a file instead of standard output (-); --to bmodes needs one
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

impl ConvertArguments {
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
