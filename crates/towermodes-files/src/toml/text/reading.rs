//! Mistakes, notes and the place of each value, collected while a file is read.

use std::ops::Range;

use towermodes::Place;
use towermodes::frame::FramePart;
use towermodes::turbine::TurbineDescription;

use crate::diagnostic::Diagnostic;
use crate::error::ReadError;
use crate::note::Note;
use crate::places::Places;
use crate::source::{FileError, Source};
use crate::subdyn::SubdynInput;

/// Largest number of mistakes that are collected, because each may list many names.
const MAX_MISTAKES: usize = 100;

/// The index of the file with the stations among a tower's files.
pub(crate) const STATION_FILE: usize = 1;

/// A file with a profile of soil.
#[derive(Debug)]
pub(crate) struct ProfileFile {
    /// The path in the tower file.
    pub(crate) path: String,
    /// Its index among a tower's files: after that of the stations, if there is one.
    pub(crate) index: usize,
    pub(crate) source: Result<Source, FileError>,
}

/// Mistakes, notes and places found so far.
#[derive(Debug, Default)]
pub(crate) struct Reading {
    pub(crate) mistakes: Vec<Diagnostic>,
    pub(crate) places: Places,
    /// The file with the stations that the tower file names, until its rows are read.
    pub(crate) station_file: Option<Result<Source, FileError>>,
    /// The blade file that the turbine names, until its rows are read.
    pub(crate) blade_file: Option<Result<Source, FileError>>,
    /// The profiles of soil that layers of the ground name.
    pub(crate) profiles: Vec<ProfileFile>,
    /// One of these files that has mistakes, with these mistakes.
    pub(crate) in_other_file: Option<(Source, Vec<Diagnostic>)>,
    /// The files named by the tower file that were read, that of the stations first.
    pub(crate) others: Vec<Source>,
    /// The blade file that was read.
    pub(crate) blade_source: Option<Source>,
    /// The substructure in the file of SubDyn that the tower file names, until it is used.
    pub(crate) substructure_file: Option<Result<SubdynInput, ReadError>>,
    /// The files of that substructure, and the notes on it.
    pub(crate) substructure_sources: Vec<Source>,
    /// Places in the first of these files.
    pub(crate) substructure_places: Vec<(FramePart, Range<usize>)>,
    pub(crate) substructure_notes: Vec<Note>,
    /// The turbine.
    pub(crate) turbine: Option<TurbineDescription>,
    /// Notes with the byte of the file that they are about.
    pub(crate) notes: Vec<(usize, &'static str)>,
}

impl Reading {
    pub(crate) fn mistake(&mut self, diagnostic: Diagnostic) {
        if !self.is_full() {
            self.mistakes.push(diagnostic);
        }
    }

    /// Stores a mistake, and returns none in place of the value.
    pub(crate) fn refuse<T>(&mut self, mistake: Diagnostic) -> Option<T> {
        self.mistake(mistake);
        None
    }

    /// Whether the list of mistakes is full.
    pub(crate) fn is_full(&self) -> bool {
        self.mistakes.len() >= MAX_MISTAKES
    }

    pub(crate) fn note(&mut self, at: usize, message: &'static str) {
        self.notes.push((at, message));
    }

    /// Stores the place of a value for the checks of the whole tower.
    pub(crate) fn remember(&mut self, place: Place, span: Range<usize>) {
        self.places.remember(place, 0, span);
    }
}
