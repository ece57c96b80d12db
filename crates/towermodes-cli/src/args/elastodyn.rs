//! The arguments of `elastodyn`.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand, ValueEnum};
use towermodes_analysis::elastodyn::{MAX_STATIONS, Rows};
use towermodes_files::elastodyn::{Damping, MakeOptions};

use super::file_of;
use super::input::{InputArguments, ReadingArguments};
use super::parsers::{damping_parser, height_parser, number_parser, openfast_parser};

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

/// What is done for ElastoDyn.
#[derive(Debug, Subcommand)]
pub(crate) enum ElastoDynCommand {
    /// Write a complete tower file of any tower: rows, damping, the polynomials of its mode shapes.
    Tower(TowerArguments),
    /// Put the polynomials of a deck's own modes into its tower file; every other byte stays.
    Patch(PatchArguments),
    /// Judge the polynomials of a deck by the tower's own modes; exit code 1 if they fail.
    Validate(ValidateArguments),
}

const TOWER_EXAMPLES: &str = "Examples:
  towermodes elastodyn tower tower.toml --output Tower.dat
  towermodes elastodyn tower tower.toml --damping 1.0 --openfast 4.2
  towermodes elastodyn tower IEA-15-240-RWT.yaml --from-height 15

What OpenFAST moves the tower by: φ(x) = Σ c_k x^k, k = 2 to 6, fitted to the modes of the tower with what it carries and stands on, the
motion of its base taken off. The fits and ElastoDyn's frequencies go to standard error.";

/// The arguments of `elastodyn tower`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = TOWER_EXAMPLES)]
pub(crate) struct TowerArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Height at which the flexible tower begins, m: TowerBsHt [default: its base]
    #[arg(long, value_name = "M", value_parser = height_parser)]
    from_height: Option<f64>,

    /// About so many rows [default: as many as keep mass and stiffness between rows right to 1e-6]
    #[arg(long, value_name = "N", value_parser = number_parser(2, MAX_STATIONS))]
    stations: Option<usize>,

    /// Damping wanted of the tower with what it carries, percent of critical: what is written makes
    /// ElastoDyn have it [default: 1 is written]
    #[arg(long, value_name = "PERCENT", value_parser = damping_parser)]
    damping: Option<f64>,

    /// Version of OpenFAST; 4.2 and newer list concentrated masses
    #[arg(long, value_name = "VERSION", default_value = "4.0", value_parser = openfast_parser)]
    openfast: (u32, u32),

    /// Elements of ElastoDyn's tower, TwrNodes, for its frequencies and for masses that are spread
    /// over one
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = number_parser(1, 100_000))]
    nodes: usize,

    /// Write the file here instead of to standard output (-)
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

impl TowerArguments {
    /// The file the result goes to, if not to standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }

    /// How the file is made.
    pub(crate) fn options(&self) -> MakeOptions {
        MakeOptions {
            from_m: self.from_height,
            rows: self.stations.map_or(Rows::Accurate, Rows::Count),
            has_concentrated_masses: self.openfast >= (4, 2),
            damping: self.damping.map_or(Damping::Written(1.0), Damping::Wanted),
            nodes: self.nodes,
            ..MakeOptions::default()
        }
    }
}

/// A deck, and where the modes come from.
#[derive(Debug, Args)]
pub(crate) struct DeckArguments {
    /// The main file of ElastoDyn, or the .fst that names it
    pub(crate) deck: PathBuf,

    /// Take the modes from this description of the same tower (any format, with its foundation)
    /// instead of the deck, whose tower is clamped at TowerBsHt
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

    /// Say what would change, and change nothing
    #[arg(long)]
    pub(crate) dry_run: bool,

    /// Print the change as a unified diff, and change nothing
    #[arg(long, conflicts_with = "dry_run")]
    pub(crate) diff: bool,

    /// Keep the tower file as it was beside the new one, with .bak at the end of its name
    #[arg(long, conflicts_with_all = ["dry_run", "diff"])]
    pub(crate) backup: bool,
}

const VALIDATE_EXAMPLES: &str = "Examples:
  towermodes elastodyn validate NREL5MW_ElastoDyn.dat
  towermodes elastodyn validate OC3_ElastoDyn.dat --from OC3Hywind.bmi --format json

A shape passes if it differs from the mode by no more than 1 % of its largest deflection (rms), MAC is at least 0.999 and ElastoDyn's
frequency of it is within 1 %; five times the difference, MAC 0.99 and 5 % are warned of, what is worse fails. Exit codes: 0 no shape
fails, 1 one fails, 2 wrong input.";

/// The arguments of `elastodyn validate`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = VALIDATE_EXAMPLES)]
pub(crate) struct ValidateArguments {
    #[command(flatten)]
    pub(crate) deck: DeckArguments,

    /// How the result is printed
    #[arg(long, short, value_enum, default_value_t = ReportFormat::Table)]
    pub(crate) format: ReportFormat,
}

/// How a judgement is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReportFormat {
    /// For people.
    Table,
    /// For programs.
    Json,
}
