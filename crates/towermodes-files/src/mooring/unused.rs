//! What a file has and lines at rest do not need.

use crate::note::Note;
use crate::source::Source;

/// Columns and options that are not used, which one note names.
#[derive(Debug, Default)]
pub(super) struct Unused {
    what: Vec<String>,
    first: Option<usize>,
}

impl Unused {
    /// Adds names of a table that begins at a byte: `columns of POINTS`, `options`.
    pub(super) fn add(&mut self, what: &str, names: &[&str], at: usize) {
        if !names.is_empty() {
            self.what.push(format!("{what} {}", names.join(", ")));
            self.first = Some(self.first.map_or(at, |first| first.min(at)));
        }
    }

    /// The note on all of them, at the first table.
    pub(super) fn note(&self, source: &Source) -> Option<Note> {
        let message = format!(
            "not used by lines at rest: {} (damping, drag, added mass, segments, and settings of the simulation or iteration have no effect)",
            self.what.join("; ")
        );
        Some(Note::left_out(message).at(source, self.first?))
    }
}
