//! `towermodes verify`.

use clap::builder::PossibleValuesParser;
use clap::{Arg, Args, ValueEnum};
use towermodes_files::{write_records_csv, write_result_json};
use towermodes_verify::{CHAPTERS, Row, Verification, manual, markdown};

use crate::args::{Destination, Ending};
use crate::failure::Failure;
use crate::output::Finished;
use crate::progress::Progress;
use crate::table;

const EXAMPLES: &str = "Examples:
  towermodes verify
  towermodes verify paper bmodes
  towermodes verify --output verification.json

Exit codes: 0 all values are within their tolerance, or differ from a known misprint of their source (MISPRINT); 1 at least one is not, or the output failed; 2 wrong usage.";

/// The arguments of `verify`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, mut_arg("format", with_markdown))]
pub(crate) struct VerifyArguments {
    /// Chapters of the verification manual [default: all]
    #[arg(value_parser = chapter_parser())]
    chapters: Vec<String>,

    #[command(flatten)]
    destination: Destination<VerifyFormat>,
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
    const DEFAULT: Self = Self::Table;
}

fn with_markdown(format: Arg) -> Arg {
    format.help("Format of the result [default: from the extension of --output: .json, .csv, .md or .txt (table); otherwise the table]")
}

impl VerifyArguments {
    /// Whether a chapter is selected.
    pub(crate) fn has(&self, chapter: &str) -> bool {
        self.chapters.is_empty() || self.chapters.iter().any(|name| name == chapter)
    }
}

fn chapter_parser() -> PossibleValuesParser {
    PossibleValuesParser::new(CHAPTERS.map(|chapter| chapter.name))
}

/// Runs the verification manual and prints the results; an error if a value is outside its
/// tolerance.
pub(crate) fn run(arguments: &VerifyArguments) -> Result<(), Failure> {
    let format = arguments.destination.format()?;
    let mut cases = manual();
    cases.retain(|case| arguments.has(case.chapter.name));
    let progress = Progress::of(cases.iter().map(|case| case.name.to_string()));
    let mut rows: Vec<Row> = Vec::new();
    for case in cases {
        rows.extend(case.run());
        progress.done();
    }
    drop(progress);
    let verification = Verification::of(rows);
    let rows = &verification.rows;
    let result = match format {
        VerifyFormat::Table => Finished::Text(table::verification(rows)),
        VerifyFormat::Json => Finished::data(|json| write_result_json(&verification, json))?,
        VerifyFormat::Csv => Finished::data(|csv| {
            write_records_csv(Row::COLUMNS, rows.iter().map(Row::record), csv)
        })?,
        VerifyFormat::Markdown => Finished::Data(markdown(rows).into_bytes()),
    };
    result.deliver(arguments.destination.output())?;
    match verification.failures {
        0 => Ok(()),
        failures => Err(Failure::failed(format!(
            "{failures} of {} values are outside their tolerance",
            verification.values
        ))
        .hint("see the lines with FAIL above")),
    }
}
