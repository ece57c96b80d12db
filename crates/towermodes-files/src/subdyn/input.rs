//! The content of a SubDyn file: a frame, and the joints of its transition piece.

use std::ops::Range;

use towermodes::frame::{Frame, FrameDescription, FrameError, FramePart, FrameRecipe, Transition};

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::note::Note;
use crate::places::{Rows, of_rows};
use crate::source::Source;

/// The support of the interface joints of a substructure.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Interface {
    /// Independent motion of each joint, without a transition piece: the "full" frequencies in the
    /// summary of SubDyn.
    #[default]
    Free,
    /// Motion with a rigid transition piece with this reference point (m).
    Rigid([f64; 3]),
    /// Fixed transition piece: the Craig-Bampton frequencies of SubDyn.
    Held,
}

/// A substructure as its file describes it.
#[derive(Debug, Clone)]
pub struct SubdynInput {
    /// The second line of the file.
    pub title: String,
    /// Joints, members, supports and masses, without a transition piece.
    pub description: FrameDescription,
    /// The joints of the transition piece, from 0.
    pub interface_joints: Vec<usize>,
    /// Number of parts into which SubDyn divides each beam.
    pub divisions: usize,
    /// Notes on decisions of the reader and omitted data.
    pub notes: Vec<Note>,
    /// The reaction joints without a support in the file, each with its note. A SoilDyn file may
    /// give the support.
    pub(super) loose: Vec<(usize, Note)>,
    /// The file, then the files of soil stiffness.
    pub(crate) sources: Vec<Source>,
    pub(super) spans: Spans,
}

/// The byte ranges of the rows of the main file.
#[derive(Debug, Clone, Default)]
pub(super) struct Spans {
    pub(super) joints: Vec<Range<usize>>,
    pub(super) members: Vec<Range<usize>>,
    pub(super) supports: Vec<Range<usize>>,
    pub(super) masses: Vec<Range<usize>>,
    pub(super) interfaces: Vec<Range<usize>>,
}

impl SubdynInput {
    /// The frame with one of the supports of its interface joints.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at the line of a value that is impossible for a frame, or
    /// [`Interface::Rigid`] or [`Interface::Held`] without interface joints.
    pub fn frame(&self, interface: Interface) -> Result<Frame, ReadError> {
        let (position_m, is_held) = match interface {
            Interface::Free => (None, false),
            Interface::Rigid(position_m) => (Some(position_m), false),
            Interface::Held => (Some([0.0; 3]), true),
        };
        let transition = position_m.map(|position_m| Transition {
            position_m,
            joints: self.interface_joints.clone(),
            is_held,
        });
        let description = FrameDescription {
            transition,
            ..self.description.clone()
        };
        Frame::new(description).map_err(|error| self.mistake(error))
    }

    /// The elements of SubDyn.
    pub fn recipe(&self) -> FrameRecipe {
        FrameRecipe::Subdyn {
            divisions: self.divisions,
        }
    }

    /// The note on the parts that a single substructure lacks.
    pub fn note_on_parts(&self) -> Note {
        Note::missing_part(
            "a SubDyn file contains only the substructure: no tower, no turbine, no water and no gravity",
        )
    }

    /// An error of the frame, at its line.
    fn mistake(&self, error: FrameError) -> ReadError {
        let span = self.row(error.place.part()).unwrap_or(0..0);
        let kind = DiagnosticKind::Frame(Box::new(error));
        let mistake = Diagnostic::new(span, kind);
        ReadError::mistake(&self.sources[0], mistake)
    }

    /// Probable mistakes in this frame, each at its line of the file.
    pub fn warnings(&self, frame: &Frame) -> Vec<Note> {
        let warnings = frame.warnings().into_iter();
        let notes = warnings.map(|warning| {
            let note = Note::suspicious(warning.to_string());
            match self.row(warning.part()) {
                Some(span) => note.at(&self.sources[0], span.start),
                None => note,
            }
        });
        notes.collect()
    }

    fn row(&self, part: FramePart) -> Option<Range<usize>> {
        let found = self.places().find(|(own, _)| *own == part);
        found.map(|(_, span)| span)
    }

    /// The byte range of each part in the main file, for a tower on this frame.
    pub(crate) fn places(&self) -> impl Iterator<Item = (FramePart, Range<usize>)> {
        let spans = &self.spans;
        let kinds: [Rows<'_, FramePart>; 4] = [
            (FramePart::Joint, &spans.joints),
            (FramePart::Member, &spans.members),
            (FramePart::Support, &spans.supports),
            (FramePart::Mass, &spans.masses),
        ];
        let transition = spans.interfaces.first().cloned();
        of_rows(kinds).chain(transition.map(|span| (FramePart::Transition, span)))
    }

    /// The byte of the row of a member.
    pub(crate) fn member_row(&self, index: usize) -> usize {
        self.spans.members.get(index).map_or(0, |row| row.start)
    }

    /// The files that were read, the main one first.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.sources.iter().map(|source| source.name.as_str())
    }
}
