//! `towermodes converge`.

use clap::Args;
use towermodes::{MAX_DEGREE, MAX_SEGMENTS, Method, Options, Tower};
use towermodes_analysis::study::{Fineness, STUDY_DEGREES, STUDY_SEGMENTS, converge};
use towermodes_files::{TowerInput, write_convergence_csv, write_result_json};

use crate::args::parsers::{method_parser, number_parser};
use crate::args::{Destination, Format, InputArguments, ModelArguments, csv_lines};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::recipe::{Analysis, Answer};
use crate::{table, terminal};

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
    input: InputArguments,

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
    destination: Destination,
}

impl ConvergeArguments {
    /// The numbers of segments, or the degrees of the method `spectral`.
    ///
    /// # Errors
    /// The message if the list does not apply to the method.
    fn fineness(&self) -> Result<Vec<Fineness>, &'static str> {
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

impl Analysis for ConvergeArguments {
    type Plan = Vec<Fineness>;

    fn files(&self) -> (&InputArguments, &Destination) {
        (&self.input, &self.destination)
    }

    fn check(&self, _: Format) -> Result<(), Failure> {
        self.fineness()?;
        Ok(())
    }

    fn plan(&self, _: &mut TowerInput) -> Result<Vec<Fineness>, Failure> {
        Ok(self.fineness()?)
    }

    /// Solves the tower on increasingly fine meshes.
    fn answer(
        &self,
        tower: &Tower,
        _: &TowerInput,
        fineness: Vec<Fineness>,
        format: Format,
    ) -> Result<Answer, Failure> {
        let options = self.model.in_place_of(Options {
            method: self.method,
            ..Options::default()
        });
        let progress = Progress::of_weighted(fineness.iter().copied().map(said));
        let mut solver = progress.solver(options);
        let convergence = converge(tower, &fineness, &mut solver, |_| progress.done());
        drop((solver, progress));
        let convergence = convergence?;
        let width = terminal::width_of(self.destination.output());
        let answer = Answer::of(
            format,
            || table::convergence(tower, &convergence, width),
            |json| write_result_json(&convergence, json),
            |csv| write_convergence_csv(&convergence, csv),
        )?;
        Ok(answer.warnings(&convergence.warnings))
    }
}

/// The label of a level, "80 segments", and its relative cost.
fn said(fineness: Fineness) -> (String, f64) {
    let text = match fineness {
        Fineness::Segments(segments) => format!("{segments} segments"),
        Fineness::Degree(degree) => format!("degree {degree}"),
    };
    (text, fineness.number() as f64)
}
