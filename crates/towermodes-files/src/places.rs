//! The places of the values of a tower in its files.

use std::collections::HashMap;
use std::ops::Range;

use towermodes::mooring::MooringItem;
use towermodes::{Place, TowerError};

use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// The key under which the byte range of a whole table is stored, for values that it does not
/// contain.
pub(crate) const TABLE: &str = "";

/// A kind of parts by their indices, and the byte range of each in a file.
pub(crate) type Rows<'a, P> = (fn(usize) -> P, &'a [Range<usize>]);

/// The byte range of each part of some kinds.
pub(crate) fn of_rows<'a, P: 'a>(
    kinds: impl IntoIterator<Item = Rows<'a, P>>,
) -> impl Iterator<Item = (P, Range<usize>)> {
    kinds.into_iter().flat_map(|(part, rows)| {
        let rows = rows.iter().enumerate();
        rows.map(move |(index, span)| (part(index), span.clone()))
    })
}

/// The place of each value of a tower: file and byte range.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Places {
    spans: HashMap<Place, (usize, Range<usize>)>,
}

impl Places {
    /// Records the place of a value: index of the file among the files of the tower, from 0, and
    /// byte range.
    pub(crate) fn remember(&mut self, place: Place, file: usize, span: Range<usize>) {
        self.spans.insert(place, (file, span));
    }

    /// A mistake found by the tower's own checks: its file, and its place there. Hints that mention
    /// keys of TOML, or heights in its datum, apply to TOML and to input values that were set by
    /// name, whose files come after the first `files` files.
    pub(crate) fn mistake(
        &self,
        error: &TowerError,
        is_toml: bool,
        files: usize,
    ) -> (usize, Diagnostic) {
        let (file, span) = self.find(error.place);
        let diagnostic = Diagnostic::new(span, DiagnosticKind::Tower(error.problem.clone()));
        let of_toml = |hint: &&str| hint.contains(['[', '_', '"']) || hint.contains("datum");
        let is_set = file >= files;
        let hint = error.hint();
        let hint = hint.filter(|hint| is_toml || is_set || !of_toml(hint));
        // The file beside a tower file is the table of its stations, whose header has the units.
        let hint = match is_toml && file > 0 && !is_set {
            true => Some("the unit is given in the header of the column"),
            false => hint,
        };
        let diagnostic = match hint {
            Some(hint) => diagnostic.with_hint(hint),
            None => diagnostic,
        };
        (file, diagnostic)
    }

    /// The place of a value; for a missing value the place of its table, or of the stations.
    fn find(&self, place: Place) -> (usize, Range<usize>) {
        let found = self.own(place).or_else(|| self.spans.get(&Place::Stations));
        found.cloned().unwrap_or((0, 0..0))
    }

    /// The place of a value itself.
    pub(crate) fn exact(&self, place: Place) -> Option<&(usize, Range<usize>)> {
        self.spans.get(&place)
    }

    /// The place of a value, or of the table in which it is missing.
    pub(crate) fn own(&self, place: Place) -> Option<&(usize, Range<usize>)> {
        let places = [place, table_of(place)];
        places.iter().find_map(|place| self.spans.get(place))
    }
}

/// The place of the whole table that a value belongs to, if it is stored.
fn table_of(place: Place) -> Place {
    let key = TABLE;
    match place {
        Place::Foundation { .. } => Place::Foundation { key },
        Place::Mooring { .. } => Place::Mooring {
            item: MooringItem::Site,
        },
        Place::Rna { .. } => Place::Rna { key },
        Place::Station { index, .. } => Place::Station { index, key },
        Place::Material { index, .. } => Place::Material { index, key },
        Place::PointMass { index, .. } => Place::PointMass { index, key },
        Place::Soil { layer, .. } => Place::Soil { layer, row: 0, key },
        Place::Ground { .. } => Place::Ground { key },
        Place::GroundLayer { index, .. } | Place::GroundRow { layer: index, .. } => {
            Place::GroundLayer { index, key }
        }
        Place::AddedMass { table, .. } => Place::AddedMass { table, row: 0, key },
        Place::Rotor { .. } => Place::Rotor { key },
        Place::Damping { .. } => Place::Damping { key },
        Place::Drivetrain { .. } => Place::Drivetrain { key },
        Place::Water { .. } => Place::Water { key },
        Place::Wires { index, .. } => Place::Wires { index, key },
        other => other,
    }
}
