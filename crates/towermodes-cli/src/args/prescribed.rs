//! How a tower is solved: as the command line says, as its file prescribes, or by default.

use towermodes::{DEFAULT_POINTS, Method, Options};
use towermodes_files::TowerInput;

use super::model::ModelArguments;

/// What a file prescribes for its solution.
#[derive(Debug, Clone, Default)]
pub(crate) struct Prescribed {
    /// The method it is made for.
    pub(crate) method: Option<Method>,
    /// How many modes it asks for.
    pub(crate) modes: Option<usize>,
    /// The borders of its finite elements, m.
    pub(crate) borders_m: Option<Vec<f64>>,
}

impl Prescribed {
    /// Of what was read; its borders are taken out of it.
    pub(crate) fn of(input: &mut TowerInput) -> Self {
        Self {
            method: input.method,
            modes: input.modes,
            borders_m: input.borders_m.take(),
        }
    }

    /// What the library is asked for, with what the command line says first.
    ///
    /// # Errors
    /// What is wrong if an option means nothing to the method.
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
