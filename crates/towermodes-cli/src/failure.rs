//! Errors of the program: message, hint and exit code.

use std::borrow::Cow;
use std::io::{self, Write as _};

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use thiserror::Error;
use towermodes::number;
use towermodes::{BladeError, ParameterError, SensitivityError, SolveError, TowerError, Warning};
use towermodes_analysis::damping::GivenDampingError;
use towermodes_analysis::elastodyn::{MakeError, ShapesError};
use towermodes_analysis::resonance::{CampbellError, NotChecked};
use towermodes_analysis::whirl::CoupledError;
use towermodes_design::design::DesignError;
use towermodes_files::elastodyn::TowerFileError;
use towermodes_files::{
    Diagnostic, FileFormat, Note, ReadError, ResultError, SettingError, Source, TowerInput,
};
use towermodes_report::raster::RasterError;
use towermodes_report::wording::{printable, remedy};

use towermodes_sweep::{Remedy, SliceError, SweepError, TableError};

use crate::args::EndingError;
use crate::terminal::NOT_SHOWN;

/// The option that sets numbers by name.
pub(crate) const SETTING: &str = "--set";

/// The errors that end the program without a result.
#[derive(Debug, Error)]
pub(crate) enum Failure {
    /// A file cannot be read or does not describe a tower.
    #[error("{0}")]
    Input(ReadError),
    /// The computation cannot do what a line of a file asks for.
    #[error("{0}")]
    Unreached(ReadError),
    /// The page cannot be served.
    #[error("{}", no_server(*.port, .error))]
    Server {
        /// The port that was asked for.
        port: Option<u16>,
        /// The error of the system.
        error: io::Error,
    },
    /// A number cannot be set by name.
    #[error("--set: {0}")]
    Setting(SettingError),
    /// The tower has no number with the requested name.
    #[error("{0}")]
    NoParameter(ParameterError),
    /// The tower has no number to change with the requested name.
    #[error("{0}")]
    NoChange(ParameterError),
    /// A change has no derivative.
    #[error("{0}")]
    NoSensitivity(SensitivityError),
    /// The sweep cannot begin.
    #[error("{0}")]
    Sweep(SweepError),
    /// The lightest tower cannot be found.
    #[error("{0}")]
    Design(DesignError),
    /// The numbers cannot be fitted.
    #[error("{0}")]
    Calibration(String),
    /// The study of a design names multiples of the rotor speed, which is not known.
    #[error(
        "the study of the design names multiples of the rotor speed, which the tower file does not contain"
    )]
    NoRotorSpeeds,
    /// The study of a sweep, design or calibration contradicts the files that it names, or the
    /// options.
    #[error("{0}")]
    WrongStudy(String),
    /// An option has no effect, because a column of the sweep sets the same number.
    #[error(
        "--set {setting} has no effect: the column `{column}` sets {parameter} in each row; remove one of them"
    )]
    Overwritten {
        /// The name of the setting.
        setting: String,
        /// The name of the column.
        column: String,
        /// The number.
        parameter: String,
    },
    /// The table of a sweep is wrong.
    #[error("{0}")]
    Table(TableError),
    /// A slice of a sweep cannot be written, or slices cannot be read together.
    #[error("{0}")]
    Slice(SliceError),
    /// Rows that no slice has.
    #[error("the slices do not have the rows {0}")]
    MissingRows(String),
    /// The options are impossible or the computation failed.
    #[error("{0}")]
    Unsolved(SolveError),
    /// The description is not a valid blade.
    #[error("{0}")]
    Blade(BladeError),
    /// The description is not a valid tower.
    #[error("{}: {}", .0.place, .0.problem)]
    Tower(TowerError),
    /// The ElastoDyn tower file cannot be created.
    #[error("{0}")]
    TowerFile(MakeError),
    /// The result cannot be written; the reason.
    #[error("{0}")]
    Refused(String),
    /// Mode shapes of a deck do not match its tower.
    #[error("{failures} of 4 mode shapes in the file do not match the tower")]
    Unfit {
        /// How many.
        failures: usize,
    },
    /// Resonance could not be checked.
    #[error("not checked: {}", joined(.reasons))]
    NotChecked {
        /// Why.
        reasons: Vec<NotChecked>,
        /// The format of the input file.
        format: FileFormat,
    },
    /// The damping data of the command line are wrong.
    #[error("{0}")]
    Damping(GivenDampingError),
    /// The Campbell diagram cannot be computed.
    #[error("{0}")]
    Campbell(CampbellError),
    /// The coupled Campbell diagram of a turbine cannot be computed.
    #[error("{0}")]
    Coupled(CoupledError),
    /// An excitation is within the margin of a tower mode.
    #[error(
        "{} within the {} % margin in operation",
        pairs(*.failures), number::percent(*.margin)
    )]
    Resonant {
        /// The number of pairs of mode and excitation.
        failures: usize,
        /// The required margin, as a fraction.
        margin: f64,
    },
    /// The picture cannot have the requested size.
    #[error("{0}")]
    Picture(RasterError),
    /// Two models do not agree.
    #[error("the two models do not agree")]
    Disagree,
    /// Some of several files failed; their messages are printed before.
    #[error("{failed} of {files} files {} no result", if *.failed == 1 { "has" } else { "have" })]
    Several {
        /// How many failed.
        failed: usize,
        /// Of how many.
        files: usize,
        /// The largest exit code of a failure.
        code: u8,
    },
    /// The arguments contradict each other.
    #[error("{0}")]
    Usage(&'static str),
    /// The format of the output is not known.
    #[error("{0}")]
    Ending(EndingError),
    /// The result cannot be displayed on a terminal.
    #[error("standard output is a terminal, which cannot display {what}")]
    ForNoTerminal {
        /// The kind of result.
        what: &'static str,
        /// An example of a file name.
        example: &'static str,
    },
    /// Reference values are not reproduced.
    #[error("{failures} of {values} values are outside their tolerance")]
    Unverified {
        /// How many.
        failures: usize,
        /// Of how many.
        values: usize,
    },
    /// The result would overwrite the input.
    #[error("{0} is an input file; the result would overwrite it")]
    OverwritesInput(String),
    /// The result could not be written.
    #[error("{0}: {1}")]
    Unwritable(String, io::Error),
}

