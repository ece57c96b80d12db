//! The content of a file of a mooring system.

use std::ops::Range;

use towermodes::Place;
use towermodes::mooring::{
    Mooring, MooringDescription, MooringError, MooringItem, MooringState, Pose,
};

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::note::Note;
use crate::places::{Rows, of_rows};
use crate::source::Source;

/// Depth, density of the water and gravity, used if a file of a mooring system does not give them:
/// a `.fst` file contains them for all its modules.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MooringSite {
    /// Depth of the seabed below still water, m.
    pub depth_m: Option<f64>,
    /// Density of the water, kg/m³.
    pub water_density_kg_per_m3: Option<f64>,
    /// Acceleration of gravity, m/s².
    pub gravity_m_per_s2: Option<f64>,
}

/// A mooring system as its file describes it.
#[derive(Debug, Clone)]
pub struct MooringInput {
    /// The content of the file, which may be changed. Its reference point is the origin.
    pub description: MooringDescription,
    /// Notes on decisions of the reader and omitted data.
    pub notes: Vec<Note>,
    pub(crate) source: Source,
    pub(super) spans: Spans,
}

/// The byte ranges of the rows of a file.
#[derive(Debug, Clone, Default)]
pub(crate) struct Spans {
    pub(crate) site: Range<usize>,
    pub(crate) line_types: Vec<Range<usize>>,
    pub(crate) points: Vec<Range<usize>>,
    pub(crate) lines: Vec<Range<usize>>,
    pub(crate) bodies: Vec<Range<usize>>,
    pub(crate) rods: Vec<Range<usize>>,
    /// The heading of the lines.
    pub(crate) heading: Range<usize>,
    /// Whether rows were copied, so that parts have other numbers than their rows.
    pub(crate) is_repeated: bool,
}

impl MooringInput {
    /// The mooring system of a file of another format, without notes.
    pub(crate) fn new(description: MooringDescription, source: Source, spans: Spans) -> Self {
        Self {
            description,
            notes: Vec::new(),
            source,
            spans,
        }
    }

    /// The mooring system.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at the line of a value that is impossible for a mooring system.
    pub fn mooring(&self) -> Result<Mooring, ReadError> {
        Mooring::with_anchors_on_seabed(self.description.clone())
            .map_err(|error| self.mistake(error))
    }

    /// The mooring system at the reference pose of the platform.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at the row of a line that is too short to reach its ends, or of a
    /// free part without an equilibrium.
    pub fn at_rest(&self, mooring: &Mooring) -> Result<MooringState, ReadError> {
        let state = mooring.at(&Pose::default());
        state.map_err(|error| self.mistake(error))
    }

    /// An error of the mooring system at its line of the file.
    pub fn mistake(&self, error: MooringError) -> ReadError {
        let span = self.span(&error).unwrap_or(0..0);
        let mut mistake = Diagnostic::new(span, DiagnosticKind::Mooring(error));
        if self.spans.is_repeated {
            let hint = "points and lines are counted with the copies that `repeat` makes";
            mistake = mistake.with_hint(hint);
        }
        ReadError::mistake(&self.source, mistake)
    }

    /// Probable mistakes, each at its line of the file.
    pub fn warnings(&self, mooring: &Mooring, state: &MooringState) -> Vec<Note> {
        let warnings = mooring.warnings(state).into_iter();
        let notes = warnings.map(|warning| {
            let place = self.row(warning.item()).unwrap_or(0..0);
            Note::suspicious(warning.to_string()).at(&self.source, place.start)
        });
        notes.collect()
    }

    /// The byte range of each part, for a tower that has these lines.
    pub(crate) fn places(&self) -> impl Iterator<Item = (Place, Range<usize>)> {
        self.items()
            .map(|(item, span)| (Place::Mooring { item }, span))
    }

    fn items(&self) -> impl Iterator<Item = (MooringItem, Range<usize>)> {
        let spans = &self.spans;
        let kinds: [Rows<'_, MooringItem>; 5] = [
            (MooringItem::LineType, &spans.line_types),
            (MooringItem::Point, &spans.points),
            (MooringItem::Line, &spans.lines),
            (MooringItem::Body, &spans.bodies),
            (MooringItem::Rod, &spans.rods),
        ];
        let site = std::iter::once((MooringItem::Site, spans.site.clone()));
        site.chain(of_rows(kinds))
    }

    /// The file that was read.
    pub fn file(&self) -> &str {
        &self.source.name
    }

    /// The byte range of the part that an error is about.
    fn span(&self, error: &MooringError) -> Option<Range<usize>> {
        match error {
            MooringError::NoLines | MooringError::NotAtPlatform => Some(self.spans.heading.clone()),
            _ => self.row(error.item()),
        }
    }

    /// The byte range of the row of a part.
    fn row(&self, item: MooringItem) -> Option<Range<usize>> {
        let found = self.items().find(|(own, _)| *own == item);
        found.map(|(_, span)| span)
    }
}
