//! `towermodes report`.

use std::ffi::OsString;
use std::fs;
use std::path::Path;

use clap::{Args, Parser as _, ValueEnum};
use towermodes::{Options, Planes, SolveError, Solver, Tower};
use towermodes_analysis::elastodyn::{MakeOptions, make_tower};
use towermodes_analysis::resonance::ChosenRotor;
use towermodes_analysis::study::{COMPARED_SEGMENTS, Comparison};
use towermodes_files::{FileFormat, Note, Source, TowerInput, encoded_as};
use towermodes_report::report::{
    Circumstances, Computation, ElastoDynShapes, InputFile, ReportContent, ReportRequest,
    TitleBlock, html, markdown, quoted,
};

use super::campbell::notes_on;
use super::{Arguments, Command};
use crate::args::{
    Destination, Ending, InputArguments, RotorArguments, SoilArguments, SolverArguments,
    up_to_excitations,
};
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::tower_input;
use crate::messages::{note, warn};
use crate::output::{check_not_input, check_not_inputs, check_terminal, deliver};
use crate::progress::Progress;
use crate::side_by_side::all_methods;

const EXAMPLES: &str = "Examples:
  towermodes report examples/nrel-5mw.toml --output report.html
  towermodes report tower.toml --title \"Tower 7, revision C\" --rpm 6.9,12.1 --output report.html
  towermodes report tower.toml --document T-17-003 --revision C --author \"J. Doe\" --checker \"R. Roe\" --output report.html
  towermodes report tower.toml --output report.md

The report is one self-contained file and needs no network. The same input and command give the same file, byte for byte. A report with the verdict FAIL has the exit code 0; for an exit code that depends on the verdict use campbell.

Exit codes: 0 done, 1 the computation or the output failed, 2 wrong usage or wrong input.";

const METHOD: &str = "Method of computation; one section of the report compares all methods [default: rmje-exact; bmodes for BModes decks]";
const SEGMENTS: &str = "Number of segments (bmodes and spectral: elements), also for the comparison of methods [default: same as solve; 60 for the comparison]";
const FORMAT: &str =
    "Format of the report [default: from the extension of --output: .html or .md; otherwise html]";
const OUTPUT: &str = "Write the report to a file. Without this option the report goes to standard output; if that is a terminal, the command stops with an error. With - the report goes to standard output in any case";

/// The arguments of `report`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, mut_arg("modes", up_to_excitations), mut_arg("method", |of| of.help(METHOD)), mut_arg("segments", |of| of.help(SEGMENTS)), mut_arg("format", |of| of.help(FORMAT)), mut_arg("output", |of| of.help(OUTPUT)))]
pub(crate) struct ReportArguments {
    #[command(flatten)]
    input: InputArguments,

    /// Title of the report [default: name of the tower]
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,

    #[command(flatten)]
    title_block: TitleBlockArguments,

    #[command(flatten)]
    solver: SolverArguments,

    #[command(flatten)]
    rotor: RotorArguments,

    #[command(flatten)]
    soil: SoilArguments,

    /// Add a section on the influence of every input value on the lowest frequencies
    #[arg(long)]
    sensitivities: bool,

    #[command(flatten)]
    destination: Destination<PageFormat>,
}

/// Heading of these options in the help.
const DOCUMENT: &str = "Document";

/// The title block; entries that are not given are omitted.
#[derive(Debug, Clone, Args)]
struct TitleBlockArguments {
    /// Project or site
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT", default_value = "", hide_default_value = true)]
    project: String,

    /// Document number
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT", default_value = "", hide_default_value = true)]
    document: String,

    /// Revision of the document
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT", default_value = "", hide_default_value = true)]
    revision: String,

    /// Author of the report
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT", default_value = "", hide_default_value = true)]
    author: String,

    /// Checker of the report
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT", default_value = "", hide_default_value = true)]
    checker: String,

    /// Date of the report, printed as given; without it the report shows no date
    #[arg(help_heading = DOCUMENT, long, value_name = "TEXT", default_value = "", hide_default_value = true)]
    date: String,
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
    const DEFAULT: Self = Self::Html;
}

impl ReportArguments {
    /// The title block.
    fn title_block(&self) -> TitleBlock {
        let given = self.title_block.clone();
        TitleBlock {
            project: given.project,
            document: given.document,
            revision: given.revision,
            author: given.author,
            checker: given.checker,
            date: given.date,
        }
    }
}

/// Reads the tower, computes all results and writes the report, which quotes the command line.
pub(crate) fn run(arguments: &ReportArguments, words: &[OsString]) -> Result<(), Failure> {
    let output = arguments.destination.output();
    check_not_input(&arguments.input.file, output)?;
    let format = arguments.destination.format()?;
    let what = match format {
        PageFormat::Html => "a page of HTML",
        PageFormat::Md => "a report",
    };
    check_terminal(arguments.destination.asked_output(), what, "report.html")?;
    let input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let tower = input.tower()?;
    let content = content(&input, tower.clone(), arguments, words);
    let content = explained(content, (&tower, &input))?;
    let text = match format {
        PageFormat::Html => html(&content).map_err(Failure::failed)?,
        PageFormat::Md => markdown(&content),
    };
    note(&all_notes(&input, arguments.rotor.rotor(&input).as_ref()));
    warn(&content.solution.warnings, &input);
    deliver(text.as_bytes(), output)
}

