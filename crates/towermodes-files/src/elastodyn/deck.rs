//! A tower from the files of an ElastoDyn model: main file, tower file, blade files.

use std::collections::HashMap;
use std::ops::Range;

use towermodes::{Foundation, Place, RigidBody};

use super::blade_file::{BladeFile, BladeMasses, read_blade_file};
use super::description::{
    Ends, ONLY_BENDS, description, hanging_note, remember, tuner_note, upside_down,
};
use super::fst::{Gravity, Main, gravity, main_source};
use super::lump;
use super::main_file::MainFile;
use super::main_reader::read_main_file;
use super::names::{is_blade_file, is_main_file, is_tower_file};
use super::rotor;
use super::tower_file::{CoefficientSpans, TowerFile};
use super::tower_reader::{TowerReading, read_with_places};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::input::{FileFormat, OutLayout, ReadOptions, RotorLock, TowerInput};
use crate::note::{Note, RotorNotes};
use crate::places::{Places, TABLE};
use crate::resolver::FileResolver;
use crate::source::Source;

/// An ElastoDyn model and the tower that it describes.
#[derive(Debug, Clone)]
pub struct ElastoDynDeck {
    /// The main file's content.
    pub main: MainFile,
    /// The main file.
    pub main_source: Source,
    /// The tower file's content.
    pub tower: TowerFile,
    /// The places of the coefficients in the tower file.
    pub coefficient_spans: CoefficientSpans,
    /// The tower file.
    pub tower_source: Source,
    /// Mass of each blade and its moments.
    pub blades: Vec<BladeMasses>,
    /// Everything above the tower top as one body.
    pub rna: RigidBody,
    /// The tower.
    pub input: TowerInput,
}

/// Reads an ElastoDyn model from its main file, or from the `.fst` file that names it; `files`
/// gives the files that it names.
///
/// # Errors
/// The first mistake in one of the files, or that one of them cannot be read.
pub fn read_elastodyn(
    source: Source,
    files: &dyn FileResolver,
    options: &ReadOptions,
) -> Result<ElastoDynDeck, ReadError> {
    refuse_parts(&source)?;
    let Main {
        source: main_source,
        fst,
        folder,
        gravity_m_per_s2,
        notes,
    } = main_source(source, files)?;
    let main = read_main_file(&main_source).map_err(|m| ReadError::mistake(&main_source, m))?;
    let named = Named {
        source: &main_source,
        folder: &folder,
        files,
    };
    let tower_source = named.read(&main.tower_file, "TwrFile", main.place("TwrFile"))?;
    let reading =
        read_with_places(&tower_source).map_err(|m| ReadError::mistake(&tower_source, m))?;
    let blades = match options.without_rna {
        true => Blades::default(),
        false => blades(&main, &named)?,
    };
    let rna = rna(&main, &main_source, &blades.masses, options)?;
    let mut sources: Vec<Source> = fst.into_iter().collect();
    sources.extend([main_source.clone(), tower_source.clone()]);
    let tower_index = sources.len() - 1;
    sources.extend(blades.sources);
    let fst_name = sources[0].name.clone();
    let mut input = input(&main, &reading, rna, sources, tower_index);
    if !options.without_rna {
        let notes = lump::notes(&main, &main_source, &blades.masses, options.rotor);
        input.notes.extend(notes);
    }
    if !options.without_gravity {
        let of_fst = gravity_m_per_s2.map(|value| (value, fst_name.as_str()));
        let Gravity { m_per_s2, note } = gravity(&main, &main_source.name, of_fst);
        input.description.gravity_m_per_s2 = m_per_s2;
        input.notes.extend(note);
    }
    input.notes.splice(0..0, notes);
    input.blade = blades.first.map(|file| rotor::blade(&main, &file));
    input.rotor_notes = rotor::notes(&main, &main_source, input.blade.is_some());
    Ok(ElastoDynDeck {
        main,
        main_source,
        tower: reading.file,
        coefficient_spans: reading.spans.coefficients,
        tower_source,
        blades: blades.masses,
        rna,
        input,
    })
}

/// Everything above the tower top as one body, if it is wanted.
fn rna(
    main: &MainFile,
    source: &Source,
    blades: &[BladeMasses],
    options: &ReadOptions,
) -> Result<RigidBody, ReadError> {
    if options.without_rna {
        return Ok(RigidBody::default());
    }
    if options.rotor == RotorLock::Free {
        let checked = lump::check_free_rotor(main, blades);
        checked.map_err(|mistake| ReadError::mistake(source, mistake))?;
    }
    let rna = lump::lump_rna(main, blades, options.rotor);
    Ok(match main.tower_hangs() {
        true => upside_down(&rna),
        false => rna,
    })
}

