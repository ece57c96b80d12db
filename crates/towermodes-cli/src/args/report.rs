//! The arguments of `report`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use towermodes::{MAX_SEGMENTS, Method, Options};
use towermodes_report::report::TitleBlock;

use super::ending::{Ending, EndingError};
use super::file_of;
use super::input::InputArguments;
use super::model::ModelArguments;
use super::parsers::{method_parser, number_parser};
use super::prescribed::Prescribed;
use super::rotor::RotorArguments;

const EXAMPLES: &str = "Examples:
  towermodes report examples/nrel-5mw.toml --output report.html
  towermodes report tower.toml --title \"Tower 7, revision C\" --rpm 6.9,12.1 --output report.html
  towermodes report tower.toml --document T-17-003 --revision C --author \"J. Doe\" --checker \"R. Roe\" --output report.html
  towermodes report tower.toml --output report.md

One file that needs nothing beside it and asks nothing of any network. The same files and command give the same bytes.
A margin that fails is in the report; that it fails is the exit code of campbell.
Exit codes: 0 done, 1 the computation or the output failed, 2 wrong usage or wrong input.";

/// The arguments of `report`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct ReportArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// What the report is of [default: the tower's name]
    #[arg(long, value_name = "TEXT")]
    pub(crate) title: Option<String>,

    #[command(flatten)]
    title_block: TitleBlockArguments,

    /// The method of the frequencies [default: rmje-exact; bmodes for BModes decks]; all are
    /// compared
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,

    /// Segments, or elements, of that method and of those compared with it
    /// [default: as of solve, and 60 of those compared]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    pub(crate) segments: Option<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pub(crate) rotor: RotorArguments,

    /// How the report is written [default: as the ending of --output says: .html or .md; else html]
    #[arg(long, short, value_enum)]
    format: Option<PageFormat>,

    /// Write the report to a file instead of standard output, which must be no terminal unless - is
    /// given here
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

/// The heading of what is about the document.
const DOCUMENT: &str = "Document";

/// What stands below the title; what is not given is left out.
#[derive(Debug, Args)]
struct TitleBlockArguments {
    /// Project or site
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT")]
    project: Option<String>,

    /// Document number
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT")]
    document: Option<String>,

    /// Revision of the document
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT")]
    revision: Option<String>,

    /// Who made the report
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT")]
    author: Option<String>,

    /// Who checked it
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT")]
    checker: Option<String>,

    /// Date of the report, as it is to be read; the report has no clock and shows none by itself
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT")]
    date: Option<String>,
}

/// How a report is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PageFormat {
    /// A page with pictures and moving shapes.
    Html,
    /// Markdown with the tables of GitHub, and the commands that draw the pictures.
    Md,
}

impl Ending for PageFormat {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("html", Self::Html),
        ("htm", Self::Html),
        ("md", Self::Md),
        ("markdown", Self::Md),
    ];
}

impl ReportArguments {
    /// What was given as output, `-` too.
    pub(crate) fn asked_output(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    /// The file the report goes to, if not to standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }

    /// How the report is written: as told, or as the ending of the file says.
    ///
    /// # Errors
    /// The two do not go together, or the ending says nothing.
    pub(crate) fn format(&self) -> Result<PageFormat, EndingError> {
        let asked = PageFormat::asked(self.format, self.output())?;
        Ok(asked.unwrap_or(PageFormat::Html))
    }

    /// How the modes are found.
    ///
    /// # Errors
    /// What is wrong if an option means nothing to the method.
    pub(crate) fn options(&self, prescribed: Prescribed) -> Result<Options, &'static str> {
        prescribed.options(self.method, self.segments, &self.model)
    }

    /// What stands below the title.
    pub(crate) fn title_block(&self) -> TitleBlock {
        let given = &self.title_block;
        let text = |field: &Option<String>| field.clone().unwrap_or_default();
        TitleBlock {
            project: text(&given.project),
            document: text(&given.document),
            revision: text(&given.revision),
            author: text(&given.author),
            checker: text(&given.checker),
            date: text(&given.date),
        }
    }

    /// Whether the number of modes is given.
    pub(crate) fn has_modes(&self) -> bool {
        self.model.has_modes()
    }
}
