//! Notes and mistakes, collected while a file is read.

use crate::diagnostic::Diagnostic;
use crate::note::Note;
use crate::source::Source;

/// The file, and the notes and mistakes that were found so far.
#[derive(Debug)]
pub(super) struct Reading<'a> {
    pub(super) source: &'a Source,
    pub(super) notes: Vec<Note>,
    pub(super) mistakes: Vec<Diagnostic>,
}

impl<'a> Reading<'a> {
    pub(super) fn new(source: &'a Source) -> Self {
        Self {
            source,
            notes: Vec::new(),
            mistakes: Vec::new(),
        }
    }

    pub(super) fn note(&mut self, note: Note) {
        self.notes.push(note);
    }

    pub(super) fn note_at(&mut self, byte: usize, note: Note) {
        self.notes.push(note.at(self.source, byte));
    }

    /// What was read, or nothing and the mistake kept.
    pub(super) fn keep<T>(&mut self, result: Result<T, Diagnostic>) -> Option<T> {
        result.map_err(|mistake| self.mistakes.push(mistake)).ok()
    }
}
