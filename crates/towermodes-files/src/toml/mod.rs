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
mod synonyms;
mod table;
mod values;
mod water;
mod wires;
mod write;

use std::ops::Range;

use ::toml::de::DeTable;
use towermodes::{Place, Tower, TowerDescription};

use crate::companions::Companions;
use crate::diagnostic::Diagnostic;
use crate::input::{FileFormat, InputError, Note, TowerInput};
use crate::places::{Places, TABLE};
use crate::source::{ReadError, Source};
use table::Table;

pub use write::write_toml;

/// More mistakes than these are not collected: the first ones say what is wrong with all, and each
/// may list many names.
const MAX_MISTAKES: usize = 100;

/// What is collected while a file is read: mistakes, and where in the file each value of the tower
/// came from.
#[derive(Debug, Default)]
struct Reading {
    mistakes: Vec<Diagnostic>,
    places: Places,
    /// The file with the stations that the tower file names, until its rows are read.
    station_file: Option<Result<Source, ReadError>>,
    /// That file, if it has mistakes, and these.
    in_station_file: Option<(Source, Vec<Diagnostic>)>,
    /// The files beside the tower file that were read.
    others: Vec<Source>,
    /// What the user should know, and at which byte of the file.
    notes: Vec<(usize, &'static str)>,
}

/// The place of the file with the stations among a tower's files.
const STATION_FILE: usize = 1;

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
/// The mistakes found, at most a hundred, in the order of the lines; never an empty list. Stations
/// in a file of their own are one: such a tower is read by [`read()`](crate::read()).
pub fn tower_from_toml(text: &str) -> Result<Tower, Vec<Diagnostic>> {
    let reading = describe(text, None).map_err(Refused::in_text)?;
    Tower::new(reading.description).map_err(|error| vec![reading.places.mistake(&error, true).1])
}

/// Reads what the text of a TOML file says of a tower, which [`Tower::new`] has yet to check.
///
/// # Errors
/// All mistakes of the file itself, as [`tower_from_toml`] has them.
pub fn description_from_toml(text: &str) -> Result<TowerDescription, Vec<Diagnostic>> {
    let described = describe(text, None).map_err(Refused::in_text)?;
    Ok(described.description)
}

/// Reads a tower from a TOML file; stations that are in a file of their own come from `companions`.
///
/// # Errors
/// [`InputError::Mistakes`] with all that were found.
pub(crate) fn read_toml(
    source: Source,
    companions: &dyn Companions,
) -> Result<TowerInput, InputError> {
    match describe(&source.text, Some(companions)) {
        Ok(described) => {
            let mut input = TowerInput::new(FileFormat::Toml, described.description, source);
            let notes = described.notes.iter();
            let notes = notes.map(|(at, message)| Note::at(&input.sources[0], *at, *message));
            input.notes = notes.collect();
            input.places = described.places;
            input.sources.extend(described.others);
            Ok(input)
        }
        Err(Refused::Text(mistakes)) => Err(InputError::mistakes(&source, mistakes)),
        Err(Refused::StationFile(file, mistakes)) => Err(InputError::mistakes(&file, mistakes)),
    }
}

/// What a file says, and where; and the files beside it.
struct Described {
    description: TowerDescription,
    places: Places,
    notes: Vec<(usize, &'static str)>,
    others: Vec<Source>,
}

/// The mistakes of a tower file, or of the file with its stations.
enum Refused {
    Text(Vec<Diagnostic>),
    StationFile(Source, Vec<Diagnostic>),
}

impl Refused {
    /// The mistakes of a text that has no files beside it.
    fn in_text(self) -> Vec<Diagnostic> {
        match self {
            Self::Text(mistakes) | Self::StationFile(_, mistakes) => mistakes,
        }
    }
}

impl From<Diagnostic> for Refused {
    fn from(mistake: Diagnostic) -> Self {
        Self::Text(vec![mistake])
    }
}

/// The file with the stations, if the tower names one.
fn station_file(
    root: &DeTable<'_>,
    companions: Option<&dyn Companions>,
) -> Option<Result<Source, ReadError>> {
    let tower = root.get("tower")?.get_ref().as_table()?;
    let path = tower.get("stations")?.get_ref().as_str()?;
    companions.map(|companions| companions.read(path))
}

/// What a file says, and where.
fn describe(text: &str, companions: Option<&dyn Companions>) -> Result<Described, Refused> {
    if text.trim().is_empty() {
        let hint = "a tower needs at least [material] and [tower] with its stations";
        return Err(Diagnostic::new(0..0, "the file is empty")
            .with_hint(hint)
            .into());
    }
    let document = DeTable::parse(text).map_err(|error| syntax_mistake(&error, text))?;
    let mut reading = Reading {
        station_file: station_file(document.get_ref(), companions),
        ..Reading::default()
    };
    let root = Table::root(document.get_ref(), text.len(), &file::FILE, &mut reading);
    let description = file::description(&root, &mut reading);
    // They are found table by table; a reader goes through the file line by line.
    reading.mistakes.sort_by_key(|mistake| mistake.span.start);
    match (description, reading.in_station_file) {
        (Some(description), None) if reading.mistakes.is_empty() => Ok(Described {
            description,
            places: reading.places,
            notes: reading.notes,
            others: reading.others,
        }),
        (_, Some((file, mistakes))) if reading.mistakes.is_empty() => {
            Err(Refused::StationFile(file, mistakes))
        }
        _ => Err(Refused::Text(reading.mistakes)),
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
