//! The arguments of `calibrate`.

use std::path::PathBuf;

use clap::Args;
use towermodes::{MAX_SEGMENTS, Method, Options};

use super::found::FoundArguments;
use super::input::InputArguments;
use super::model::ModelArguments;
use super::parsers::{method_parser, number_parser};
use super::prescribed::Prescribed;

const EXAMPLES: &str = "Examples:
  towermodes calibrate tower.toml measured.toml
  towermodes calibrate tower.toml measured.toml --output fitted.toml
  towermodes calibrate tower.toml measured.toml --free rna.mass
  towermodes calibrate tower.toml measured.toml --format json

MEASURED is a TOML file with [[measured]] for each frequency and with the numbers to be fitted; for example:
  [calibrate.unknowns]
  \"rna.mass\" = { prior = [350e3, 5e3] }
  \"foundation.rocking\" = { bounds = [1e9, 1e12] }

  [[measured]]
  mode = \"fore-aft 1\"
  frequency = 0.2585
  deviation = 0.001

A prior has mean and standard deviation, a measurement frequency and standard deviation in Hz. The fit explains the measurements; it does not validate the model. `towermodes parameters FILE` lists the names of the numbers.

Exit codes: 0 the numbers are fitted, 1 the measurements do not determine them, the computation or the output failed, 2 wrong usage or wrong input.";

/// The arguments of `calibrate`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct CalibrateArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// What was measured and what is to be fitted: a TOML file with [[measured]]
    pub(crate) measured: PathBuf,

    /// Fit only these numbers, with the priors and bounds that MEASURED has for them [default: all
    /// of [calibrate.unknowns]]
    #[arg(long, value_name = "NAME,...")]
    free: Vec<String>,

    /// Method of computation [default: rmje-exact; bmodes for BModes decks]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,

    /// Number of segments (bmodes and spectral: elements) [default: as solve]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    segments: Option<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pub(crate) found: FoundArguments,
}

impl CalibrateArguments {
    /// The names of `--free`, separated by commas outside parentheses.
    pub(crate) fn free(&self) -> Vec<&str> {
        let names = self.free.iter().flat_map(|names| separated(names));
        names.filter(|name| !name.is_empty()).collect()
    }

    /// The options of the library.
    ///
    /// # Errors
    /// The message for an option that does not apply to the method.
    pub(crate) fn options(&self, prescribed: Prescribed) -> Result<Options, &'static str> {
        let options = prescribed.options(self.method, self.segments, &self.model)?;
        Ok(Options {
            points: 2,
            ..options
        })
    }
}

fn separated(names: &str) -> Vec<&str> {
    let mut depth = 0_i32;
    let is_end = |c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        c == ',' && depth <= 0
    };
    names.split(is_end).map(str::trim).collect()
}

#[cfg(test)]
mod tests {
    use super::separated;

    #[test]
    fn commas_in_parentheses_do_not_separate() {
        let names = separated("a.b, add(c, d),e");
        assert_eq!(names, ["a.b", "add(c, d)", "e"]);
    }
}
