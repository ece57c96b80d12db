//! The arguments of `check`.

use std::path::PathBuf;

use clap::Args;

use super::elastodyn::ReportFormat;
use super::input::InputArguments;

const EXAMPLES: &str = "Examples:
  towermodes check tower.toml
  towermodes check IEA-15-240-RWT.yaml IEA_15MW_RWT_Tower_st.dat --part tower --tower-base 15
  towermodes check tower.toml Tower.dat --format json

With two files: FAIL if mass, mass per length or a frequency differs by more than 0.5 %, the height of the centre of mass by more than 0.5 % of the height range that both models cover, or EI or the tower-top flexibility by more than 1 %; WARN above half of these limits. If the heights of the tower bases or of the tower tops differ: WARN, or FAIL if more than 1 % of the height of the longer tower is outside the height range of the other.

Exit codes: 0 verdict pass or warn; 1 verdict fail, or the computation or the output failed; 2 wrong usage or wrong input.";

/// The arguments of `check`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct CheckArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Second model of the same tower, in any format; without it the command summarises the first
    pub(crate) other: Option<PathBuf>,

    /// Format of the result
    #[arg(long, short, value_enum, default_value_t = ReportFormat::Table)]
    pub(crate) format: ReportFormat,
}
