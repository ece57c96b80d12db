//! Notes, mistakes and the place of each value, collected while a file is read.

use std::ops::Range;

use towermodes::Place;

use crate::diagnostic::Diagnostic;
use crate::note::{Note, RotorNotes};
use crate::places::Places;
use crate::source::Source;

/// The file, and what was collected so far.
#[derive(Debug)]
pub(crate) struct Reading<'a> {
    pub(crate) source: &'a Source,
    pub(crate) notes: Vec<Note>,
    /// Notes that apply only if the rotor is used.
    pub(crate) rotor_notes: RotorNotes,
    pub(crate) mistakes: Vec<Diagnostic>,
    pub(crate) places: Places,
}

impl<'a> Reading<'a> {
    pub(crate) fn new(source: &'a Source) -> Self {
        Self {
            source,
            notes: Vec::new(),
            rotor_notes: RotorNotes::default(),
            mistakes: Vec::new(),
            places: Places::default(),
        }
    }

    pub(crate) fn note(&mut self, note: Note) {
        self.notes.push(note);
    }

    /// Adds a note at a place; once, even if two parts use the data there.
    pub(crate) fn note_at(&mut self, byte: usize, note: Note) {
        let note = note.at(self.source, byte);
        if !self.notes.contains(&note) {
            self.notes.push(note);
        }
    }

    /// Stores the place of a value for the checks of the whole tower.
    pub(crate) fn remember(&mut self, place: Place, span: &Range<usize>) {
        self.places.remember(place, 0, span.clone());
    }

    /// The value that was read, or none, with its mistake stored.
    pub(crate) fn keep<T>(&mut self, result: Result<T, Diagnostic>) -> Option<T> {
        result.map_err(|mistake| self.mistakes.push(mistake)).ok()
    }
}
