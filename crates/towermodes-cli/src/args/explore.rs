//! The arguments of `explore`.

use clap::Args;
use towermodes::{MAX_SEGMENTS, Method, Options};
use towermodes_explore::POINTS;

use super::input::InputArguments;
use super::model::{ModelArguments, up_to_excitations};
use super::parsers::{method_parser, number_parser};
use super::prescribed::Prescribed;
use super::rotor::RotorArguments;
use super::words::valued;

const EXAMPLES: &str = "Examples:
  towermodes explore examples/monopile.toml
  towermodes explore turbine.yaml --part tower --rpm 5,7.56
  towermodes explore examples/nrel-5mw.toml --set rna.mass=360000

The program opens a page in the browser and serves it until Ctrl-C ends it. The page changes the numbers of the tower, and solves the tower with each change; the file stays as it is. --set changes numbers from the start; the page can put them back.

The page is served on this machine only, to who knows the token in its address, which the program prints. It needs no network.

Exit codes: 1 the port is taken, or the output failed; 2 wrong usage or wrong input.";

/// The arguments of `explore`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("modes", up_to_excitations))]
pub(crate) struct ExploreArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Method of computation [default: rmje-exact; bmodes for BModes decks]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,

    /// Number of segments (bmodes and spectral: elements) [default: same as solve]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Option<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pub(crate) rotor: RotorArguments,

    /// Port of this machine [default: any that is free]
    #[arg(long, value_name = "PORT")]
    pub(crate) port: Option<u16>,

    /// Print the address of the page, and do not open it in the browser
    #[arg(long)]
    pub(crate) no_open: bool,
}

impl ExploreArguments {
    /// The solver options: from the command line, else from the file, else the default.
    ///
    /// # Errors
    /// The message for an option that does not apply to the method.
    pub(crate) fn options(&self, prescribed: Prescribed) -> Result<Options, &'static str> {
        let options = prescribed.options(self.method, self.segments, &self.model)?;
        Ok(Options {
            points: POINTS,
            ..options
        })
    }

    /// Whether the number of modes is given.
    pub(crate) fn has_modes(&self) -> bool {
        self.model.has_modes()
    }

    /// The options of method and mesh that are given, as words of a command line.
    pub(crate) fn solving_words(&self) -> Vec<String> {
        [
            valued("--method", self.method.map(Method::name)),
            valued("--segments", self.segments),
            self.model.words(),
        ]
        .concat()
    }
}
