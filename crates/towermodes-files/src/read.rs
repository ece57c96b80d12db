//! Any file that describes a tower or a blade: its format recognized by its content and its name.

use std::path::Path;

use towermodes::Rna;

use crate::bmodes::{self, BmodesInput, read_bmodes};
use crate::companions::{Beside, Companions};
use crate::diagnostic::Diagnostic;
use crate::elastodyn::{self, read_elastodyn, read_elastodyn_tower};
use crate::hawc2::{self, read_hawc2};
use crate::input::{BladeInput, FileFormat, InputError, Note, ReadOptions, TowerInput};
use crate::source::Source;
use crate::toml::read_toml;
use crate::windio::{self, read_windio};

/// What is noted where a machine is to be left out and there is none.
pub const NOTHING_LEFT_OUT: &str =
    "the file has no rotor-nacelle assembly: --no-rna leaves nothing out";

/// What a file describes.
#[derive(Debug, Clone)]
pub enum Input {
    /// A tower.
    Tower(Box<TowerInput>),
    /// A rotating blade.
    Blade(Box<BladeInput>),
}

/// Reads a file from disk, with the files that it names.
///
/// # Errors
/// [`InputError`].
pub fn read(path: &Path, options: &ReadOptions) -> Result<Input, InputError> {
    read_source(Source::from_path(path)?, &Beside::file(path), options)
}

/// Reads a file whose text is known, with the files that it names.
///
/// # Errors
/// [`InputError`].
pub fn read_source(
    source: Source,
    companions: &dyn Companions,
    options: &ReadOptions,
) -> Result<Input, InputError> {
    source.check_is_itself()?;
    let mut tower = match recognize(&source) {
        Some(FileFormat::Toml) => read_toml(source, companions)?,
        Some(FileFormat::Bmodes) => match read_bmodes(source, companions, options)? {
            BmodesInput::Tower(tower) => *tower,
            BmodesInput::Blade(blade) => return Ok(Input::Blade(blade)),
        },
        Some(FileFormat::ElastoDyn) => read_elastodyn(source, companions, options)?.input,
        Some(FileFormat::ElastoDynTower) => read_elastodyn_tower(source, options)?,
        Some(FileFormat::WindIo) => read_windio(source, options)?,
        Some(FileFormat::Hawc2) => read_hawc2(source, options)?,
        None => return Err(unknown(&source)),
    };
    if options.without_rna {
        let rna = std::mem::take(&mut tower.description.rna);
        // Readers of turbines leave the machine out themselves.
        let is_tower_file = matches!(
            tower.format,
            FileFormat::Toml | FileFormat::Bmodes | FileFormat::ElastoDynTower | FileFormat::Hawc2
        );
        if is_tower_file && rna == Rna::default() {
            tower.notes.push(Note::new(NOTHING_LEFT_OUT));
        }
    }
    if options.without_gravity {
        tower.description.gravity_m_per_s2 = 0.0;
    }
    Ok(Input::Tower(Box::new(tower)))
}

/// What kind of file it is, if it is one that describes a tower or a blade.
pub fn recognize(source: &Source) -> Option<FileFormat> {
    let (name, text) = (source.name.as_str(), source.text.as_str());
    let ends_with = |ending: &str| {
        let from = name.len().checked_sub(ending.len());
        from.and_then(|from| name.get(from..))
            .is_some_and(|end| end.eq_ignore_ascii_case(ending))
    };
    let by_name = [
        (".toml", FileFormat::Toml),
        (".bmi", FileFormat::Bmodes),
        (".yaml", FileFormat::WindIo),
        (".yml", FileFormat::WindIo),
    ];
    let named = by_name.into_iter().find(|(ending, _)| ends_with(ending));
    if let Some((_, format)) = named {
        return Some(format);
    }
    let by_content = [
        (elastodyn::is_main_file(text), FileFormat::ElastoDyn),
        (elastodyn::is_fst(text), FileFormat::ElastoDyn),
        (elastodyn::is_tower_file(text), FileFormat::ElastoDynTower),
        (hawc2::is_hawc2(text, name), FileFormat::Hawc2),
        (bmodes::is_deck(text), FileFormat::Bmodes),
        (windio::is_windio(text, name), FileFormat::WindIo),
        (
            text.trim().is_empty() || looks_like_toml(text),
            FileFormat::Toml,
        ),
    ];
    let found = by_content.into_iter().find(|(is, _)| *is);
    found.map(|(_, format)| format)
}

/// Whether the first line that says something is a key with a value or the name of a table.
fn looks_like_toml(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with('#'));
    first.is_some_and(|line| line.starts_with('[') || line.contains('='))
}

fn unknown(source: &Source) -> InputError {
    let first_line = source.text.lines().next().unwrap_or_default().len();
    let is_csv = source.name.to_ascii_lowercase().ends_with(".csv");
    let (message, hint) = match part_of(&source.text) {
        None if is_csv => (
            "this is a table, which describes no tower by itself".to_owned(),
            "name it in a tower file: [tower] with stations = \"cans.csv\", and [material]".to_owned(),
        ),
        Some((part, whole)) => (
            format!("this is {part}, which describes no tower by itself"),
            format!("give {whole}"),
        ),
        None => (
            "this is no file that describes a tower".to_owned(),
            "give a tower in TOML, a BModes deck (.bmi), an ElastoDyn main or tower file, a turbine in windIO (.yaml) or a HAWC2 _st.dat".to_owned(),
        ),
    };
    let mistake = Diagnostic::new(0..first_line, message);
    InputError::mistake(source, mistake.with_hint(hint))
}

/// What a file is a part of, by words near its beginning: the part and what to give instead.
fn part_of(text: &str) -> Option<(&'static str, &'static str)> {
    let beginning: String = text.lines().take(25).collect::<Vec<_>>().join("\n");
    let beginning = beginning.to_lowercase();
    let parts = [
        (
            "nblinpst",
            "a blade file of ElastoDyn",
            "the main file that names it",
        ),
        (
            "sec_loc",
            "a section file of a BModes deck",
            "the .bmi file that names it",
        ),
        (
            "subdyn",
            "a file of SubDyn",
            "the main file of ElastoDyn: foundations of OpenFAST are not read",
        ),
        (
            "hydrodyn",
            "a file of HydroDyn",
            "the main file of ElastoDyn",
        ),
        ("aerodyn", "a file of AeroDyn", "the main file of ElastoDyn"),
        (
            "results generated by bmodes",
            "a result of BModes",
            "its .bmi file",
        ),
    ];
    let found = parts
        .into_iter()
        .find(|(word, ..)| beginning.contains(word));
    found.map(|(_, part, whole)| (part, whole))
}
