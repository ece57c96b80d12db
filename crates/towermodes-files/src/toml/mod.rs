//! Reads and writes towers in TOML.

mod design;
mod file;
mod foundation;
mod ground;
mod inputs;
mod measured;
mod mooring;
mod schema;
mod study;
mod study_file;
mod substructure;
mod synonyms;
mod tables;
mod text;
mod turbine;
mod write;

use ::toml::de::DeTable;
use towermodes::turbine::TurbineDescription;
use towermodes::{Place, Tower, TowerDescription};

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::input::{FileFormat, TowerInput};
use crate::note::Note;
use crate::places::Places;
use crate::resolver::FileResolver;
use crate::source::{FileError, Source};
use schema::FILE;
use text::reading::{ProfileFile, Reading, STATION_FILE};
use text::syntax::syntax_mistake;
use text::table::Table;

pub use design::{design_study_schema, read_design_study};
pub use measured::{measured_schema, read_measured};
pub use schema::{KeySchema, TableSchema, ValueKind, tower_file_schema};
pub use study::{read_sweep_study, sweep_study_schema};
pub use text::entry::entry_at;
pub use text::rewrite::{Rewritten, WrittenAnew, rewritten};
pub(crate) use write::can_be_written;
pub use write::{write_toml, write_toml_with};

/// Reads a tower from the text of a TOML file.
///
/// The format is described in the book's reference; every example in the repository is commented.
///
/// # Errors
/// The mistakes found, at most a hundred, in the order of the lines; never an empty list. Stations
/// in a separate file are a mistake here: use [`read_tower`](crate::read_tower).
pub fn tower_from_toml(text: &str) -> Result<Tower, Vec<Diagnostic>> {
    let reading = describe(text, None).map_err(Refused::in_text)?;
    let places = reading.places;
    Tower::new(reading.description).map_err(|error| vec![places.mistake(&error, true, 1).1])
}

/// Reads the description of a tower from the text of a TOML file, without the checks of
/// [`Tower::new`].
///
/// # Errors
/// All mistakes of the file itself, as in [`tower_from_toml`].
pub fn description_from_toml(text: &str) -> Result<TowerDescription, Vec<Diagnostic>> {
    let described = describe(text, None).map_err(Refused::in_text)?;
    Ok(described.description)
}

/// Reads a tower from a TOML file; `files` gives the file of the stations if there is one.
///
/// # Errors
/// [`ReadError::Mistakes`] with all mistakes that were found.
pub(crate) fn read_toml(source: Source, files: &dyn FileResolver) -> Result<TowerInput, ReadError> {
    match describe(&source.text, Some(files)) {
        Ok(described) => {
            let mut input = TowerInput::new(FileFormat::Toml, described.description, vec![source]);
            // The user can correct what these notes are about.
            let notes = described.notes.iter();
            let notes =
                notes.map(|(at, message)| Note::suspicious(*message).at(&input.sources[0], *at));
            input.notes = notes.chain(described.other_notes).collect();
            input.places = described.places;
            input.sources.extend(described.others);
            let of_turbine = described.turbine.as_ref().map(|turbine| turbine.blades);
            input.blades = input.blades.or(of_turbine);
            input.turbine = described.turbine;
            Ok(input)
        }
        Err(Refused::Text(mistakes)) => Err(ReadError::mistakes(&source, mistakes)),
        Err(Refused::OtherFile(file, mistakes)) => Err(ReadError::mistakes(&file, mistakes)),
    }
}

