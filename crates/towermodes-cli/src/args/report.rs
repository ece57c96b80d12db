//! The arguments of `report`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use towermodes::{MAX_SEGMENTS, Method, Options};
use towermodes_report::report::TitleBlock;

use super::ending::{Ending, EndingError};
use super::file_of;
use super::input::InputArguments;
use super::model::{ModelArguments, up_to_excitations};
use super::parsers::{method_parser, number_parser};
use super::prescribed::Prescribed;
use super::rotor::RotorArguments;
use super::soil::SoilArguments;

const EXAMPLES: &str = "Examples:
  towermodes report examples/nrel-5mw.toml --output report.html
  towermodes report tower.toml --title \"Tower 7, revision C\" --rpm 6.9,12.1 --output report.html
  towermodes report tower.toml --document T-17-003 --revision C --author \"J. Doe\" --checker \"R. Roe\" --output report.html
  towermodes report tower.toml --output report.md

The report is one self-contained file and needs no network. The same input and command give the same file, byte for byte. A report with the verdict FAIL has the exit code 0; for an exit code that depends on the verdict use campbell.

Exit codes: 0 done, 1 the computation or the output failed, 2 wrong usage or wrong input.";

/// The arguments of `report`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("modes", up_to_excitations))]
pub(crate) struct ReportArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Title of the report [default: name of the tower]
    #[arg(long, value_name = "TEXT")]
    pub(crate) title: Option<String>,

    #[command(flatten)]
    title_block: TitleBlockArguments,

    /// Method of computation; one section of the report compares all methods
    /// [default: rmje-exact; bmodes for BModes decks]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,

    /// Number of segments (bmodes and spectral: elements), also for the comparison of methods
    /// [default: same as solve; 60 for the comparison]
    #[arg(long, value_name = "N", value_parser = number_parser(1, MAX_SEGMENTS))]
    pub(crate) segments: Option<usize>,

    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pub(crate) rotor: RotorArguments,

    #[command(flatten)]
    pub(crate) soil: SoilArguments,

    /// Add a section on the influence of every number on the lowest frequencies
    #[arg(long)]
    pub(crate) sensitivities: bool,

    /// Format of the report [default: from the extension of --output: .html or .md; otherwise html]
    #[arg(long, short, value_enum)]
    format: Option<PageFormat>,

    /// Write the report to a file. Without this option the report goes to standard output; if that
    /// is a terminal, the command stops with an error. With - the report goes to standard output
    /// in any case
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

/// Heading of these options in the help.
const DOCUMENT: &str = "Document";

/// The title block; entries that are not given are omitted.
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

    /// Author of the report
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT")]
    author: Option<String>,

    /// Checker of the report
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT")]
    checker: Option<String>,

    /// Date of the report, printed as given; without it the report shows no date
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT")]
    date: Option<String>,
}

/// The format of a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PageFormat {
    /// One page with pictures and animated mode shapes.
    Html,
    /// GitHub-flavoured Markdown; pictures are replaced by the commands that create them.
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
    /// The given output, including `-`.
    pub(crate) fn asked_output(&self) -> Option<&Path> {
        self.output.as_deref()
    }

    /// The file that the report is written to; none for standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }

    /// The format of the report: the option, or else the extension of the output file.
    ///
    /// # Errors
    /// The option and the extension contradict each other, or the extension is unknown.
    pub(crate) fn format(&self) -> Result<PageFormat, EndingError> {
        let asked = PageFormat::asked(self.format, self.output())?;
        Ok(asked.unwrap_or(PageFormat::Html))
    }

    /// The solver options.
    ///
    /// # Errors
    /// The message for an option that does not apply to the method.
    pub(crate) fn options(&self, prescribed: Prescribed) -> Result<Options, &'static str> {
        prescribed.options(self.method, self.segments, &self.model)
    }

    /// The title block.
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
