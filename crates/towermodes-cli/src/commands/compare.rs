//! `towermodes compare`.

use std::time::{Duration, Instant};

use clap::Args;
use towermodes::{MAX_SEGMENTS, Method, Options, Solver, Tower};
use towermodes_analysis::study::{ColumnSpec, compare};
use towermodes_files::{TowerInput, write_comparison_csv, write_result_json};

use crate::args::parsers::{method_parser, number_parser};
use crate::args::{Destination, Format, InputArguments, ModelArguments, csv_lines};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::recipe::{Analysis, Answer};
use crate::side_by_side::columns_in_words;
use crate::table;

const EXAMPLES: &str = "Examples:
  towermodes compare tower.toml
  towermodes compare tower.toml --segments 20,40,60 --methods rmje,cardanic,bmodes
  towermodes compare tower.toml --no-rotary-inertia --format csv

Differences are relative differences from the reference solution (method spectral, accurate to about ten digits). The bmodes element has neither rotary inertia nor shear deformation; --no-rotary-inertia removes the rotary inertia from the other methods too, but not the shear deformation. Other commands have other default numbers of segments: solve 100, sweep 20.";

/// Default numbers of segments or elements.
const DEFAULT_SEGMENTS: [usize; 1] = [60];

/// The arguments of `compare`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("format", |of| csv_lines(of, "One line per mode and column of the table")))]
pub(crate) struct CompareArguments {
    #[command(flatten)]
    input: InputArguments,

    /// Methods, comma-separated [default: all]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = method_parser())]
    methods: Vec<Method>,

    /// Numbers of segments or elements, comma-separated; not used by spectral [default: 60]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Vec<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    destination: Destination,
}

impl CompareArguments {
    /// The columns: each method with each number of segments, `spectral` once.
    fn columns(&self) -> Vec<ColumnSpec> {
        let methods = if self.methods.is_empty() {
            &Method::ALL[..]
        } else {
            &self.methods
        };
        let segments = match &self.segments[..] {
            [] => &DEFAULT_SEGMENTS[..],
            given => given,
        };
        ColumnSpec::each(methods, segments)
    }
}

/// A column is timed for at least this time …
const TIMING: Duration = Duration::from_millis(20);
/// … and at least this number of times …
const FEWEST_TIMINGS: usize = 3;
/// … unless this time is exceeded.
const LONG: Duration = Duration::from_secs(1);

impl Analysis for CompareArguments {
    type Plan = ();

    fn files(&self) -> (&InputArguments, &Destination) {
        (&self.input, &self.destination)
    }

    /// Each option applies to at least one of the methods.
    fn check(&self, _: Format) -> Result<(), Failure> {
        let has = |method: Method| self.methods.is_empty() || self.methods.contains(&method);
        if !has(Method::Cardanic) {
            self.model.check(self.methods[0])?;
        }
        let is_spectral_alone = !self.methods.is_empty()
            && self
                .methods
                .iter()
                .all(|method| *method == Method::Spectral);
        if is_spectral_alone && !self.segments.is_empty() {
            return Err(
                "--segments does not apply to --methods spectral, which chooses its own elements"
                    .into(),
            );
        }
        Ok(())
    }

    fn plan(&self, _: &mut TowerInput) -> Result<(), Failure> {
        Ok(())
    }

    /// Solves the tower with every method.
    fn answer(
        &self,
        tower: &Tower,
        _: &TowerInput,
        (): (),
        format: Format,
    ) -> Result<Answer, Failure> {
        let columns = self.columns();
        let progress = Progress::of(columns_in_words(&columns));
        let mut solver = progress.solver(self.model.in_place_of(Options::default()));
        let comparison = compare(tower, &columns, &mut solver, |column, options| {
            column.seconds_per_solve = Some(time_of(tower, options).as_secs_f64());
            progress.done();
        });
        drop((solver, progress));
        let comparison = comparison?;
        let answer = Answer::of(
            format,
            || table::comparison(tower, &comparison),
            |json| write_result_json(&comparison, json),
            |csv| write_comparison_csv(&comparison, csv),
        )?;
        Ok(answer.warnings(&comparison.warnings))
    }
}

/// The time of the fastest of several solves with reused memory.
fn time_of(tower: &Tower, options: &Options) -> Duration {
    let mut solver = Solver::new(options.clone());
    let mut fastest = Duration::MAX;
    let started = Instant::now();
    let mut timings = 0;
    while (timings < FEWEST_TIMINGS && started.elapsed() < LONG) || started.elapsed() < TIMING {
        let start = Instant::now();
        // The same solve has succeeded before.
        let _ = solver.solve(tower);
        fastest = fastest.min(start.elapsed());
        timings += 1;
    }
    fastest
}