/// The page that a command line of `report` writes, for an input that was already read.
pub(crate) fn page_of(input: &TowerInput, words: &[String]) -> Result<String, Failure> {
    let words: Vec<OsString> = words.iter().map(OsString::from).collect();
    let parsed = Arguments::try_parse_from(&words);
    let parsed = parsed.map_err(Failure::failed)?;
    let Command::Report(arguments) = parsed.command else {
        return Err(Failure::usage("this is not the command report"));
    };
    let tower = input.tower()?;
    let content = content(input, tower, &arguments, &words)?;
    html(&content).map_err(Failure::failed)
}

/// The content of the report.
fn content(
    input: &TowerInput,
    tower: Tower,
    arguments: &ReportArguments,
    words: &[OsString],
) -> Result<ReportContent, Failure> {
    let options = arguments.solver.options(input)?;
    let rotor = arguments.rotor.rotor(input);
    let soil_factors = arguments.soil.factors(&input.description)?;
    // On a monopile the ElastoDyn tower is the part above it.
    let shapes_from_m = input.joint_m.unwrap_or(tower.base_m());
    let shapes_tower = input.tower_for_shapes()?;
    let notes_on_shapes = input.note_on_shapes();
    let request = ReportRequest {
        description: input.description.clone(),
        tower,
        options,
        covers_excitations: !arguments.solver.has_modes(),
        rotor: rotor.map(|chosen| chosen.rotor),
        blades: arguments.rotor.given().blades.or(input.blades),
        blade: input.blade.clone(),
        turbine: input.whole_turbine()?,
        campbell: arguments.rotor.options(),
        soil_factors: soil_factors.map(<[f64]>::to_vec),
        sensitivities: arguments.sensitivities,
        compared_segments: arguments.solver.segments.unwrap_or(COMPARED_SEGMENTS),
        elastodyn: elastodyn(&shapes_tower, shapes_from_m),
        shapes_from_m,
        circumstances: circumstances(input, rotor.as_ref(), arguments, words),
        notes_on_shapes: notes_on_shapes.iter().map(Note::to_string).collect(),
    };
    Ok(ReportContent::compute(request, &WithProgress)?)
}

/// Title block, notes, command and files.
fn circumstances(
    input: &TowerInput,
    rotor: Option<&ChosenRotor>,
    arguments: &ReportArguments,
    words: &[OsString],
) -> Circumstances {
    let mut notes = all_notes(input, rotor);
    notes.extend(arguments.rotor.note());
    let of_model = notes.iter().filter(|note| note.is_on_missing_part());
    Circumstances {
        title: arguments.title.clone().unwrap_or_default(),
        title_block: arguments.title_block(),
        model_notes: of_model.map(|note| note.message.clone()).collect(),
        notes: notes.iter().map(Note::to_string).collect(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        command_line: command_line(words),
        reading: arguments.input.reading.typed(),
        is_own_format: input.format == FileFormat::Toml,
        files: input.sources().iter().map(input_file).collect(),
    }
}

/// The notes on the files, the turbine and its rotor.
fn all_notes(input: &TowerInput, rotor: Option<&ChosenRotor>) -> Vec<Note> {
    let of_files = || input.rotor_notes.iter().cloned().collect();
    let of_rotor: Vec<Note> = rotor.map_or_else(of_files, |rotor| notes_on(input, rotor));
    let notes = input.notes.iter().chain(&input.turbine_notes).cloned();
    notes.chain(of_rotor).collect()
}

/// The computations of a report with a progress line.
struct WithProgress;

impl Computation for WithProgress {
    fn solver(&self, options: Options) -> Solver {
        Progress::of_one().solver(options)
    }

    fn compare(
        &self,
        tower: &Tower,
        options: &Options,
        segments: usize,
    ) -> Result<Comparison, SolveError> {
        all_methods(tower, options, Some(segments))
    }
}

/// The shapes that `towermodes elastodyn tower` writes.
fn elastodyn(tower: &Tower, from_m: f64) -> Result<ElastoDynShapes, String> {
    let options = MakeOptions {
        from_m: Some(from_m),
        ..MakeOptions::default()
    };
    let made = make_tower(tower, &options).map_err(|error| error.to_string())?;
    let quantities = made.quantities;
    Ok(ElastoDynShapes {
        shapes: made.shapes,
        frequency_alone_hz: Planes {
            fore_aft: quantities.fore_aft.frequency_alone_hz,
            side_side: quantities.side_side.frequency_alone_hz,
        },
    })
}

/// The command as it was typed.
fn command_line(words: &[OsString]) -> String {
    let arguments = words.iter().skip(1);
    let quoted = arguments.map(|argument| quoted(&argument.to_string_lossy()));
    let words: Vec<String> = std::iter::once("towermodes".to_owned())
        .chain(quoted)
        .collect();
    words.join(" ")
}

fn input_file(source: &Source) -> InputFile {
    let bytes = bytes_on_disk(source);
    InputFile::new(source.name.clone(), source.text.clone(), bytes.as_deref())
}

/// The bytes of an input file; none if it is not a file or has changed.
fn bytes_on_disk(source: &Source) -> Option<Vec<u8>> {
    let path = Path::new(&source.name);
    if !fs::metadata(path).is_ok_and(|of| of.is_file()) {
        return None;
    }
    let bytes = fs::read(path).ok()?;
    (encoded_as(&source.text, &bytes) == bytes).then_some(bytes)
}