/// "1 pair of excitation and natural frequency is".
fn pairs(count: usize) -> String {
    match count {
        1 => "1 pair of excitation and natural frequency is".to_owned(),
        n => format!("{n} pairs of excitation and natural frequency are"),
    }
}

/// "operating speeds unknown; clamped at the tower base …".
fn joined(reasons: &[NotChecked]) -> String {
    let reasons: Vec<String> = reasons.iter().map(ToString::to_string).collect();
    reasons.join("; ")
}

/// What is needed for verdicts, for each reason why there are none.
fn hint_for_unchecked(reasons: &[NotChecked], format: FileFormat) -> String {
    const WHOLE: &str = "a file with the whole structure gives verdicts; --to toml of convert writes what was read as a tower file, to which the missing parts can be added";
    let speeds = match format {
        FileFormat::Toml => NO_ROTOR,
        _ => "give --rpm LOWEST,HIGHEST",
    };
    match reasons {
        [NotChecked::PartsMissing(_)] => WHOLE.to_owned(),
        [NotChecked::SpeedsUnknown] => speeds.to_owned(),
        _ => format!("{WHOLE}; the operating speeds are needed too: {speeds}"),
    }
}

impl Failure {
    /// Prints the error on standard error and returns the exit code.
    pub(crate) fn report(&self) -> u8 {
        match self {
            Self::Input(ReadError::Mistakes {
                source_file,
                mistakes,
            })
            | Self::Unreached(ReadError::Mistakes {
                source_file,
                mistakes,
            }) => say(&mistakes_text(source_file, mistakes, "")),
            failure => {
                let hint = failure.hint();
                say(&message(
                    Level::ERROR,
                    &failure.to_string(),
                    hint.as_deref(),
                ));
            }
        }
        self.code()
    }

    /// Prints the error of one of several files and returns its exit code.
    pub(crate) fn report_of(&self, file: &str) -> u8 {
        match self {
            // A wrong value of an option has no file of its own.
            Self::Input(ReadError::Mistakes {
                source_file,
                mistakes,
            }) if source_file.name == SETTING => {
                say(&mistakes_text(source_file, mistakes, &format!("{file}: ")));
                return self.code();
            }
            // The message on an input names the file.
            Self::Input(_) => return self.report(),
            _ => {}
        }
        let hint = self.hint();
        let text = format!("{file}: {self}");
        say(&message(Level::ERROR, &text, hint.as_deref()));
        self.code()
    }

