//! The arguments of `compare`.

use clap::Args;
use towermodes::{MAX_SEGMENTS, Method, Options};
use towermodes_analysis::study::ColumnSpec;

use super::input::InputArguments;
use super::model::ModelArguments;
use super::parsers::{method_parser, number_parser};
use super::{Destination, csv_lines};

const EXAMPLES: &str = "Examples:
  towermodes compare tower.toml
  towermodes compare tower.toml --segments 20,40,60 --methods rmje,cardanic,bmodes
  towermodes compare tower.toml --no-rotary-inertia --format csv

Differences are relative differences from the reference solution (method spectral, accurate to about ten digits). The bmodes element has neither rotary inertia nor shear deformation; --no-rotary-inertia removes the rotary inertia from the other methods too, but not the shear deformation.";

/// Default numbers of segments or elements.
const DEFAULT_SEGMENTS: [usize; 1] = [60];

/// The arguments of `compare`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("format", |of| csv_lines(of, "One line per mode and column of the table")))]
pub(crate) struct CompareArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Methods, comma-separated [default: all]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = method_parser())]
    methods: Vec<Method>,

    /// Numbers of segments or elements, comma-separated; not used by spectral [default: 60]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Vec<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pub(crate) destination: Destination,
}

impl CompareArguments {
    /// The options for all methods.
    pub(crate) fn options(&self) -> Options {
        self.model.options()
    }

    /// Checks that each option applies to at least one of the methods.
    ///
    /// # Errors
    /// The message for an option that does not.
    pub(crate) fn check(&self) -> Result<(), &'static str> {
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
                "--segments does not apply to --methods spectral, which chooses its own elements",
            );
        }
        Ok(())
    }

    /// The columns: each method with each number of segments, `spectral` once.
    pub(crate) fn columns(&self) -> Vec<ColumnSpec> {
        let methods = if self.methods.is_empty() {
            &Method::ALL[..]
        } else {
            &self.methods
        };
        let segments = match &self.segments[..] {
            [] => &DEFAULT_SEGMENTS[..],
            given => given,
        };
        let columns_of = |&method: &Method| {
            let own = method == Method::Spectral;
            let segments = if own { &segments[..1] } else { segments };
            segments.iter().map(move |&segments| ColumnSpec {
                method,
                segments: (!own).then_some(segments),
            })
        };
        methods.iter().flat_map(columns_of).collect()
    }
}