/// Refuses files that are only a part of a model.
fn refuse_parts(source: &Source) -> Result<(), ReadError> {
    let part = match &source.text {
        text if is_main_file(text) => return Ok(()),
        text if is_tower_file(text) => "tower",
        text if is_blade_file(text) => "blade",
        _ => return Ok(()),
    };
    let found = format!("a {part} file of ElastoDyn, not a main file");
    let mistake = Diagnostic::new(0..0, DiagnosticKind::WrongFile { found })
        .with_hint("give the main file that names it");
    Err(ReadError::mistake(source, mistake))
}

/// The files that a main file names.
struct Named<'a> {
    source: &'a Source,
    /// The folder of the main file as seen from where the files are.
    folder: &'a str,
    files: &'a dyn FileResolver,
}

impl Named<'_> {
    fn read(&self, path: &str, key: &str, span: Range<usize>) -> Result<Source, ReadError> {
        self.files
            .read(&beside(self.folder, path))
            .map_err(|error| {
                let kind = DiagnosticKind::unreadable(key, &error);
                let hint = match key.starts_with("Bld") {
                    true => "files are searched beside the main file; without the rotor-nacelle assembly (--no-rna) blade files are not needed",
                    false => "files are searched beside the main file",
                };
                ReadError::mistake(self.source, Diagnostic::new(span, kind).with_hint(hint))
            })
    }
}

/// A path that is relative to a folder, as seen from where the folder is.
fn beside(folder: &str, path: &str) -> String {
    let is_absolute = path.starts_with(['/', '\\']) || path.chars().nth(1) == Some(':');
    if is_absolute || folder.is_empty() {
        path.to_owned()
    } else {
        format!("{folder}/{path}")
    }
}

/// The content of the blade files.
#[derive(Default)]
struct Blades {
    /// The files without repetition.
    sources: Vec<Source>,
    /// Of each blade.
    masses: Vec<BladeMasses>,
    first: Option<BladeFile>,
}

fn blades(main: &MainFile, named: &Named<'_>) -> Result<Blades, ReadError> {
    let mut blades = Blades::default();
    let mut read: HashMap<&str, BladeFile> = HashMap::new();
    for (path, key) in main
        .blade_files
        .iter()
        .zip(["BldFile(1)", "BldFile(2)", "BldFile(3)"])
    {
        if !read.contains_key(path.as_str()) {
            let source = named.read(path, key, main.place(key))?;
            let blade = read_blade_file(&source).map_err(|m| ReadError::mistake(&source, m))?;
            blades.sources.push(source);
            blades.first.get_or_insert_with(|| blade.clone());
            read.insert(path, blade);
        }
        blades.masses.extend(
            read.get(path.as_str())
                .map(|blade| blade.masses(main.blade_length_m())),
        );
    }
    Ok(blades)
}

/// The tower of a model with its notes.
fn input(
    main: &MainFile,
    reading: &TowerReading,
    rna: RigidBody,
    sources: Vec<Source>,
    tower_index: usize,
) -> TowerInput {
    let ends = Ends::of(main.tower_base_m, main.tower_top_m);
    let mut description = description(&reading.file, ends, &main.header[1]);
    description.rna = rna.into();
    description.foundation = Foundation::Clamped;
    description.rotor = rotor::rotor(main);
    let mut places = Places::default();
    remember(&mut places, tower_index, &reading.spans);
    for (key, name) in [
        ("mass", "NacMass"),
        ("center", "NacCMxn"),
        ("inertia", "NacYIner"),
        (TABLE, "NacMass"),
    ] {
        places.remember(Place::Rna { key }, tower_index - 1, main.place(name));
    }
    places.remember(Place::Gravity, tower_index - 1, main.place("Gravity"));
    for (key, name) in [("blades", "NumBl"), ("rpm", "RotSpeed")] {
        places.remember(Place::Rotor { key }, tower_index - 1, main.place(name));
    }
    let mut notes = reading.notes.clone();
    notes.extend(tuner_note(&reading.file));
    notes.push(Note::new(ONLY_BENDS));
    notes.extend(foundation_note(main));
    if main.tower_hangs() {
        notes.push(hanging_note(ends));
    }
    TowerInput {
        format: FileFormat::ElastoDyn,
        description,
        borders_m: None,
        method: None,
        modes: None,
        blades: Some(main.blade_count),
        blade: None,
        joint_m: None,
        layout: OutLayout::default(),
        notes,
        rotor_notes: RotorNotes::default(),
        sources,
        places,
    }
}

/// The note on a foundation that is not in these files.
fn foundation_note(main: &MainFile) -> Option<Note> {
    let moves = main.platform_dofs.contains(&true);
    let base_m = main.tower_base_m;
    if !moves && base_m == 0.0 {
        return None;
    }
    let why = if moves { " (the platform moves)" } else { "" };
    let message =
        format!("the tower is clamped at z = {base_m} m{why}; its foundation is in other files");
    Some(match moves {
        true => Note::missing_part(message),
        false => Note::assumption(message),
    })
}
