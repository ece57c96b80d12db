//! The arguments of `verify`.

use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use clap::{Args, ValueEnum};
use towermodes_verify::CHAPTERS;

use super::ending::{Ending, EndingError};
use super::file_of;

const EXAMPLES: &str = "Examples:
  towermodes verify
  towermodes verify paper bmodes
  towermodes verify --output verification.json

Exit codes: 0 all values are within their tolerance; 1 at least one is not, or the output failed; 2 wrong usage.";

/// The arguments of `verify`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct VerifyArguments {
    /// Chapters of the verification manual [default: all]
    #[arg(value_parser = chapter_parser())]
    chapters: Vec<String>,

    /// Format of the verification results
    /// [default: from the extension of --output: .json, .csv, .md or .txt (table); otherwise the
    /// table]
    #[arg(long, short, value_enum)]
    format: Option<VerifyFormat>,

    /// Write the results to a file instead of standard output (-)
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

/// The format of the verification results.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum VerifyFormat {
    /// Human-readable table.
    Table,
    /// All results.
    Json,
    /// One line per value.
    Csv,
    /// The verification chapter of the book.
    Markdown,
}

impl Ending for VerifyFormat {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("json", Self::Json),
        ("csv", Self::Csv),
        ("md", Self::Markdown),
        ("txt", Self::Table),
    ];
}

impl VerifyArguments {
    /// The format of the results: the option, or else the extension of the output file.
    ///
    /// # Errors
    /// The option and the extension contradict each other, or the extension is unknown.
    pub(crate) fn format(&self) -> Result<VerifyFormat, EndingError> {
        let asked = VerifyFormat::asked(self.format, self.output())?;
        Ok(asked.unwrap_or(VerifyFormat::Table))
    }

    /// Whether a chapter is selected.
    pub(crate) fn has(&self, chapter: &str) -> bool {
        self.chapters.is_empty() || self.chapters.iter().any(|name| name == chapter)
    }

    /// The file that the results are written to; none for standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }
}

fn chapter_parser() -> PossibleValuesParser {
    PossibleValuesParser::new(CHAPTERS.map(|chapter| chapter.name))
}
