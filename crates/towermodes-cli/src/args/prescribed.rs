//! Solver options: from the command line, else from the file, else the default.

use towermodes::{DEFAULT_POINTS, Method, Options};
use towermodes_files::TowerInput;

use super::model::ModelArguments;

/// Solver options that a file contains.
#[derive(Debug, Clone, Default)]
pub(crate) struct Prescribed {
    /// The method of the format.
    pub(crate) method: Option<Method>,
    /// The number of modes.
    pub(crate) modes: Option<usize>,
    /// The boundaries of its finite elements, m.
    pub(crate) borders_m: Option<Vec<f64>>,
}

impl Prescribed {
    /// The options in an input; takes the element boundaries out of it.
    pub(crate) fn of(input: &mut TowerInput) -> Self {
        Self {
            method: input.method,
            modes: input.modes,
            borders_m: input.borders_m.take(),
        }
    }

    /// The options of the library; the command line has priority.
    ///
    /// # Errors
    /// The message for an option that does not apply to the method.
    pub(super) fn options(
        self,
        method: Option<Method>,
        segments: Option<usize>,
        model: &ModelArguments,
    ) -> Result<Options, &'static str> {
        let method = method.or(self.method).unwrap_or_default();
        model.check(method)?;
        let own_elements = method == Method::Bmodes && segments.is_none();
        let options = model.options();
        Ok(Options {
            method,
            segments,
            borders_m: self.borders_m.filter(|_| own_elements),
            modes: model.modes.or(self.modes).unwrap_or(options.modes),
            points: DEFAULT_POINTS,
            ..options
        })
    }
}
