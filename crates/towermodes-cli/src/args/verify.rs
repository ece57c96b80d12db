//! The arguments of `verify`.

use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use clap::{Args, ValueEnum};
use towermodes_verify::CHAPTERS;

use super::file_of;

const EXAMPLES: &str = "Examples:
  towermodes verify
  towermodes verify paper bmodes
  towermodes verify --format json --output verification.json

Exit codes: 0 every value comes out, 1 one does not, 2 wrong usage.";

/// The arguments of `verify`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct VerifyArguments {
    /// Chapters of the manual [default: all]
    #[arg(value_parser = chapter_parser())]
    chapters: Vec<String>,

    /// How the manual is printed
    #[arg(long, short, value_enum, default_value_t = VerifyFormat::Table)]
    pub(crate) format: VerifyFormat,

    /// Write the manual to a file instead of standard output (-)
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

/// How the manual is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum VerifyFormat {
    /// For people.
    Table,
    /// Everything, for programs.
    Json,
    /// One line a value.
    Csv,
    /// As the chapter of the book.
    Markdown,
}

impl VerifyArguments {
    /// Whether a chapter was asked for.
    pub(crate) fn has(&self, chapter: &str) -> bool {
        self.chapters.is_empty() || self.chapters.iter().any(|name| name == chapter)
    }

    /// The file the manual goes to, if not to standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }
}

fn chapter_parser() -> PossibleValuesParser {
    PossibleValuesParser::new(CHAPTERS.map(|chapter| chapter.name))
}
