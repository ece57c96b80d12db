//! Where in its files each value of a tower came from.

use std::collections::HashMap;
use std::ops::Range;

use towermodes::{Place, TowerError};

use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// The key under which the span of a whole table is remembered, for values that it leaves out.
pub(crate) const TABLE: &str = "";

/// Where each value of a tower stands: in which of its files, and there at which bytes.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Places {
    spans: HashMap<Place, (usize, Range<usize>)>,
}

impl Places {
    /// Remembers where a value stands: in a file, by its place among the tower's files from 0, at
    /// these bytes.
    pub(crate) fn remember(&mut self, place: Place, file: usize, span: Range<usize>) {
        self.spans.insert(place, (file, span));
    }

    /// A mistake that the tower's own checks found: the file it is in, and where there. Hints that
    /// speak of the keys of TOML, or of heights in its datum, are for TOML alone.
    pub(crate) fn mistake(&self, error: &TowerError, is_toml: bool) -> (usize, Diagnostic) {
        let (file, span) = self.find(error.place);
        let diagnostic = Diagnostic::new(span, DiagnosticKind::Tower(error.problem.clone()));
        let of_toml = |hint: &&str| hint.contains(['[', '_', '"']) || hint.contains("datum");
        let hint = error
            .problem
            .hint()
            .filter(|hint| is_toml || !of_toml(hint));
        // The file beside a tower file is the table of its stations, whose header has the units.
        let hint = match is_toml && file > 0 {
            true => Some("the unit is that of the column's header"),
            false => hint,
        };
        let diagnostic = match hint {
            Some(hint) => diagnostic.with_hint(hint),
            None => diagnostic,
        };
        (file, diagnostic)
    }

    /// Where a value stands; one that is left out at its table, or at the stations.
    fn find(&self, place: Place) -> (usize, Range<usize>) {
        let found = self.own(place).or_else(|| self.spans.get(&Place::Stations));
        found.cloned().unwrap_or((0, 0..0))
    }

    /// Where a value stands, or the table that leaves it out.
    pub(crate) fn own(&self, place: Place) -> Option<&(usize, Range<usize>)> {
        let places = [place, table_of(place)];
        places.iter().find_map(|place| self.spans.get(place))
    }
}

/// The place of the whole table that a value belongs to, if it is remembered.
fn table_of(place: Place) -> Place {
    let key = TABLE;
    match place {
        Place::Foundation { .. } => Place::Foundation { key },
        Place::Rna { .. } => Place::Rna { key },
        Place::Station { index, .. } => Place::Station { index, key },
        Place::Material { index, .. } => Place::Material { index, key },
        Place::PointMass { index, .. } => Place::PointMass { index, key },
        Place::Soil { layer, .. } => Place::Soil { layer, row: 0, key },
        Place::AddedMass { table, .. } => Place::AddedMass { table, row: 0, key },
        Place::Rotor { .. } => Place::Rotor { key },
        Place::Water { .. } => Place::Water { key },
        Place::Wires { index, .. } => Place::Wires { index, key },
        other => other,
    }
}
