//! What is said, and with which exit code, when something fails.

use std::io::{self, Write as _};
use std::process::ExitCode;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use towermodes::number;
use towermodes::{BladeError, EigenError, Family, SolveError, TowerError, Warning};
use towermodes_analysis::elastodyn::ShapesError;
use towermodes_analysis::resonance::CampbellError;
use towermodes_files::elastodyn::{MakeError, TowerFileError};
use towermodes_files::{Diagnostic, FileFormat, Note, ReadError, ResultError, Source, TowerInput};
use towermodes_report::raster::RasterError;
use towermodes_report::wording::printable;

use crate::args::EndingError;
use crate::terminal::NOT_SHOWN;

/// Why the program ends without a result.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A file cannot be read, or is no tower.
    Input(ReadError),
    /// The request is impossible or the computation failed.
    Unsolved(SolveError),
    /// The file is no blade.
    Blade(BladeError),
    /// The description is no tower.
    Tower(TowerError),
    /// The tower has no tower file of ElastoDyn.
    TowerFile(MakeError),
    /// What was asked for cannot be written, and why.
    Refused(String),
    /// Shapes of a deck are not those of its tower.
    Unfit {
        /// How many.
        failures: usize,
    },
    /// Nobody says how fast the rotor runs.
    NoRotor {
        /// What kind of file it is that does not.
        format: FileFormat,
    },
    /// There is no diagram of excitations.
    Campbell(CampbellError),
    /// The rotor excites modes in operation.
    Resonant {
        /// How many pairs of a mode and an excitation.
        failures: usize,
        /// The margin asked for, as a share.
        margin: f64,
    },
    /// The picture cannot have the size asked for.
    Picture(RasterError),
    /// Two descriptions do not agree.
    Disagree,
    /// The arguments do not go together.
    Usage(&'static str),
    /// It is not known how the output is to be written.
    Ending(EndingError),
    /// The result would be poured on a terminal, where nobody reads it.
    ForNoTerminal {
        /// What it is.
        what: &'static str,
        /// The name of a file for it.
        example: &'static str,
    },
    /// Values of the manual did not come out.
    Unverified {
        /// How many.
        failures: usize,
        /// Of how many.
        values: usize,
    },
    /// The result would overwrite the input.
    OverwritesInput(String),
    /// The result could not be written.
    Unwritable(String, io::Error),
}

impl Failure {
    /// Says what went wrong on standard error and gives the exit code.
    pub(crate) fn report(&self) -> ExitCode {
        match self {
            Self::Input(ReadError::Mistakes {
                source_file,
                mistakes,
            }) => say(&mistakes_text(source_file, mistakes)),
            Self::Input(error) => say(&message(Level::ERROR, &error.to_string(), None)),
            Self::Unsolved(error) => {
                say(&message(Level::ERROR, &error.to_string(), hint(error)));
            }
            Self::Blade(error) => say(&message(Level::ERROR, &error.to_string(), None)),
            Self::Tower(error) => {
                let text = format!("{}: {}", error.place, error.problem);
                say(&message(Level::ERROR, &text, error.problem.hint()));
            }
            Self::TowerFile(MakeError::Shapes(ShapesError::Solve(error))) => {
                say(&message(Level::ERROR, &error.to_string(), hint(error)));
            }
            Self::TowerFile(error) => say(&message(Level::ERROR, &error.to_string(), None)),
            Self::Refused(text) => say(&message(Level::ERROR, text, None)),
            Self::Unfit { failures } => {
                let text = format!("{failures} of 4 shapes are not those of the tower");
                let hint = "towermodes elastodyn patch puts the tower's own in their place";
                say(&message(Level::ERROR, &text, Some(hint)));
            }
            Self::NoRotor { format } => {
                let text = "nobody says how fast the rotor runs";
                let hint = match format {
                    FileFormat::Toml => NO_ROTOR,
                    _ => "give --rpm LOWEST,HIGHEST",
                };
                say(&message(Level::ERROR, text, Some(hint)));
            }
            Self::Campbell(error) => {
                let hint = match error {
                    CampbellError::Blade { error, .. } => hint(error),
                    _ => None,
                };
                say(&message(Level::ERROR, &error.to_string(), hint));
            }
            Self::Resonant { failures, margin } => {
                let text = resonant_text(*failures, *margin);
                let hint = "look for FAIL above; other speeds ([rotor] rpm, or --rpm), a stiffer or softer tower, or less mass on top move them apart";
                say(&message(Level::ERROR, &text, Some(hint)));
            }
            Self::Picture(error) => say(&message(Level::ERROR, &error.to_string(), None)),
            Self::Disagree => {
                let text = "the two descriptions do not agree";
                say(&message(Level::ERROR, text, Some("look for fail above")));
            }
            Self::Usage(text) => say(&message(Level::ERROR, text, None)),
            Self::Ending(error) => say(&message(Level::ERROR, &error.to_string(), None)),
            Self::ForNoTerminal { what, example } => {
                let text =
                    format!("standard output is a terminal, and {what} is not to be read there");
                let hint = format!(
                    "give --output {example}, a pipe or a redirection; --output - prints it all the same"
                );
                say(&message(Level::ERROR, &text, Some(&hint)));
            }
            Self::Unverified { failures, values } => {
                let text = format!("{failures} of {values} values did not come out");
                say(&message(Level::ERROR, &text, Some("look for FAIL above")));
            }
            Self::OverwritesInput(path) => {
                let text = format!("{path} is read as input; the result would overwrite it");
                say(&message(
                    Level::ERROR,
                    &text,
                    Some("give --output another path"),
                ));
            }
            Self::Unwritable(name, error) => {
                say(&message(Level::ERROR, &format!("{name}: {error}"), None));
            }
        }
        ExitCode::from(self.code())
    }

