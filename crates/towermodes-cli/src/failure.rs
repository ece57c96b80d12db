//! Errors of the program: message, suggestion, and exit code.

use std::borrow::Cow;
use std::fmt::{self, Display};
use std::io;
use std::path::Path;

use towermodes::frame::FrameSolveError;
use towermodes::{BladeError, ParameterError, SensitivityError, SolveError, TowerError};
use towermodes_analysis::damping::GivenDampingError;
use towermodes_analysis::elastodyn::{MakeError, ShapesError};
use towermodes_analysis::resonance::CampbellError;
use towermodes_analysis::whirl::CoupledError;
use towermodes_design::design::DesignError;
use towermodes_files::{ConvertError, ReadError, ResultError, SettingError};
use towermodes_report::raster::RasterError;
use towermodes_report::report::ContentError;
use towermodes_report::wording::remedy;
use towermodes_sweep::{Remedy, SliceError, SweepError, TableError};

use crate::args::EndingError;
use crate::messages::{fail, mistaken};

/// The option that sets input values by name.
pub(crate) const SETTING: &str = "--set";

/// The exit code for wrong usage or wrong input.
const USAGE: u8 = 2;
/// The exit code for a computation, a check or an output that failed.
const FAILED: u8 = 1;

/// An error that ends the program without a result.
#[derive(Debug)]
pub(crate) struct Failure {
    cause: Cause,
    /// A suggestion for the user.
    hint: Option<Cow<'static, str>>,
    /// The exit code of the program.
    code: u8,
}

/// The error.
#[derive(Debug)]
enum Cause {
    /// Errors in a file, often with lines.
    File(ReadError),
    Said(String),
}

impl Failure {
    fn new(error: impl Display, code: u8) -> Self {
        Self {
            cause: Cause::Said(error.to_string()),
            hint: None,
            code,
        }
    }

    /// Wrong usage or wrong input.
    pub(crate) fn usage(error: impl Display) -> Self {
        Self::new(error, USAGE)
    }

    /// The computation, a check or the output failed.
    pub(crate) fn failed(error: impl Display) -> Self {
        Self::new(error, FAILED)
    }

    /// A file or stream cannot be written.
    pub(crate) fn unwritable(name: impl Display, error: &io::Error) -> Self {
        Self::failed(format!("{name}: {error}"))
    }

    /// The failure with a hint.
    pub(crate) fn hint(self, hint: impl Into<Option<&'static str>>) -> Self {
        let hint = hint.into().map(Cow::Borrowed);
        Self { hint, ..self }
    }

    /// The failure with a hint that depends on the case.
    pub(crate) fn hint_of(self, hint: String) -> Self {
        let hint = Some(Cow::Owned(hint));
        Self { hint, ..self }
    }

    /// The failure with an exit code.
    pub(crate) fn code(self, code: u8) -> Self {
        Self { code, ..self }
    }

    /// The failure of a computation that cannot fulfil a line of a file.
    pub(crate) fn unreached(error: ReadError) -> Self {
        Self::from(error).code(FAILED)
    }

    /// The name of the file that contains the mistakes.
    pub(crate) fn file(&self) -> Option<&Path> {
        match &self.cause {
            Cause::File(ReadError::Mistakes { source_file, .. }) => {
                Some(Path::new(&source_file.name))
            }
            _ => None,
        }
    }

    /// Prints the error on standard error and returns the exit code.
    pub(crate) fn report(&self) -> u8 {
        match &self.cause {
            Cause::File(ReadError::Mistakes {
                source_file,
                mistakes,
            }) => mistaken(source_file, mistakes, ""),
            _ => fail(&self.to_string(), self.hint.as_deref()),
        }
        self.code
    }

    /// Prints the error of one of several files and returns its exit code.
    pub(crate) fn report_of(&self, file: &str) -> u8 {
        match &self.cause {
            // A wrong value of an option has no file of its own.
            Cause::File(ReadError::Mistakes {
                source_file,
                mistakes,
            }) if source_file.name == SETTING => {
                mistaken(source_file, mistakes, &format!("{file}: "));
                self.code
            }
            // The message on an input names the file.
            Cause::File(_) => self.report(),
            Cause::Said(said) => {
                fail(&format!("{file}: {said}"), self.hint.as_deref());
                self.code
            }
        }
    }
}

impl Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.cause {
            Cause::File(error) => error.fmt(f),
            Cause::Said(said) => f.write_str(said),
        }
    }
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        Self {
            cause: Cause::File(error),
            hint: None,
            code: USAGE,
        }
    }
}