    /// What the user can do about it.
    fn hint(&self) -> Option<Cow<'static, str>> {
        let hint = match self {
            Self::Server { port: Some(_), .. } => {
                "without --port the program takes any port that is free"
            }
            Self::Unsolved(error)
            | Self::TowerFile(MakeError::Shapes(ShapesError::Solve(error)))
            | Self::Campbell(CampbellError::Blade { error, .. }) => remedy(error)?,
            Self::Sweep(SweepError::Unsolved(error)) => hint_for_sweep(error)?,
            Self::Tower(error) => error.hint()?,
            Self::Setting(SettingError::Parameter(_)) | Self::NoChange(_) => {
                "`towermodes parameters FILE` lists the names of all numbers"
            }
            Self::NoParameter(_) => "without a filter the command lists all numbers",
            Self::Unfit { .. } => "towermodes elastodyn patch replaces them by the computed shapes",
            Self::Design(DesignError::Infeasible(_)) => {
                "widen the bounds of the variables, the bands or the limits that are named"
            }
            Self::Design(DesignError::Solve(error)) => hint_for_sweep(error)?,
            Self::Damping(GivenDampingError::NoChords) => {
                "give --chord-moment, or chord_moment in [damping] of the tower file"
            }
            Self::NoRotorSpeeds => ROTOR,
            Self::NotChecked { reasons, format } => {
                return Some(Cow::Owned(hint_for_unchecked(reasons, *format)));
            }
            Self::Resonant { .. } => {
                "see the lines with FAIL above; change the operating speeds ([rotor] rpm or --rpm), the stiffness of the tower or the RNA mass"
            }
            Self::Disagree => "see the lines with fail above",
            Self::ForNoTerminal { example, .. } => {
                return Some(Cow::Owned(format!(
                    "give --output {example}, a pipe or a redirection; --output - writes to the terminal anyway"
                )));
            }
            Self::Unverified { .. } => "see the lines with FAIL above",
            Self::OverwritesInput(_) => "give another path with --output",
            Self::MissingRows(_) => "--rows FIRST..END with --output computes a slice of them",
            Self::Slice(error) => return error.remedy().map(option_for),
            Self::Table(error) => return error.remedy().map(option_for),
            _ => return None,
        };
        Some(Cow::Borrowed(hint))
    }

    /// The error of data that a tower file cannot store.
    pub(crate) fn tower_file(error: &TowerFileError) -> Self {
        Self::Refused(error.to_string())
    }

    fn code(&self) -> u8 {
        match self {
            Self::Unsolved(error)
            | Self::Sweep(SweepError::Unsolved(error))
            | Self::TowerFile(MakeError::Shapes(ShapesError::Solve(error))) => {
                if error.is_usage() {
                    2
                } else {
                    1
                }
            }
            Self::Design(
                DesignError::Infeasible(_)
                | DesignError::NoCombination { .. }
                | DesignError::Solve(_)
                | DesignError::Tower(_)
                | DesignError::Sensitivity(_)
                | DesignError::NoDerivative { .. },
            ) => 1,
            Self::Calibration(_) | Self::Unreached(_) => 1,
            Self::TowerFile(_) | Self::Refused(_) | Self::Unfit { .. } | Self::Disagree => 1,
            Self::Coupled(CoupledError::At { .. }) => 1,
            Self::Campbell(CampbellError::Blade { .. }) | Self::Resonant { .. } => 1,
            Self::NotChecked { .. } => 1,
            Self::Picture(RasterError::Encoding(_)) => 1,
            Self::Unwritable(..) | Self::Unverified { .. } => 1,
            Self::Server { .. } => 1,
            Self::Several { code, .. } => *code,
            Self::MissingRows(_) => 1,
            Self::Slice(
                SliceError::Output(_)
                | SliceError::Io { .. }
                | SliceError::Damaged { .. }
                | SliceError::Run(_),
            ) => 1,
            _ => 2,
        }
    }
}

/// The rotor data of a tower file, without an option.
const ROTOR: &str = "add to the tower file:
  [rotor]
  blades = 3
  rpm = [6.9, 12.1]  # lowest and highest operating speed";

/// The rotor data of a tower file.
const NO_ROTOR: &str = "give --rpm LOWEST,HIGHEST, or add to the tower file:
  [rotor]
  blades = 3
  rpm = [6.9, 12.1]  # lowest and highest operating speed";

impl From<ResultError> for Failure {
    fn from(error: ResultError) -> Self {
        Self::Unwritable("the result".into(), io::Error::other(error))
    }
}

/// Prints text that accompanies a result.
pub(crate) fn report(text: &str) {
    say(&printable(text, NOT_SHOWN));
}

/// Prints the notes of a reader.
pub(crate) fn note(notes: &[Note]) {
    let texts: Vec<String> = notes.iter().map(Note::to_string).collect();
    note_texts(&texts);
}

