//! The arguments of `elastodyn`.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use towermodes_analysis::elastodyn::{Damping, MAX_STATIONS, MakeOptions, Rows};

use crate::args::parsers::{damping_parser, height_parser, number_parser, openfast_parser};
use crate::args::{Deferred, InputArguments, ReadingArguments, TextFormat, file_of};

const EXAMPLES: &str = "Examples:
  towermodes elastodyn tower tower.toml --output Tower.dat
  towermodes elastodyn patch NREL5MW_ElastoDyn.dat --diff
  towermodes elastodyn validate NREL5MW_ElastoDyn.dat";

/// The arguments of `elastodyn`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct ElastoDynArguments {
    #[command(subcommand)]
    pub(crate) command: ElastoDynCommand,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub(crate) enum ElastoDynCommand {
    /// Create a complete ElastoDyn tower file: distributed properties, damping, mode-shape
    /// polynomials.
    Tower(Deferred<TowerArguments>),
    /// Replace the mode-shape coefficients in the tower file of a deck by those of the computed
    /// modes; nothing else changes.
    Patch(Deferred<PatchArguments>),
    /// Compare the mode-shape polynomials of a deck with the computed modes; exit code 1 if the
    /// verdict is FAIL.
    Validate(Deferred<ValidateArguments>),
}

const TOWER_EXAMPLES: &str = "Examples:
  towermodes elastodyn tower tower.toml --output Tower.dat
  towermodes elastodyn tower tower.toml --damping 1.0 --openfast 4.2
  towermodes elastodyn tower IEA-15-240-RWT.yaml --from-height 15

The shape functions of OpenFAST are φ(x) = Σ c_k x^k, k = 2 to 6. They are fitted to the modes of the tower with RNA and foundation, after subtracting translation and rotation of the base. The quality of the fits and the frequencies that ElastoDyn computes with them are printed on standard error.";

/// The arguments of `elastodyn tower`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = TOWER_EXAMPLES)]
pub(crate) struct TowerArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Height at which the flexible tower begins, m (TowerBsHt) [default: the tower base]
    #[arg(long, value_name = "M", value_parser = height_parser)]
    from_height: Option<f64>,

    /// Approximate number of rows of the table of distributed properties
    /// [default: enough for a relative interpolation error of 1e-6 in mass and stiffness]
    #[arg(long, value_name = "N", value_parser = number_parser(2, MAX_STATIONS))]
    stations: Option<usize>,

    /// Target damping ratio of the tower with its RNA, percent of critical; the damping values in
    /// the written file are scaled so that ElastoDyn reaches it [default: no target; TwrFADmp and
    /// TwrSSDmp keep the values of the input file, or are 1 % if it has none; the damping ratio of
    /// the tower with RNA then differs from these values]
    #[arg(long, value_name = "PERCENT", value_parser = damping_parser)]
    damping: Option<f64>,

    /// Version of OpenFAST that will read the file; 4.2 and newer accept concentrated masses
    #[arg(long, value_name = "VERSION", default_value = "4.0", value_parser = openfast_parser)]
    openfast: (u32, u32),

    /// Number of tower elements in ElastoDyn (TwrNodes); used to compute the printed ElastoDyn
    /// frequencies and to distribute each point mass over one element
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = number_parser(1, 100_000))]
    nodes: usize,

    /// Write the result to a file instead of standard output (-)
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

impl TowerArguments {
    /// The file that the result is written to; none for standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }

    /// The options of the tower file; `otherwise` is the damping if no option gives it.
    pub(crate) fn options(&self, otherwise: Damping) -> MakeOptions {
        MakeOptions {
            from_m: self.from_height,
            rows: self.stations.map_or(Rows::Accurate, Rows::Count),
            has_concentrated_masses: self.openfast >= (4, 2),
            damping: self.damping.map_or(otherwise, Damping::Wanted),
            nodes: self.nodes,
            ..MakeOptions::default()
        }
    }
}

/// A deck and the source of the modes.
#[derive(Debug, Args)]
pub(crate) struct DeckArguments {
    /// ElastoDyn main file, or the .fst that refers to it
    pub(crate) deck: PathBuf,

    /// Compute the modes from this file, in any format, including its foundation. Without this
    /// option they are computed from the deck, with the tower clamped at TowerBsHt
    #[arg(long, value_name = "FILE")]
    pub(crate) from: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) reading: ReadingArguments,
}

const PATCH_EXAMPLES: &str = "Examples:
  towermodes elastodyn patch NREL5MW_ElastoDyn.dat --diff
  towermodes elastodyn patch NREL5MW_ElastoDyn.dat --backup
  towermodes elastodyn patch OC3_ElastoDyn.dat --from OC3Hywind.bmi --dry-run";

/// The arguments of `elastodyn patch`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = PATCH_EXAMPLES)]
pub(crate) struct PatchArguments {
    #[command(flatten)]
    pub(crate) deck: DeckArguments,

    /// Print the changes without writing them
    #[arg(long)]
    pub(crate) dry_run: bool,

    /// Print the changes as a unified diff without writing them
    #[arg(long, conflicts_with = "dry_run")]
    pub(crate) diff: bool,

    /// Save a copy of the old tower file with .bak appended to its name
    #[arg(long, conflicts_with_all = ["dry_run", "diff"])]
    pub(crate) backup: bool,
}

const VALIDATE_EXAMPLES: &str = "Examples:
  towermodes elastodyn validate NREL5MW_ElastoDyn.dat
  towermodes elastodyn validate OC3_ElastoDyn.dat --from OC3Hywind.bmi --format json

A shape passes if its rms difference from the mode is at most 1 % of the largest deflection, its MAC is at least 0.999, and ElastoDyn's tower frequency (without RNA) with this shape differs by at most 1 % from ElastoDyn's tower frequency with the polynomial fitted by this program. The limits for WARN are 5 %, MAC 0.99 and 5 %. Otherwise the shape fails. It also fails if the sum of its coefficients is not 1.

Exit codes: 0 no shape fails; 1 at least one shape fails, or the computation or the output failed; 2 wrong usage or wrong input.";

/// The arguments of `elastodyn validate`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = VALIDATE_EXAMPLES)]
pub(crate) struct ValidateArguments {
    #[command(flatten)]
    pub(crate) deck: DeckArguments,

    /// Format of the result
    #[arg(long, short, value_enum, default_value_t = TextFormat::Table)]
    pub(crate) format: TextFormat,
}
