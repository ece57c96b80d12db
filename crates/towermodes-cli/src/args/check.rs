//! The arguments of `check`.

use std::path::PathBuf;

use clap::Args;

use super::elastodyn::ReportFormat;
use super::input::InputArguments;

const EXAMPLES: &str = "Examples:
  towermodes check tower.toml
  towermodes check IEA-15-240-RWT.yaml IEA_15MW_RWT_Tower_st.dat --part tower --tower-base 15
  towermodes check tower.toml Tower.dat --format json

Limits: mass 0.5 %, EI 1 %, frequencies 0.5 %; from half of that on a difference is warned of. Exit codes: 0 the descriptions agree, 1 they
do not, 2 wrong input.";

/// The arguments of `check`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct CheckArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Another description of the same tower, in any format
    pub(crate) other: Option<PathBuf>,

    /// How the result is printed
    #[arg(long, short, value_enum, default_value_t = ReportFormat::Table)]
    pub(crate) format: ReportFormat,
}
