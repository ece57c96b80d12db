//! Columns and options of a mooring file that have no effect on lines at rest.

use crate::note::Note;
use crate::source::Source;

/// Unused columns and options, which a common note lists.
#[derive(Debug, Default)]
pub(super) struct Unused {
    what: Vec<String>,
    first: Option<usize>,
}

impl Unused {
    /// Adds unused names of a table, for example "columns of POINTS" or "options". `at` is the byte
    /// at which the table begins.
    pub(super) fn add(&mut self, what: &str, names: &[&str], at: usize) {
        if !names.is_empty() {
            self.what.push(format!("{what} {}", names.join(", ")));
            self.first = Some(self.first.map_or(at, |first| first.min(at)));
        }
    }

    /// The common note, at the first table.
    pub(super) fn note(&self, source: &Source) -> Option<Note> {
        let message = format!(
            "not used by lines at rest: {} (damping, drag, added mass, segments, and settings of the simulation or iteration have no effect)",
            self.what.join("; ")
        );
        Some(Note::left_out(message).at(source, self.first?))
    }
}
