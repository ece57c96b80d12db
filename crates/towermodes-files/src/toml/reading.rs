//! Mistakes, notes and the place of each value, collected while a file is read.

use std::ops::Range;

use towermodes::Place;
use towermodes::turbine::TurbineDescription;

use crate::diagnostic::Diagnostic;
use crate::places::Places;
use crate::source::{FileError, Source};

/// Mistakes beyond this number are not collected: each may list many names.
const MAX_MISTAKES: usize = 100;

/// The place of the file with the stations among a tower's files.
pub(super) const STATION_FILE: usize = 1;

/// A file with a profile of soil.
#[derive(Debug)]
pub(super) struct ProfileFile {
    /// As the tower file names it.
    pub(super) path: String,
    /// Its place among a tower's files: after that of the stations, if there is one.
    pub(super) index: usize,
    pub(super) source: Result<Source, FileError>,
}

/// Mistakes, notes and places that were found so far.
#[derive(Debug, Default)]
pub(super) struct Reading {
    pub(super) mistakes: Vec<Diagnostic>,
    pub(super) places: Places,
    /// The file with the stations that the tower file names, until its rows are read.
    pub(super) station_file: Option<Result<Source, FileError>>,
    /// The blade file that the turbine names, until its rows are read.
    pub(super) blade_file: Option<Result<Source, FileError>>,
    /// The profiles of soil that layers of the ground name.
    pub(super) profiles: Vec<ProfileFile>,
    /// One of these files that has mistakes, and these.
    pub(super) in_other_file: Option<(Source, Vec<Diagnostic>)>,
    /// The files beside the tower file that were read, that of the stations first.
    pub(super) others: Vec<Source>,
    /// The blade file that was read.
    pub(super) blade_source: Option<Source>,
    /// The turbine.
    pub(super) turbine: Option<TurbineDescription>,
    /// Notes with their bytes in the file.
    pub(super) notes: Vec<(usize, &'static str)>,
}

impl Reading {
    pub(super) fn mistake(&mut self, diagnostic: Diagnostic) {
        if !self.is_full() {
            self.mistakes.push(diagnostic);
        }
    }

    /// Keeps a mistake, and gives nothing in place of the value.
    pub(super) fn refuse<T>(&mut self, mistake: Diagnostic) -> Option<T> {
        self.mistake(mistake);
        None
    }

    /// Whether the list of mistakes is full.
    pub(super) fn is_full(&self) -> bool {
        self.mistakes.len() >= MAX_MISTAKES
    }

    pub(super) fn note(&mut self, at: usize, message: &'static str) {
        self.notes.push((at, message));
    }

    /// Remembers the place of a value for the checks of the whole tower.
    pub(super) fn remember(&mut self, place: Place, span: Range<usize>) {
        self.places.remember(place, 0, span);
    }
}