    /// What a tower file cannot hold.
    pub(crate) fn tower_file(error: &TowerFileError) -> Self {
        Self::Refused(error.to_string())
    }

    fn code(&self) -> u8 {
        match self {
            Self::Unsolved(error)
            | Self::TowerFile(MakeError::Shapes(ShapesError::Solve(error))) => {
                if error.is_usage() {
                    2
                } else {
                    1
                }
            }
            Self::TowerFile(_) | Self::Refused(_) | Self::Unfit { .. } | Self::Disagree => 1,
            Self::Campbell(CampbellError::Blade { .. }) | Self::Resonant { .. } => 1,
            Self::Picture(RasterError::Drawing(_) | RasterError::Encoding(_)) => 1,
            Self::Unwritable(..) | Self::Unverified { .. } => 1,
            _ => 2,
        }
    }
}

/// What a file of this program needs for a diagram of excitations.
const NO_ROTOR: &str = "give --rpm LOWEST,HIGHEST, or add to the tower's file:
  [rotor]
  blades = 3
  rpm = [6.9, 12.1]  # lowest and highest speed of operation";

fn resonant_text(failures: usize, margin: f64) -> String {
    let percent = number::percent(margin);
    match failures {
        1 => format!("1 excitation is within {percent} % of a natural frequency in operation"),
        n => format!("{n} excitations are within {percent} % of natural frequencies in operation"),
    }
}

impl From<ResultError> for Failure {
    fn from(error: ResultError) -> Self {
        Self::Unwritable("the result".into(), io::Error::other(error))
    }
}

/// Says what belongs to a result but not into it.
pub(crate) fn report(text: &str) {
    say(&printable(text, NOT_SHOWN));
}

/// Says what the reader of a file decided or left out.
pub(crate) fn note(notes: &[Note]) {
    for note in notes {
        say(&message(Level::WARNING, &note.to_string(), None));
    }
}

/// Says what looks like a slip, with the line of the input where it stands.
pub(crate) fn warn(warnings: &[Warning], input: &TowerInput) {
    for warning in warnings {
        let line = warning.place().and_then(|place| input.line_of(place));
        let text = match line {
            Some((file, line)) => format!("{file}:{line}: {warning}"),
            None => warning.to_string(),
        };
        say(&message(Level::WARNING, &text, None));
    }
}

/// Standard error may be closed; there is nobody left to tell then.
fn say(text: &str) {
    let _ = anstream::stderr().lock().write_all(text.as_bytes());
}

fn hint(error: &SolveError) -> Option<&'static str> {
    match error {
        SolveError::TooManyModes { .. } => {
            Some("raise --segments (of --method spectral --degree) or lower --modes")
        }
        SolveError::TooLarge { .. } | SolveError::TooSlow { .. } => Some(
            "ask for fewer modes (--modes) or fewer segments (--segments), an even number of which needs no finer ones for the errors; --no-limits tries all the same",
        ),
        SolveError::Buckles { .. } => Some(
            "carry less, widen the tower or thicken its wall; --no-gravity solves the tower without its weights",
        ),
        SolveError::Eigen(EigenError::TooStiff) => {
            Some("no soil or wire is a million times as stiff as a tower: look at the units")
        }
        SolveError::Unstable {
            motion: Family::Roll | Family::Pitch,
        } => Some(
            "a hydrostatic stiffness is buoyancy alone: [gravity] adds what the weights do; look at g and the height of the centre of mass too",
        ),
        SolveError::Unstable { .. } => Some(
            "look at the signs of the hydrostatic and mooring stiffness there, and at the weights",
        ),
        SolveError::UnstableBlade { .. } => Some(
            "look at the rotor's speed (rot_rpm in rpm, rpm_mult), at GJ and at the offsets of the sections",
        ),
        SolveError::Eigen(EigenError::NotFinite) => Some("look for a value with the wrong unit"),
        SolveError::Eigen(_) => {
            Some("ask for fewer modes, or look for a value with the wrong unit")
        }
        _ => None,
    }
}

fn message(level: Level<'_>, text: &str, hint: Option<&str>) -> String {
    let text = printable(text, NOT_SHOWN);
    let title = rendered(&[Group::with_title(level.primary_title(&*text))]);
    let hint = hint.map(|hint| rendered(&[Group::with_title(Level::HELP.primary_title(hint))]));
    title + &hint.unwrap_or_default()
}

/// Every mistake with its line, as compilers show them, with a blank line between two.
fn mistakes_text(source: &Source, mistakes: &[Diagnostic]) -> String {
    let mut text = String::new();
    let name = printable(&source.name, NOT_SHOWN);
    for mistake in mistakes {
        if !text.is_empty() {
            text.push('\n');
        }
        let message = mistake.message();
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

/// The part of a mistake's span that is on its first line, so that a long table is not printed
/// whole.
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
