//! What a file of SubDyn describes: a frame, and the joints of its transition piece.

use std::ops::Range;

use towermodes::frame::{Frame, FrameDescription, FrameError, FramePlace, FrameRecipe, Transition};

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::note::Note;
use crate::source::Source;

/// How the interface joints of a substructure are held.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Interface {
    /// Each moves for itself, without a transition piece: the "full" frequencies in the summary of
    /// SubDyn.
    #[default]
    Free,
    /// They move with a rigid transition piece with this reference point (m).
    Rigid([f64; 3]),
    /// The transition piece is held: the Craig-Bampton frequencies of SubDyn.
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
    /// Parts into which SubDyn divides each beam.
    pub divisions: usize,
    /// Notes on what the reader decided or left out.
    pub notes: Vec<Note>,
    /// The file, then the files of soil stiffness.
    pub(crate) sources: Vec<Source>,
    pub(super) spans: Spans,
}

/// The bytes of the rows of the main file.
#[derive(Debug, Clone, Default)]
pub(super) struct Spans {
    pub(super) joints: Vec<Range<usize>>,
    pub(super) members: Vec<Range<usize>>,
    pub(super) supports: Vec<Range<usize>>,
    pub(super) masses: Vec<Range<usize>>,
    pub(super) interfaces: Vec<Range<usize>>,
}

impl SubdynInput {
    /// The frame with its interface joints held in one of the ways.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at the line of what no frame can have, or [`Interface::Rigid`] or
    /// [`Interface::Held`] without interface joints.
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

    /// SubDyn's own elements.
    pub fn recipe(&self) -> FrameRecipe {
        FrameRecipe::Subdyn {
            divisions: self.divisions,
        }
    }

    /// The note on what a substructure alone lacks.
    pub fn note_on_parts(&self) -> Note {
        Note::missing_part(
            "a SubDyn file contains only the substructure: no tower, no turbine, no water and no gravity",
        )
    }

    /// What no frame can have, at its line.
    fn mistake(&self, error: FrameError) -> ReadError {
        let spans = &self.spans;
        let span = match &error.place {
            FramePlace::Joint(index, _) => spans.joints.get(*index),
            FramePlace::Member(index, _) => spans.members.get(*index),
            FramePlace::Support(index, _) => spans.supports.get(*index),
            FramePlace::Mass(index, _) => spans.masses.get(*index),
            FramePlace::Transition => spans.interfaces.first(),
            _ => None,
        };
        let kind = DiagnosticKind::Frame(Box::new(error));
        let mistake = Diagnostic::new(span.cloned().unwrap_or(0..0), kind);
        ReadError::mistake(&self.sources[0], mistake)
    }

    /// The files it was read from, the main one first.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.sources.iter().map(|source| source.name.as_str())
    }
}