/// The description in a file, the places of its values, and the files that it names.
struct Described {
    description: TowerDescription,
    places: Places,
    notes: Vec<(usize, &'static str)>,
    /// Notes on the files that it names.
    other_notes: Vec<Note>,
    others: Vec<Source>,
    turbine: Option<TurbineDescription>,
}

/// The mistakes of a tower file, or of a file that it names.
enum Refused {
    Text(Vec<Diagnostic>),
    OtherFile(Source, Vec<Diagnostic>),
}

impl Refused {
    /// The mistakes of a text that names no files.
    fn in_text(self) -> Vec<Diagnostic> {
        match self {
            Self::Text(mistakes) | Self::OtherFile(_, mistakes) => mistakes,
        }
    }
}

impl From<Diagnostic> for Refused {
    fn from(mistake: Diagnostic) -> Self {
        Self::Text(vec![mistake])
    }
}

/// The file that a value in nested tables names, if it is a text.
fn named_file(
    root: &DeTable<'_>,
    tables: &[&str],
    key: &str,
    files: Option<&dyn FileResolver>,
) -> Option<Result<Source, FileError>> {
    let inner = tables.iter().try_fold(root, |table, name| {
        table
            .get(*name)
            .and_then(|table| table.get_ref().as_table())
    });
    let path = inner?.get(key)?.get_ref().as_str()?;
    files.map(|files| files.read(path))
}

/// The files that a tower file names, in the order of their indices.
fn others(stations: Vec<Source>, profiles: Vec<ProfileFile>, blade: Option<Source>) -> Vec<Source> {
    let profiles = profiles.into_iter().filter_map(|file| file.source.ok());
    stations.into_iter().chain(profiles).chain(blade).collect()
}

/// Reads the description of a file.
fn describe(text: &str, files: Option<&dyn FileResolver>) -> Result<Described, Refused> {
    if text.trim().is_empty() {
        let hint = "a tower needs at least [material] and [tower] with its stations";
        let mistake = Diagnostic::new(0..0, DiagnosticKind::EmptyFile);
        return Err(mistake.with_hint(hint).into());
    }
    let document = DeTable::parse(text).map_err(|error| syntax_mistake(&error, text))?;
    let root = document.get_ref();
    if root.contains_key("design") && !root.contains_key("tower") {
        let found = "the study of a design, not a tower".to_owned();
        let mistake = Diagnostic::new(0..0, DiagnosticKind::WrongFile { found });
        let hint = "give it after the tower: `towermodes design TOWER STUDY`";
        return Err(mistake.with_hint(hint).into());
    }
    if root.contains_key("measured") && !root.contains_key("tower") {
        let found = "a file of measured frequencies, not a tower".to_owned();
        let mistake = Diagnostic::new(0..0, DiagnosticKind::WrongFile { found });
        let hint = "give it after the tower: `towermodes calibrate TOWER MEASURED`";
        return Err(mistake.with_hint(hint).into());
    }
    if root.contains_key("sweep") && !root.contains_key("tower") {
        let found = "a sweep study, not a tower".to_owned();
        let mistake = Diagnostic::new(0..0, DiagnosticKind::WrongFile { found });
        return Err(mistake
            .with_hint("run it with `towermodes sweep FILE`")
            .into());
    }
    let station_file = named_file(root, &["tower"], "stations", files);
    let first = STATION_FILE + usize::from(station_file.is_some());
    let mut reading = Reading {
        station_file,
        profiles: ground::profile_files(root, first, files),
        substructure_file: substructure::subdyn_file(
            named_file(root, &["substructure"], "file", files),
            files,
        ),
        blade_file: named_file(root, &["turbine", "blade"], "file", files),
        ..Reading::default()
    };
    let root = Table::root(document.get_ref(), text.len(), &FILE, &mut reading);
    let description = file::description(&root, &mut reading);
    let others = others(reading.others, reading.profiles, reading.blade_source);
    for (part, span) in reading.substructure_places {
        let place = Place::Substructure { part };
        reading.places.remember(place, 1 + others.len(), span);
    }
    // They are found table by table; people read the file line by line.
    reading.mistakes.sort_by_key(|mistake| mistake.span.start);
    match (description, reading.in_other_file) {
        (Some(description), None) if reading.mistakes.is_empty() => Ok(Described {
            description,
            places: reading.places,
            notes: reading.notes,
            other_notes: reading.substructure_notes,
            others: [others, reading.substructure_sources].concat(),
            turbine: reading.turbine,
        }),
        (_, Some((file, mistakes))) if reading.mistakes.is_empty() => {
            Err(Refused::OtherFile(file, mistakes))
        }
        _ => Err(Refused::Text(reading.mistakes)),
    }
}
