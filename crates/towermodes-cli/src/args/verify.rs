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

Exit codes: 0 every value comes out, 1 one does not, 2 wrong usage.";

/// The arguments of `verify`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct VerifyArguments {
    /// Chapters of the manual [default: all]
    #[arg(value_parser = chapter_parser())]
    chapters: Vec<String>,

    /// How the manual is written
    /// [default: as the ending of --output says: .json, .csv, .md or .txt for the table; else the
    /// table]
    #[arg(long, short, value_enum)]
    format: Option<VerifyFormat>,

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

impl Ending for VerifyFormat {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("json", Self::Json),
        ("csv", Self::Csv),
        ("md", Self::Markdown),
        ("txt", Self::Table),
    ];
}

impl VerifyArguments {
    /// How the manual is written: as told, or as the ending of the file says.
    ///
    /// # Errors
    /// The two do not go together, or the ending says nothing.
    pub(crate) fn format(&self) -> Result<VerifyFormat, EndingError> {
        let asked = VerifyFormat::asked(self.format, self.output())?;
        Ok(asked.unwrap_or(VerifyFormat::Table))
    }

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
