//! A tower from TOML, and back into it.

mod added_mass;
mod body;
mod file;
mod foundation;
mod gravity;
mod masses;
mod materials;
mod matrix;
mod numbers;
mod properties;
mod rotor;
mod soil;
mod stations;
mod table;
mod values;
mod water;
mod wires;
mod write;

use std::ops::Range;

use ::toml::de::DeTable;
use towermodes::{Place, Tower, TowerDescription};

use crate::diagnostic::Diagnostic;
use crate::input::{FileFormat, InputError, Note, TowerInput};
use crate::places::{Places, TABLE};
use crate::source::Source;
use table::Table;

pub use write::write_toml;

/// More mistakes than these are not collected: the first ones say what is wrong with all, and each may list many names.
const MAX_MISTAKES: usize = 100;

/// What is collected while a file is read: mistakes, and where in the file each value of the tower came from.
#[derive(Debug, Default)]
struct Reading {
    mistakes: Vec<Diagnostic>,
    places: Places,
    /// What the user should know, and at which byte of the file.
    notes: Vec<(usize, &'static str)>,
}

impl Reading {
    fn mistake(&mut self, diagnostic: Diagnostic) {
        if !self.is_full() {
            self.mistakes.push(diagnostic);
        }
    }

    /// Whether there are so many mistakes that no more are worth describing.
    fn is_full(&self) -> bool {
        self.mistakes.len() >= MAX_MISTAKES
    }

    fn note(&mut self, at: usize, message: &'static str) {
        self.notes.push((at, message));
    }

    /// Remembers where a value stands, for mistakes that only the whole tower shows.
    fn remember(&mut self, place: Place, span: Range<usize>) {
        self.places.remember(place, 0, span);
    }
}

/// Reads a tower from the text of a TOML file.
///
/// The format is described in the book's reference; every example in the repository is commented.
///
/// # Errors
/// The mistakes found, at most a hundred, in the order of the file where they are of one kind; never an empty list.
pub fn tower_from_toml(text: &str) -> Result<Tower, Vec<Diagnostic>> {
    let (description, reading) = describe(text)?;
    Tower::new(description).map_err(|error| vec![reading.places.mistake(&error, true).1])
}

/// Reads what the text of a TOML file says of a tower, which [`Tower::new`] has yet to check.
///
/// # Errors
/// All mistakes of the file itself, as [`tower_from_toml`] has them.
pub fn description_from_toml(text: &str) -> Result<TowerDescription, Vec<Diagnostic>> {
    describe(text).map(|(description, _)| description)
}

/// Reads a tower from a TOML file.
///
/// # Errors
/// [`InputError::Mistakes`] with all that were found.
pub(crate) fn read_toml(source: Source) -> Result<TowerInput, InputError> {
    match describe(&source.text) {
        Ok((description, reading)) => {
            let Reading { places, notes, .. } = reading;
            let notes = notes
                .iter()
                .map(|(at, message)| Note::at(&source, *at, *message));
            let notes = notes.collect();
            let input = TowerInput::new(FileFormat::Toml, description, source);
            Ok(TowerInput {
                places,
                notes,
                ..input
            })
        }
        Err(mistakes) => Err(InputError::mistakes(&source, mistakes)),
    }
}

/// What a file says, and what was collected while it was read.
fn describe(text: &str) -> Result<(TowerDescription, Reading), Vec<Diagnostic>> {
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
        Some(description) if reading.mistakes.is_empty() => Ok((description, reading)),
        _ => Err(reading.mistakes),
    }
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
