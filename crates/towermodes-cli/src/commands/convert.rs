//! `towermodes convert`.

use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use towermodes_files::{ConvertOptions, OutputFormat, convert};

use crate::args::parsers::height_parser;
use crate::args::{Ending, EndingError, InputArguments, file_of};
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::tower_input;
use crate::messages::{note, report, warn_texts};
use crate::output::{check_not_input, check_not_inputs, deliver, deliver_both};

const EXAMPLES: &str = "Examples:
  towermodes convert deck.bmi --output tower.toml
  towermodes convert tower.toml --output tower.bmi
  towermodes convert IEA-15-240-RWT.yaml --to elastodyn --output Tower.dat
  towermodes convert tower.toml --to windio

Data that the target format cannot store are reported on standard error. A BModes deck consists of two files: the section file is written to the same folder.

Exit codes: 0 done; 1 the tower cannot be written in this format, or the output failed; 2 wrong usage or wrong input.";

/// The arguments of `convert`.
#[derive(Debug, Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES)]
pub(crate) struct ConvertArguments {
    #[command(flatten)]
    pub(crate) input: InputArguments,

    /// Format to write
    /// [default: from the extension of --output: .toml, .bmi, .dat (ElastoDyn tower file), .yaml]
    #[arg(long, value_enum, required_unless_present = "output")]
    to: Option<Target>,

    /// Height at which the flexible tower begins, m; only for --to elastodyn
    /// [default: the tower base]
    #[arg(long, value_name = "M", value_parser = height_parser)]
    pub(crate) from_height: Option<f64>,

    /// Write the result to a file instead of standard output (-); required for --to bmodes
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

impl Ending for Target {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("toml", Self::Toml),
        ("bmi", Self::Bmodes),
        ("dat", Self::Elastodyn),
        ("yaml", Self::WindIo),
        ("yml", Self::WindIo),
    ];
    const DEFAULT: Self = Self::Toml;
    const OPTION: &'static str = "--to";
}

impl ConvertArguments {
    /// The format to write: that of the option, otherwise that of the extension of the output file;
    /// none if neither gives one.
    ///
    /// # Errors
    /// The option and the extension contradict each other, or the extension is unknown.
    pub(crate) fn to(&self) -> Result<Option<Target>, EndingError> {
        Target::asked(self.to, self.output())
    }

    /// Checks that the options apply to the format.
    ///
    /// # Errors
    /// The message for an option that does not apply.
    pub(crate) fn check(&self, to: Target) -> Result<(), &'static str> {
        if self.from_height.is_some() && to != Target::Elastodyn {
            return Err(
                "--from-height applies only to --to elastodyn; the other formats contain the whole tower",
            );
        }
        Ok(())
    }

    /// The file that the result is written to; none for standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }
}

/// A format in which towers can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Target {
    /// The tower file of this program; stores all data.
    Toml,
    /// BModes 3.00 deck.
    Bmodes,
    /// ElastoDyn tower file.
    Elastodyn,
    /// windIO 2.0 turbine that contains only tower and RNA.
    #[value(name = "windio")]
    WindIo,
}

impl Target {
    /// The format of the library.
    pub(crate) fn format(self) -> OutputFormat {
        match self {
            Self::Toml => OutputFormat::Toml,
            Self::Bmodes => OutputFormat::Bmodes,
            Self::Elastodyn => OutputFormat::ElastoDyn,
            Self::WindIo => OutputFormat::WindIo,
        }
    }
}

/// Reads any tower and writes it in another format; data that the format cannot store are reported
/// on standard error.
pub(crate) fn run(arguments: &ConvertArguments) -> Result<(), Failure> {
    let output = arguments.output();
    check_not_input(&arguments.input.file, output)?;
    let to = arguments.to()?;
    let to = to.ok_or(Failure::usage(NO_FORMAT))?;
    arguments.check(to)?;
    let input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let options = options(arguments, to);
    let converted = convert(&input, to.format(), &options);
    let converted = match (converted, input.tower()) {
        (Err(failure), Ok(tower)) => explained(Err(failure), (&tower, &input)),
        (converted, _) => converted.map_err(Failure::from),
    }?;
    note(&input.notes);
    note(&converted.of_reader);
    // The written file does not contain what its format cannot store.
    warn_texts(&Vec::from_iter(
        converted.notes.iter().map(ToString::to_string),
    ));
    if let (Some((name, text)), Some(output)) = (&converted.companion, output) {
        let companion = output.with_file_name(name);
        check_not_inputs(input.files(), Some(&companion))?;
        check_is_own(&companion, output)?;
        deliver_both(
            (&companion, text.as_bytes()),
            (output, converted.text.as_bytes()),
        )?;
        report(&format!(
            "written: {}, {}\n",
            output.display(),
            companion.display()
        ));
        return Ok(());
    }
    deliver(converted.text.as_bytes(), output)
}

/// The options of the conversion; the section file of a deck has the name of its main file.
fn options(arguments: &ConvertArguments, to: Target) -> ConvertOptions {
    let stem = arguments.output().and_then(Path::file_stem);
    let stem = stem.filter(|_| to == Target::Bmodes);
    ConvertOptions {
        sections_file: stem.map(|stem| format!("{}_sections.dat", stem.to_string_lossy())),
        from_height_m: arguments.from_height,
    }
}

/// The message if neither the option nor the file extension gives a format.
const NO_FORMAT: &str =
    "the format of the output is not known: give --to toml, bmodes, elastodyn or windio";

/// Refuses to overwrite a section file whose deck does not exist, unless this program wrote it:
/// then it is the rest of an interrupted conversion.
fn check_is_own(companion: &Path, deck: &Path) -> Result<(), Failure> {
    if !companion.exists() || deck.exists() {
        return Ok(());
    }
    let old = fs::read_to_string(companion).unwrap_or_default();
    if is_own_sections(&old) {
        return Ok(());
    }
    Err(Failure::failed(format!(
        "the section file {} already exists and was not written by this program; give --output another name or move that file",
        companion.display()
    )))
}

/// Whether a section file begins like the section files of [`write_bmodes`].
fn is_own_sections(text: &str) -> bool {
    let mut lines = text.lines();
    let title = lines.next().unwrap_or_default();
    let count = lines.next().unwrap_or_default();
    title.starts_with("Sections of ") && count.ends_with("n_secs: number of sections (-)")
}
