//! A tower from TOML.

mod body;
mod file;
mod foundation;
mod gravity;
mod masses;
mod materials;
mod matrix;
mod numbers;
mod properties;
mod soil;
mod stations;
mod table;
mod values;
mod water;
mod wires;

use std::collections::HashMap;
use std::ops::Range;

use ::toml::de::DeTable;
use towermodes::{Place, Tower, TowerDescription, TowerError};

use crate::diagnostic::Diagnostic;
use table::Table;

/// The key under which the span of a whole table is remembered, for values that it leaves out.
const TABLE: &str = "";

/// What is collected while a file is read: mistakes, and where in the file each value of the tower came from.
#[derive(Debug, Default)]
struct Reading {
    mistakes: Vec<Diagnostic>,
    places: HashMap<Place, Range<usize>>,
}

impl Reading {
    fn mistake(&mut self, diagnostic: Diagnostic) {
        self.mistakes.push(diagnostic);
    }

    /// Remembers where a value stands, for mistakes that only the whole tower shows.
    fn remember(&mut self, place: Place, span: Range<usize>) {
        self.places.insert(place, span);
    }

    /// A mistake that the tower's own checks found, at its place in the file.
    fn tower_mistake(&self, error: &TowerError) -> Diagnostic {
        let diagnostic = Diagnostic::new(self.span(error.place), error.problem.to_string());
        match error.problem.hint() {
            Some(hint) => diagnostic.with_hint(hint),
            None => diagnostic,
        }
    }

    /// Where a value stands; one that is left out at its table, or at the stations.
    fn span(&self, place: Place) -> Range<usize> {
        let places = [place, table_of(place), Place::Stations];
        let span = places.iter().find_map(|place| self.places.get(place));
        span.cloned().unwrap_or(0..0)
    }
}

/// The place of the whole table that a value belongs to, if it is remembered.
fn table_of(place: Place) -> Place {
    let key = TABLE;
    match place {
        Place::Foundation { .. } => Place::Foundation { key },
        Place::Soil { layer, .. } => Place::Soil { layer, row: 0, key },
        Place::Water { .. } => Place::Water { key },
        Place::Wires { index, .. } => Place::Wires { index, key },
        other => other,
    }
}

/// Reads a tower from the text of a TOML file.
///
/// The format is described in the book's reference; every example in the repository is commented.
///
/// # Errors
/// All mistakes found, in the order of the file where they are of one kind; never an empty list.
pub fn tower_from_toml(text: &str) -> Result<Tower, Vec<Diagnostic>> {
    if text.trim().is_empty() {
        let hint = "a tower needs at least [material] and [tower] with its stations";
        return Err(vec![
            Diagnostic::new(0..0, "the file is empty").with_hint(hint),
        ]);
    }
    let document = DeTable::parse(text).map_err(|error| vec![syntax_mistake(&error, text)])?;
    let mut reading = Reading::default();
    let root = Table::root(document.get_ref(), text.len(), &file::FILE, &mut reading);
    let description = file::description(&root, &mut reading);
    match description {
        Some(description) if reading.mistakes.is_empty() => checked(description, &reading),
        _ => Err(reading.mistakes),
    }
}

fn checked(description: TowerDescription, reading: &Reading) -> Result<Tower, Vec<Diagnostic>> {
    Tower::new(description).map_err(|error| vec![reading.tower_mistake(&error)])
}

fn syntax_mistake(error: &::toml::de::Error, text: &str) -> Diagnostic {
    let span = error.span().unwrap_or(text.len()..text.len());
    let ends_early = span.start >= text.trim_end().len();
    let message = error.message().lines().collect::<Vec<_>>().join("; ");
    let diagnostic = Diagnostic::new(span, format!("cannot be read as TOML: {message}"));
    if ends_early {
        diagnostic.with_hint("the file ends here; is it complete?")
    } else {
        diagnostic
    }
}