/// Defines errors that are wrong usage or wrong input and need no hint.
macro_rules! wrong_usage {
    ($($error:ty),*) => {
        $(impl From<$error> for Failure {
            fn from(error: $error) -> Self {
                Self::usage(error)
            }
        })*
    };
}
wrong_usage!(&'static str, EndingError, BladeError);

impl From<ResultError> for Failure {
    fn from(error: ResultError) -> Self {
        Self::unwritable("the result", &io::Error::other(error))
    }
}

impl From<SolveError> for Failure {
    fn from(error: SolveError) -> Self {
        Self::new(&error, code_of(&error)).hint(remedy(&error))
    }
}

/// The exit code of a tower that cannot be solved.
fn code_of(error: &SolveError) -> u8 {
    if error.is_usage() { USAGE } else { FAILED }
}

impl From<FrameSolveError> for Failure {
    fn from(error: FrameSolveError) -> Self {
        let is_usage = matches!(
            error,
            FrameSolveError::Modes { .. }
                | FrameSolveError::Unresolved { .. }
                | FrameSolveError::Degree { .. }
        );
        Self::new(error, if is_usage { USAGE } else { FAILED })
    }
}

impl From<TowerError> for Failure {
    fn from(error: TowerError) -> Self {
        Self::usage(format!("{}: {}", error.place, error.problem)).hint(error.hint())
    }
}

impl From<SensitivityError> for Failure {
    fn from(error: SensitivityError) -> Self {
        match error {
            SensitivityError::Tower(error) => error.into(),
            SensitivityError::Solve(error) => error.into(),
            error => Self::usage(error),
        }
    }
}

/// The hint where the names of input values are listed.
const NAMES: &str = "`towermodes parameters FILE` lists the names of all input values";

impl From<ParameterError> for Failure {
    fn from(error: ParameterError) -> Self {
        Self::usage(error).hint(NAMES)
    }
}

impl From<SettingError> for Failure {
    fn from(error: SettingError) -> Self {
        let hint = matches!(error, SettingError::Parameter(_)).then_some(NAMES);
        Self::usage(format!("--set: {error}")).hint(hint)
    }
}

impl From<GivenDampingError> for Failure {
    fn from(error: GivenDampingError) -> Self {
        let hint = matches!(error, GivenDampingError::NoChords)
            .then_some("give --chord-moment, or chord_moment in [damping] of the tower file");
        Self::usage(error).hint(hint)
    }
}

impl From<CampbellError> for Failure {
    fn from(error: CampbellError) -> Self {
        match &error {
            CampbellError::Blade { error: cause, .. } => Self::failed(&error).hint(remedy(cause)),
            _ => Self::usage(error),
        }
    }
}

impl From<CoupledError> for Failure {
    fn from(error: CoupledError) -> Self {
        match error {
            CoupledError::At { .. } => Self::failed(error),
            _ => Self::usage(error),
        }
    }
}

impl From<ContentError> for Failure {
    fn from(error: ContentError) -> Self {
        match error {
            ContentError::Solve(error) => error.into(),
            ContentError::Campbell(error) => error.into(),
            error => Self::failed(error),
        }
    }
}

impl From<RasterError> for Failure {
    fn from(error: RasterError) -> Self {
        match error {
            RasterError::Encoding(_) => Self::failed(error),
            _ => Self::usage(error),
        }
    }
}

impl From<MakeError> for Failure {
    fn from(error: MakeError) -> Self {
        match error {
            MakeError::Shapes(ShapesError::Solve(cause)) => cause.into(),
            error => Self::failed(error),
        }
    }
}

impl From<ConvertError> for Failure {
    fn from(error: ConvertError) -> Self {
        match error {
            ConvertError::Input(error) => error.into(),
            ConvertError::Shapes(error) => error.into(),
            ConvertError::NoSectionsFile => Self::usage(
                "a BModes deck consists of two files: give --output PATH for the main file",
            ),
            error => Self::failed(error),
        }
    }
}

impl From<DesignError> for Failure {
    fn from(error: DesignError) -> Self {
        let hint = match &error {
            DesignError::Infeasible(_) => {
                Some("widen the named bounds of the variables, frequency bands or limits")
            }
            DesignError::Solve(error) => hint_for_sweep(error),
            _ => None,
        };
        let failure = match &error {
            DesignError::Infeasible(_)
            | DesignError::NoCombination { .. }
            | DesignError::Solve(_)
            | DesignError::Tower(_)
            | DesignError::Sensitivity(_)
            | DesignError::NoDerivative { .. } => Self::failed(error),
            _ => Self::usage(error),
        };
        failure.hint(hint)
    }
}

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        match &error {
            SweepError::Unsolved(cause) => {
                Self::new(&error, code_of(cause)).hint(hint_for_sweep(cause))
            }
            _ => Self::usage(error),
        }
    }
}

impl From<SliceError> for Failure {
    fn from(error: SliceError) -> Self {
        let failure = match &error {
            SliceError::Output(_)
            | SliceError::Io { .. }
            | SliceError::Damaged { .. }
            | SliceError::Run(_) => Self::failed(&error),
            _ => Self::usage(&error),
        };
        failure.with_remedy(error.remedy())
    }
}

impl From<TableError> for Failure {
    fn from(error: TableError) -> Self {
        Self::usage(&error).with_remedy(error.remedy())
    }
}

impl Failure {
    /// The failure with the option of `sweep` that helps.
    fn with_remedy(self, remedy: Option<Remedy>) -> Self {
        match remedy {
            Some(Remedy::IgnoreColumn { name }) => self.hint_of(format!(
                "skip the column by --ignore \"{name}\", or write # before its name"
            )),
            Some(Remedy::Csv) => self.hint("--format csv"),
            None => self,
        }
    }
}

/// Suggestions if `sweep` or `design` cannot solve a tower; these commands have fewer options.
fn hint_for_sweep(error: &SolveError) -> Option<&'static str> {
    match error {
        SolveError::TooManyModes { .. } => Some("increase --segments or reduce --modes"),
        SolveError::TooLarge { .. } | SolveError::TooSlow { .. } => {
            Some("reduce --modes or --segments")
        }
        SolveError::Buckles { .. } => Some(
            "the base tower itself must be stable, even if its rows are; --set NAME=VALUE changes an input value of the base tower",
        ),
        error => remedy(error),
    }
}