/// Prints notes.
pub(crate) fn note_texts(notes: &[String]) {
    for note in notes {
        say(&message(Level::WARNING, note, None));
    }
}

/// Prints warnings, with file and line of the input if they are known.
pub(crate) fn warn(warnings: &[Warning], input: &TowerInput) {
    for warning in warnings {
        let text = warning_text(warning, input).unwrap_or_else(|| warning.to_string());
        say(&message(Level::WARNING, &text, None));
    }
}

/// A warning with file and line of the input; none if they are not known.
pub(crate) fn warning_text(warning: &Warning, input: &TowerInput) -> Option<String> {
    let (file, line) = input.line_of(warning.place()?)?;
    Some(format!("{file}:{line}: {warning}"))
}

/// The sentence on a page that cannot be served.
fn no_server(port: Option<u16>, error: &io::Error) -> String {
    match port {
        Some(port) => format!("port {port} cannot be used: {error}"),
        None => format!("the page cannot be served on this machine: {error}"),
    }
}

/// A message of a program that goes on.
pub(crate) fn hear(text: &str) {
    say(&message(Level::INFO, text, None));
}

/// If standard error is closed, the message is lost.
fn say(text: &str) {
    let _ = anstream::stderr().lock().write_all(text.as_bytes());
}

/// The same for `sweep`, which has fewer options.
fn hint_for_sweep(error: &SolveError) -> Option<&'static str> {
    match error {
        SolveError::TooManyModes { .. } => Some("increase --segments or reduce --modes"),
        SolveError::TooLarge { .. } | SolveError::TooSlow { .. } => {
            Some("reduce --modes or --segments")
        }
        SolveError::Buckles { .. } => Some(
            "the base itself must be a tower that stands, even if its rows are; --set NAME=VALUE changes a number of the base",
        ),
        error => remedy(error),
    }
}

/// The option of `sweep` that is a remedy.
fn option_for(remedy: Remedy) -> Cow<'static, str> {
    match remedy {
        Remedy::IgnoreColumn { name } => {
            let said =
                format!("--ignore \"{name}\" leaves the column out, as does a # before its name");
            Cow::Owned(said)
        }
        Remedy::Csv => Cow::Borrowed("--format csv"),
    }
}

fn message(level: Level<'_>, text: &str, hint: Option<&str>) -> String {
    let text = printable(text, NOT_SHOWN);
    let title = rendered(&[Group::with_title(level.primary_title(&*text))]);
    let hint = hint.map(|hint| rendered(&[Group::with_title(Level::HELP.primary_title(hint))]));
    title + &hint.unwrap_or_default()
}

/// All errors with their source lines, separated by blank lines; `prefix` begins each.
fn mistakes_text(source: &Source, mistakes: &[Diagnostic], prefix: &str) -> String {
    let mut text = String::new();
    let name = printable(&source.name, NOT_SHOWN);
    for mistake in mistakes {
        if !text.is_empty() {
            text.push('\n');
        }
        let message = format!("{prefix}{}", mistake.message());
        let said = printable(&message, NOT_SHOWN);
        let hint = mistake.hint.as_deref();
        let hint = hint.map(|hint| printable(hint, NOT_SHOWN));
        let snippet = Snippet::source(&source.text)
            .path(&*name)
            .annotation(AnnotationKind::Primary.span(visible(&source.text, mistake)));
        let group = Group::with_title(Level::ERROR.primary_title(&*said)).element(snippet);
        let group = match &hint {
            Some(hint) => group.element(Level::HELP.message(&**hint)),
            None => group,
        };
        text.push_str(&rendered(&[group]));
    }
    text
}

/// The first line of the span of an error, so that a long table is not printed completely.
fn visible(text: &str, mistake: &Diagnostic) -> std::ops::Range<usize> {
    let start = mistake.span.start.min(text.len());
    let end = mistake.span.end.clamp(start, text.len());
    let first_line = text.get(start..end).unwrap_or_default().lines().next();
    start..start + first_line.map_or(0, str::len)
}

fn rendered(report: &[Group<'_>]) -> String {
    let mut text = Renderer::styled().render(report);
    text.push('\n');
    text
}

#[cfg(test)]
mod tests {
    use super::Failure;

    #[test]
    fn a_value_of_the_manual_that_does_not_come_out_is_exit_code_1() {
        let failure = Failure::Unverified {
            failures: 1,
            values: 901,
        };
        assert_eq!(failure.code(), 1);
        assert_eq!(Failure::Usage("").code(), 2);
    }
}
