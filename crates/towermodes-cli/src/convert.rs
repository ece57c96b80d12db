//! `towermodes convert`.

use std::fs;
use std::path::Path;

use towermodes_analysis::elastodyn::MakeOptions;
use towermodes_files::elastodyn::{left_out, make_tower_file, write_tower_file};
use towermodes_files::{
    BmodesWriteOptions, Note, TowerInput, write_bmodes, write_toml, write_windio,
};

use crate::args::{ConvertArguments, Target};
use crate::failure::{Failure, note, report};
use crate::input::tower_input;
use crate::output::{check_not_input, check_not_inputs, deliver, deliver_both};

/// The files of a tower in another format.
struct Converted {
    text: String,
    /// A second file: its name and text.
    companion: Option<(String, String)>,
    notes: Vec<Note>,
}

/// Reads any tower and writes it in another format; data that the format cannot store are reported
/// on standard error.
pub(crate) fn run(arguments: &ConvertArguments) -> Result<(), Failure> {
    let output = arguments.output();
    check_not_input(&arguments.input.file, output)?;
    let to = arguments.to().map_err(Failure::Ending)?;
    let to = to.ok_or(Failure::Usage(NO_FORMAT))?;
    arguments.check(to).map_err(Failure::Usage)?;
    let input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let converted = match to {
        Target::Toml => to_toml(&input)?,
        Target::Bmodes => to_bmodes(&input, output)?,
        Target::Elastodyn => to_elastodyn(&input, arguments)?,
        Target::WindIo => to_windio(&input)?,
    };
    note(&input.notes);
    note(&rotor_notes(&input, to));
    note(&converted.notes);
    if let (Some((name, text)), Some(output)) = (&converted.companion, output) {
        let companion = output.with_file_name(name);
        check_not_inputs(input.files(), Some(&companion))?;
        check_is_own(&companion, output)?;
        deliver_both(
            (&companion, text.as_bytes()),
            (output, converted.text.as_bytes()),
        )?;
        report(&format!(
            "written: {}, {}\n",
            output.display(),
            companion.display()
        ));
        return Ok(());
    }
    deliver(converted.text.as_bytes(), output)
}

/// Neither the option nor the file extension gives a format.
const NO_FORMAT: &str =
    "the format of the output is not known: give --to toml, bmodes, elastodyn or windio";

/// Refuses to overwrite a section file without its deck, unless this program wrote it: then only an
/// interrupted conversion of this program can be lost.
fn check_is_own(companion: &Path, deck: &Path) -> Result<(), Failure> {
    if !companion.exists() || deck.exists() {
        return Ok(());
    }
    let old = fs::read_to_string(companion).unwrap_or_default();
    if is_own_sections(&old) {
        return Ok(());
    }
    Err(Failure::Refused(format!(
        "the section file {} already exists and was not written by this program; give --output another name or move that file",
        companion.display()
    )))
}

/// Whether a section file begins like those of [`write_bmodes`].
fn is_own_sections(text: &str) -> bool {
    let mut lines = text.lines();
    let title = lines.next().unwrap_or_default();
    let count = lines.next().unwrap_or_default();
    title.starts_with("Sections of ") && count.ends_with("n_secs: number of sections (-)")
}

/// The notes of the reader about the rotor, if the target format stores a rotor.
fn rotor_notes(input: &TowerInput, to: Target) -> Vec<Note> {
    let is_written = matches!(to, Target::Toml | Target::WindIo);
    match input.description.rotor {
        Some(_) if is_written => input.rotor_notes.of_rotor().cloned().collect(),
        _ => Vec::new(),
    }
}

fn to_toml(input: &TowerInput) -> Result<Converted, Failure> {
    // An invalid tower is not converted.
    input.tower().map_err(Failure::Input)?;
    let (text, notes) = write_toml(&input.description);
    Ok(Converted {
        text,
        companion: None,
        notes,
    })
}

fn to_bmodes(input: &TowerInput, output: Option<&Path>) -> Result<Converted, Failure> {
    let Some(stem) = output.and_then(Path::file_stem) else {
        return Err(Failure::Usage(
            "a BModes deck consists of two files: give --output PATH for the main file",
        ));
    };
    let tower = input.tower().map_err(Failure::Input)?;
    let sections_file = format!("{}_sections.dat", stem.to_string_lossy());
    let options = BmodesWriteOptions {
        sections_file: sections_file.clone(),
        ..BmodesWriteOptions::default()
    };
    let files = write_bmodes(&tower, &input.description, &options)
        .map_err(|error| Failure::Refused(error.to_string()))?;
    Ok(Converted {
        text: files.deck,
        companion: Some((sections_file, files.sections)),
        notes: files.notes,
    })
}

fn to_elastodyn(input: &TowerInput, arguments: &ConvertArguments) -> Result<Converted, Failure> {
    let tower = input.tower_for_shapes().map_err(Failure::Input)?;
    let options = MakeOptions {
        from_m: arguments.from_height.or(input.joint_m),
        has_concentrated_masses: true,
        ..MakeOptions::default()
    };
    let made = make_tower_file(&tower, &options).map_err(Failure::TowerFile)?;
    let has_masses = !made.content.concentrated_masses.is_empty();
    let text =
        write_tower_file(&made.content, has_masses).map_err(|error| Failure::tower_file(&error))?;
    let mut notes = made.notes;
    notes.extend(input.note_on_shapes());
    notes.extend(left_out(&input.description_for_shapes()));
    if has_masses {
        notes.push(Note::new(
            "the file contains concentrated masses, which need OpenFAST 4.2 or newer",
        ));
    }
    Ok(Converted {
        text,
        companion: None,
        notes,
    })
}

fn to_windio(input: &TowerInput) -> Result<Converted, Failure> {
    let tower = input.tower().map_err(Failure::Input)?;
    let (text, notes) = write_windio(&tower, &input.description)
        .map_err(|error| Failure::Refused(error.to_string()))?;
    Ok(Converted {
        text,
        companion: None,
        notes,
    })
}
