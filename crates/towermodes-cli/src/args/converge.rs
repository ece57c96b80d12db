//! The arguments of `converge`.

use clap::Args;
use towermodes::{MAX_DEGREE, MAX_SEGMENTS, Method, Options};
use towermodes_analysis::study::{Fineness, STUDY_DEGREES, STUDY_SEGMENTS};

use super::input::InputArguments;
use super::model::ModelArguments;
use super::parsers::{method_parser, number_parser};
use super::{Destination, csv_lines};

const EXAMPLES: &str = "Examples:
  towermodes converge tower.toml --method rmje
  towermodes converge tower.toml --method cardanic-exact --segments 10,20,40,80 --no-rotary-inertia
  towermodes converge tower.toml --method spectral --degrees 4,6,8,10

Errors are relative to the reference solution (method spectral); for bmodes the reference solution has no rotary inertia, because the element of BModes has none.";

/// The arguments of `converge`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("format", |of| csv_lines(of, "One line per mode and mesh")))]
pub(crate) struct ConvergeArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Method of computation
    #[arg(long, default_value = Method::RmjeExact.name(), value_parser = method_parser())]
    method: Method,

    /// Numbers of segments or elements, comma-separated [default: 10,20,40,80,160,320]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Vec<usize>,

    /// Polynomial degrees of --method spectral, comma-separated [default: 4,6,8,10,12,14]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = number_parser(2, MAX_DEGREE))]
    degrees: Vec<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pub(crate) destination: Destination,
}

impl ConvergeArguments {
    /// The solver options.
    pub(crate) fn options(&self) -> Options {
        Options {
            method: self.method,
            ..self.model.options()
        }
    }

    /// The numbers of segments, or the degrees of the method `spectral`.
    ///
    /// # Errors
    /// The message if the list does not apply to the method.
    pub(crate) fn fineness(&self) -> Result<Vec<Fineness>, &'static str> {
        self.model.check(self.method)?;
        let is_spectral = self.method == Method::Spectral;
        match (
            is_spectral,
            self.segments.is_empty(),
            self.degrees.is_empty(),
        ) {
            (true, false, _) => {
                Err("--segments does not apply to --method spectral; use --degrees")
            }
            (false, _, false) => Err(
                "--degrees applies only to --method spectral; use --segments for the other methods",
            ),
            (true, ..) => Ok(listed(&self.degrees, &STUDY_DEGREES, Fineness::Degree)),
            (false, ..) => Ok(listed(&self.segments, &STUDY_SEGMENTS, Fineness::Segments)),
        }
    }
}

/// The given numbers, or the default.
fn listed(given: &[usize], default: &[usize], kind: fn(usize) -> Fineness) -> Vec<Fineness> {
    let numbers = if given.is_empty() { default } else { given };
    numbers.iter().map(|&number| kind(number)).collect()
}
