//! Notes: decisions, omissions and changes by a reader or writer.

use std::fmt;

use crate::diagnostic::line_and_column;
use crate::source::Source;

/// The kind of a note.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum NoteKind {
    /// Information on reading or writing.
    Information,
    /// A value that the file does not give, or a choice that it leaves open.
    Assumption,
    /// Content that is not used, because it has no effect or is not modelled.
    LeftOut,
    /// Content that is used in another form than it is given.
    Approximation,
    /// A part of the turbine that the model lacks: the result may be that of another tower than
    /// the user expects.
    MissingPart,
    /// The state of the rotor on its shaft if the rotor-nacelle assembly is one rigid body; not
    /// relevant to a turbine with rotating rotor.
    RigidRotor,
    /// A value that the program of this format treats differently, because of an error or an
    /// assumption of that program.
    Compatibility,
    /// A value that looks wrong.
    Suspicious,
}

/// An assumption, omission or change by a reader or writer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// Its kind.
    pub kind: NoteKind,
    /// The message, with the numbers.
    pub message: String,
    /// The file and the line (from 1), if the note is about a line.
    pub place: Option<(String, usize)>,
}

impl Note {
    /// Information on the whole file.
    pub fn new(message: impl Into<String>) -> Self {
        Self::of(NoteKind::Information, message)
    }

    /// A note of any kind on the whole file.
    pub fn of(kind: NoteKind, message: impl Into<String>) -> Self {
        Self {
            kind,
            message: message.into(),
            place: None,
        }
    }

    /// [`NoteKind::Assumption`].
    pub fn assumption(message: impl Into<String>) -> Self {
        Self::of(NoteKind::Assumption, message)
    }

    /// [`NoteKind::LeftOut`].
    pub fn left_out(message: impl Into<String>) -> Self {
        Self::of(NoteKind::LeftOut, message)
    }

    /// [`NoteKind::Approximation`].
    pub fn approximation(message: impl Into<String>) -> Self {
        Self::of(NoteKind::Approximation, message)
    }

    /// [`NoteKind::MissingPart`].
    pub fn missing_part(message: impl Into<String>) -> Self {
        Self::of(NoteKind::MissingPart, message)
    }

    /// [`NoteKind::RigidRotor`].
    pub fn rigid_rotor(message: impl Into<String>) -> Self {
        Self::of(NoteKind::RigidRotor, message)
    }

    /// [`NoteKind::Compatibility`].
    pub fn compatibility(message: impl Into<String>) -> Self {
        Self::of(NoteKind::Compatibility, message)
    }

    /// [`NoteKind::Suspicious`].
    pub fn suspicious(message: impl Into<String>) -> Self {
        Self::of(NoteKind::Suspicious, message)
    }

    /// The note with the place of a byte of a file.
    #[must_use]
    pub fn at(mut self, source: &Source, byte: usize) -> Self {
        let (line, _) = line_and_column(&source.text, byte);
        self.place = Some((source.name.clone(), line));
        self
    }

    /// Whether the user should check a value or may give more data: an assumption, a part that the
    /// model lacks, a value that looks wrong. Other notes state how a file is read, which the user
    /// cannot change.
    pub fn is_warning(&self) -> bool {
        match self.kind {
            NoteKind::Assumption | NoteKind::MissingPart | NoteKind::Suspicious => true,
            NoteKind::Information
            | NoteKind::LeftOut
            | NoteKind::Approximation
            | NoteKind::RigidRotor
            | NoteKind::Compatibility => false,
        }
    }

    /// Whether it is about a part of the turbine that the model lacks.
    pub fn is_on_missing_part(&self) -> bool {
        self.kind == NoteKind::MissingPart
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((file, line)) = &self.place {
            write!(f, "{file}:{line}: ")?;
        }
        write!(f, "{}", self.message)
    }
}

/// Notes on a rotor and its blades.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct RotorNotes {
    /// Notes on its operating speeds, which are not relevant if other speeds are given.
    pub speeds: Vec<Note>,
    /// Notes on the number of its blades, which are not relevant if another number is given.
    pub blades: Vec<Note>,
    /// All others.
    pub others: Vec<Note>,
}

impl RotorNotes {
    /// All notes, those on speeds first.
    pub fn iter(&self) -> impl Iterator<Item = &Note> {
        self.of_rotor().chain(&self.others)
    }

    /// Notes on its speeds and the number of its blades, which apply whenever the rotor is used.
    pub fn of_rotor(&self) -> impl Iterator<Item = &Note> {
        self.speeds.iter().chain(&self.blades)
    }
}
