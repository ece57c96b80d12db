//! The arguments of `design`.

use std::path::{Path, PathBuf};

use clap::Args;

use super::found::FoundArguments;
use super::input::InputArguments;
use super::picture::PictureFile;

const EXAMPLES: &str = "Examples:
  towermodes design tower.toml design.toml
  towermodes design tower.toml design.toml --output lighter.toml
  towermodes design tower.toml design.toml --format json
  towermodes design tower.toml design.toml --plot before-after.svg

A study is a TOML file with [design]; for example:
  [design.variables]
  \"stations[*].wall\" = { between = [0.012, 0.060], each = \"can\", order = \"falling\", step = 0.001 }
  \"scale(stations[*].diameter)\" = { between = [0.8, 1.2] }

  [design.frequencies]
  \"fore-aft 1\" = { between = \"1P-3P\", margin = 0.1 }
  \"side-side 1\" = { min = 0.25 }

  [design.limits]
  diameter_to_wall = 200
  cone_angle = 3

The lightest tower within these limits is found from exact derivatives, proved to be a minimum by its KKT residual (0 at an exact minimum) and solved once more. If no tower meets the limits, the message gives the nearest one. `towermodes parameters FILE` lists the names of the numbers.

Exit codes: 0 the tower is found, 1 no tower meets the limits, the computation or the output failed, 2 wrong usage or wrong input.";

/// The arguments of `design`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct DesignArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// What is chosen and what is to be reached: a TOML file with [design]
    pub(crate) study: PathBuf,

    #[command(flatten)]
    pub(crate) found: FoundArguments,

    /// Draw the tower before and after, with the bands of its frequencies (.svg or .png)
    #[arg(long, value_name = "PATH")]
    plot: Option<PathBuf>,
}

impl DesignArguments {
    /// The path of the picture with its format, if a picture is requested.
    ///
    /// # Errors
    /// The message for an unknown file extension.
    pub(crate) fn picture(&self) -> Result<Option<(&Path, PictureFile)>, &'static str> {
        PictureFile::requested(self.plot.as_deref())
    }
}
