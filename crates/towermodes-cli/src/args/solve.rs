//! The arguments of `solve`.

use std::path::PathBuf;

use clap::Args;
use towermodes::{DEFAULT_POINTS, MAX_DEGREE, MAX_POINTS, MAX_SEGMENTS, Method, Options};

use super::model::ModelArguments;
use super::parsers::{method_parser, number_parser};
use super::{Destination, Format};

macro_rules! examples {
    () => {
        "Examples:
  towermodes solve tower.toml
  towermodes solve tower.toml --modes 20 --format json --output modes.json
  towermodes solve tower.toml --method rmje --segments 60
  towermodes solve tower.toml --method spectral --no-rotary-inertia
  generate-tower | towermodes solve - --format csv

Exit codes: 0 done, 1 the computation or the output failed, 2 wrong usage or wrong input."
    };
}

/// The examples after the file format in short, for those who have nothing but the program.
const LONG_HELP: &str = concat!(include_str!("tower-file.txt"), "\n", examples!());

/// The arguments of `solve`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = examples!(), after_long_help = LONG_HELP)]
pub(crate) struct SolveArguments {
    /// The tower (TOML); - is standard input
    pub(crate) file: PathBuf,

    /// Chains of rigid bodies: rmje and cardanic, as published or with exact tapered sections, and lumped as Adams models beams;
    /// bmodes, the finite element of BModes; spectral, the beam itself
    #[arg(long, default_value = Method::RmjeExact.name(), value_parser = method_parser())]
    method: Method,

    /// Segments, or elements [default: 100, and two for each short span between steps, kinks and masses; spectral: one a piece]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Option<usize>,

    /// Polynomial degree of the elements of --method spectral [default: raised until the modes stand still]
    #[arg(long, value_name = "P", value_parser = number_parser(2, MAX_DEGREE))]
    degree: Option<usize>,

    #[command(flatten)]
    model: ModelArguments,

    /// At how many equal heights the JSON gives shapes
    #[arg(long, value_name = "COUNT", default_value_t = DEFAULT_POINTS, value_parser = number_parser(2, MAX_POINTS))]
    points: usize,

    #[command(flatten)]
    pub(crate) destination: Destination,
}

impl SolveArguments {
    /// What the library is asked for.
    ///
    /// # Errors
    /// What is wrong if an option means nothing to the method.
    pub(crate) fn options(&self) -> Result<Options, &'static str> {
        self.model.check(self.method)?;
        if self.degree.is_some() && self.method != Method::Spectral {
            return Err("--degree is for --method spectral; the others have --segments");
        }
        Ok(Options {
            method: self.method,
            segments: self.segments,
            degree: self.degree,
            // Only the JSON has shapes.
            points: if self.destination.format == Format::Json {
                self.points
            } else {
                2
            },
            ..self.model.options()
        })
    }
}
