//! A tower in another format: the text of its file, and notes on data that the format cannot store.

use thiserror::Error;
use towermodes_analysis::elastodyn::{MakeError, MakeOptions};

use crate::bmodes::{BmodesWriteError, BmodesWriteOptions, write_bmodes};
use crate::elastodyn::left_out;
use crate::elastodyn::{TowerFileError, make_tower_file, write_tower_file};
use crate::error::ReadError;
use crate::input::TowerInput;
use crate::note::Note;
use crate::toml::{can_be_written, write_toml_with};
use crate::windio::{WindIoWriteError, write_windio};

/// A format in which towers can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutputFormat {
    /// The tower file of this program; stores all data.
    Toml,
    /// A deck of BModes 3.00, which consists of two files.
    Bmodes,
    /// A tower file of ElastoDyn.
    ElastoDyn,
    /// A turbine in windIO 2.0 that contains only tower and RNA.
    WindIo,
}

/// Data of a conversion that the tower does not contain.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ConvertOptions {
    /// Name of the section file of a BModes deck, relative to the deck; required for
    /// [`OutputFormat::Bmodes`].
    pub sections_file: Option<String>,
    /// Height at which the flexible tower of ElastoDyn begins, m; by default the joint with the
    /// monopile, otherwise the tower base.
    pub from_height_m: Option<f64>,
}

/// The files of a tower in another format.
#[derive(Debug, Clone, PartialEq)]
pub struct Converted {
    /// The text of the file.
    pub text: String,
    /// Name and text of the second file; only a deck of BModes has one.
    pub companion: Option<(String, String)>,
    /// The notes of the reader on the rotor and the turbine, if the format stores them. The other
    /// notes of the reader are in [`TowerInput::notes`].
    pub of_reader: Vec<Note>,
    /// Notes on data that the format cannot store.
    pub notes: Vec<Note>,
}

/// Why a tower cannot be written in a format.
#[derive(Debug, Error)]
pub enum ConvertError {
    /// The input is not a valid tower.
    #[error(transparent)]
    Input(#[from] ReadError),
    /// The second file of a BModes deck has no name.
    #[error("a BModes deck consists of two files, and the section file has no name")]
    NoSectionsFile,
    /// BModes cannot represent the tower.
    #[error(transparent)]
    Bmodes(#[from] BmodesWriteError),
    /// The tower has no shapes for ElastoDyn.
    #[error(transparent)]
    Shapes(#[from] MakeError),
    /// A tower file of ElastoDyn cannot store a value.
    #[error(transparent)]
    TowerFile(#[from] TowerFileError),
    /// windIO cannot represent the tower.
    #[error(transparent)]
    WindIo(#[from] WindIoWriteError),
}

/// Writes a tower in another format.
///
/// # Errors
/// [`ConvertError`].
///
/// # Example
/// ```
/// use towermodes_files::{ConvertOptions, OutputFormat, convert, read_tower};
///
/// let deck = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/nrel-5mw.toml");
/// let input = read_tower(deck)?.input;
/// let converted = convert(&input, OutputFormat::WindIo, &ConvertOptions::default())?;
/// assert!(converted.text.contains("outer_diameter"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn convert(
    input: &TowerInput,
    format: OutputFormat,
    options: &ConvertOptions,
) -> Result<Converted, ConvertError> {
    let mut converted = match format {
        OutputFormat::Toml => to_toml(input),
        OutputFormat::Bmodes => to_bmodes(input, options),
        OutputFormat::ElastoDyn => to_elastodyn(input, options),
        OutputFormat::WindIo => to_windio(input),
    }?;
    converted.of_reader.splice(0..0, rotor_notes(input, format));
    if matches!(format, OutputFormat::Toml | OutputFormat::WindIo) {
        converted.notes.extend(input.prescribed.left_out());
    }
    Ok(converted)
}

/// The notes of the reader about the rotor, if the format stores a rotor.
fn rotor_notes(input: &TowerInput, format: OutputFormat) -> Vec<Note> {
    let is_written = matches!(format, OutputFormat::Toml | OutputFormat::WindIo);
    match input.description.rotor {
        Some(_) if is_written => input.rotor_notes.of_rotor().cloned().collect(),
        _ => Vec::new(),
    }
}

fn to_toml(input: &TowerInput) -> Result<Converted, ConvertError> {
    // An invalid tower is not converted.
    input.tower()?;
    let turbine = input.turbine.as_ref();
    let (text, notes) = write_toml_with(&input.description, turbine);
    let is_written = turbine.is_some_and(|turbine| can_be_written(turbine, &input.description));
    let of_turbine = is_written.then(|| input.turbine_notes.clone());
    Ok(Converted {
        text,
        companion: None,
        of_reader: of_turbine.unwrap_or_default(),
        notes,
    })
}

fn to_bmodes(input: &TowerInput, options: &ConvertOptions) -> Result<Converted, ConvertError> {
    let sections_file = options.sections_file.as_ref();
    let sections_file = sections_file.ok_or(ConvertError::NoSectionsFile)?;
    let tower = input.tower()?;
    let options = BmodesWriteOptions {
        sections_file: sections_file.clone(),
        ..BmodesWriteOptions::default()
    };
    let description = input.description.with_ground_as_soil();
    let files = write_bmodes(&tower, &description, &options)?;
    let mut notes = files.notes;
    if input.description.ground.is_some() {
        let message = "the layers of the ground are written as the springs that follow from them";
        notes.push(Note::approximation(message));
    }
    Ok(Converted {
        text: files.deck,
        companion: Some((sections_file.clone(), files.sections)),
        of_reader: Vec::new(),
        notes,
    })
}

fn to_elastodyn(input: &TowerInput, options: &ConvertOptions) -> Result<Converted, ConvertError> {
    let tower = input.tower_for_shapes()?;
    let options = MakeOptions {
        from_m: options.from_height_m.or(input.joint_m),
        has_concentrated_masses: true,
        damping: input.damping_for_tower_file(),
        ..MakeOptions::default()
    };
    let made = make_tower_file(&tower, &options)?;
    let has_masses = !made.content.concentrated_masses.is_empty();
    let text = write_tower_file(&made.content, has_masses)?;
    let mut notes = made.notes;
    notes.extend(input.notes_on_tower_file());
    notes.extend(left_out(&input.description_for_shapes()));
    if has_masses {
        notes.push(Note::new(
            "the file contains concentrated masses, which need OpenFAST 4.2 or newer",
        ));
    }
    Ok(Converted {
        text,
        companion: None,
        of_reader: Vec::new(),
        notes,
    })
}

fn to_windio(input: &TowerInput) -> Result<Converted, ConvertError> {
    let tower = input.tower()?;
    let (text, notes) = write_windio(&tower, &input.description)?;
    Ok(Converted {
        text,
        companion: None,
        of_reader: Vec::new(),
        notes,
    })
}
