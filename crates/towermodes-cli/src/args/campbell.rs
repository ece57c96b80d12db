//! The arguments of `campbell`.

use clap::Args;
use towermodes::{MAX_SEGMENTS, Method, Options};

use super::input::InputArguments;
use super::model::ModelArguments;
use super::parsers::{method_parser, number_parser};
use super::prescribed::Prescribed;
use super::rotor::RotorArguments;
use super::{Destination, Format};

const EXAMPLES: &str = "Examples:
  towermodes campbell examples/nrel-5mw.toml
  towermodes campbell tower.toml --rpm 7.5,12.1 --margin 10
  towermodes campbell NREL5MW_ElastoDyn.dat --rpm 12.1 --multiples 1,3,6 --format csv

Unless --modes says how many, modes are looked for as high as excitations count, 40 at most.
An excitation is a multiple n of the rotor's speed: nP. PASS, WARN or FAIL: 1P and the passing of the blades fail within the margin of a
mode of the tower and are warned of within twice the margin; higher multiples, and modes of blades, are warned of within the margin.
Exit codes: 0 nothing fails, 1 something does, 2 wrong usage or wrong input.";

/// The arguments of `campbell`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct CampbellArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// The method of the tower's frequencies [default: rmje-exact; bmodes for BModes decks]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,

    /// Segments, or elements [default: as of solve]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Option<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pub(crate) rotor: RotorArguments,

    /// Show every pair in the table, those too that are further apart than a factor 2
    #[arg(long)]
    pub(crate) all: bool,

    #[command(flatten)]
    pub(crate) destination: Destination,
}

impl CampbellArguments {
    /// How the tower is solved: as the command line says, as its file prescribes, or by default.
    ///
    /// # Errors
    /// What is wrong if an option means nothing to the method.
    pub(crate) fn options(&self, prescribed: Prescribed) -> Result<Options, &'static str> {
        let options = prescribed.options(self.method, self.segments, &self.model)?;
        // Nobody sees a shape.
        Ok(Options {
            points: 2,
            ..options
        })
    }

    /// Whether the number of modes is given.
    pub(crate) fn has_modes(&self) -> bool {
        self.model.has_modes()
    }

    /// Refuses what would do nothing.
    ///
    /// # Errors
    /// What is wrong.
    pub(crate) fn check(&self, format: Format) -> Result<(), &'static str> {
        if self.all && format != Format::Table {
            return Err("--all is for the table; JSON and CSV have every pair");
        }
        Ok(())
    }
}
