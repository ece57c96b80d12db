//! The arguments of `solve`.

use std::path::PathBuf;

use clap::Args;
use towermodes::elements::GAUSS_HINGE_POSITION;
use towermodes::{
    DEFAULT_MODES, DEFAULT_POINTS, MAX_DEGREE, MAX_POINTS, MAX_SEGMENTS, Method, Options,
};

use super::parsers::{hinge_parser, method_parser, number_parser};
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
#[command(after_help = examples!(), after_long_help = LONG_HELP)]
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

    /// How many modes, from the lowest
    #[arg(long, value_name = "K", default_value_t = DEFAULT_MODES, value_parser = number_parser(1, usize::MAX))]
    modes: usize,

    /// At how many equal heights the JSON gives shapes
    #[arg(long, value_name = "COUNT", default_value_t = DEFAULT_POINTS, value_parser = number_parser(2, MAX_POINTS))]
    points: usize,

    /// Leave the rotary inertia of the sections out of bending: an Euler-Bernoulli beam
    #[arg(long)]
    no_rotary_inertia: bool,

    /// Where the hinges of --method cardanic sit, as a share of the segment from each end [default: 0.2113249, the Gauss points]
    #[arg(long, value_name = "SHARE", value_parser = hinge_parser)]
    hinges: Option<f64>,

    #[command(flatten)]
    pub(crate) destination: Destination,
}

impl SolveArguments {
    /// What the library is asked for.
    pub(crate) fn options(&self) -> Options {
        Options {
            method: self.method,
            segments: self.segments,
            degree: self.degree,
            modes: self.modes,
            // Only the JSON has shapes.
            points: if self.destination.format == Format::Json {
                self.points
            } else {
                2
            },
            rotary_inertia: !self.no_rotary_inertia,
            hinge_position: self.hinges.unwrap_or(GAUSS_HINGE_POSITION),
        }
    }
}
