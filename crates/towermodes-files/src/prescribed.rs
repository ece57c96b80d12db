//! Options of the solution that a file prescribes.

use towermodes::{Method, Options};

use crate::note::Note;

/// Options that a file prescribes for the solution of its tower: a BModes deck prescribes its
/// method, its elements and its number of modes; other files nothing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Prescribed {
    /// The method for which the file is made, if any.
    pub method: Option<Method>,
    /// The element boundaries for the finite elements of BModes, m in the datum of the stations.
    pub borders_m: Option<Vec<f64>>,
    /// The number of modes.
    pub modes: Option<usize>,
}

impl Prescribed {
    /// The options of a solve: the given ones, otherwise those of the file, otherwise the default.
    /// The elements of the file apply to the method `bmodes` without a number of segments.
    pub fn options(&self, method: Option<Method>, segments: Option<usize>) -> Options {
        let default = Options::default();
        let method = method.or(self.method).unwrap_or_default();
        let has_own_elements = method == Method::Bmodes && segments.is_none();
        Options {
            method,
            segments,
            borders_m: self.borders_m.clone().filter(|_| has_own_elements),
            modes: self.modes.unwrap_or(default.modes),
            ..default
        }
    }

    /// The note that a format does not store the method and the number of modes.
    pub(crate) fn left_out(&self) -> Option<Note> {
        let method = self.method?.name();
        let elements = self.borders_m.as_ref().map(|borders| {
            let count = borders.len().saturating_sub(1);
            format!(" with {count} prescribed elements")
        });
        let modes = self.modes.map(|modes| format!(" for {modes} modes"));
        Some(Note::left_out(format!(
            "the deck is solved by the method {method}{}{}; the format cannot store this, so the converted tower is solved by the default method and number of modes unless others are given",
            elements.unwrap_or_default(),
            modes.unwrap_or_default(),
        )))
    }
}
