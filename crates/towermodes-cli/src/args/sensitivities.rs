//! The arguments of `sensitivities`.

use std::path::{Path, PathBuf};

use clap::Args;
use towermodes::{MAX_SEGMENTS, Method, Options};
use towermodes_analysis::influence::Tolerance;

use super::input::InputArguments;
use super::model::ModelArguments;
use super::parsers::{method_parser, number_parser, tolerance_parser};
use super::picture::PictureFile;
use super::prescribed::Prescribed;
use super::{Destination, csv_lines};

const EXAMPLES: &str = "Examples:
  towermodes sensitivities tower.toml
  towermodes sensitivities tower.toml 'stations[*].wall' rna.mass --modes 2
  towermodes sensitivities tower.toml --tolerance 2% --tolerance rna.mass=10e3
  towermodes sensitivities tower.toml --plot tornado.svg
  towermodes sensitivities tower.toml --output sensitivities.json

The table has percent of each frequency per percent of each number; a percent of a height is one percent of the tower's height. With tolerances it has what each tolerance does, and what all do together.
NAME is a number by its name (towermodes parameters lists them), or a change of several: 'scale(stations[*].wall)'; by default every number.

Exit codes: 0 done, 1 the computation or the output failed, 2 wrong usage or wrong input.";

/// The arguments of `sensitivities`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("format", |of| csv_lines(of, "One line per number and mode")))]
pub(crate) struct SensitivitiesArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Numbers or changes of several [default: every number]
    #[arg(value_name = "NAME")]
    pub(crate) names: Vec<String>,

    /// Tolerance, plus or minus: 2% of every number but heights, NAME=2% or NAME=AMOUNT of one; may
    /// be repeated
    #[arg(long = "tolerance", value_name = "[NAME=]VALUE", value_parser = tolerance_parser)]
    pub(crate) tolerances: Vec<(Option<String>, Tolerance)>,

    /// List also the numbers that change no listed frequency by more than 0.0001 % per percent
    #[arg(long)]
    pub(crate) all: bool,

    /// Draw the influence of the numbers on the lowest mode as a tornado diagram (.svg or .png)
    #[arg(long, value_name = "PATH")]
    pub(crate) plot: Option<PathBuf>,

    /// Method of computation [default: rmje-exact; bmodes for BModes decks]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,

    /// Number of segments (bmodes and spectral: elements) [default: as solve]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Option<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pub(crate) destination: Destination,
}

/// Modes in the table by default: more columns do not fit into a terminal.
const MODES: usize = 4;

impl SensitivitiesArguments {
    /// The options of the library.
    ///
    /// # Errors
    /// The message for an option that does not apply to the method.
    pub(crate) fn options(&self, prescribed: Prescribed) -> Result<Options, &'static str> {
        let options = prescribed.options(self.method, self.segments, &self.model)?;
        Ok(Options {
            modes: self.model.modes.unwrap_or(MODES),
            points: 2,
            ..options
        })
    }

    /// The path of the picture with its format, if a picture is requested.
    ///
    /// # Errors
    /// The message for an unknown file extension.
    pub(crate) fn picture(&self) -> Result<Option<(&Path, PictureFile)>, &'static str> {
        PictureFile::requested(self.plot.as_deref())
    }
}
