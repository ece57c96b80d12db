//! `towermodes convert`.

use std::fs;
use std::path::Path;

use towermodes_files::{ConvertOptions, convert};

use crate::args::{ConvertArguments, Target};
use crate::explained::explained;
use crate::failure::Failure;
use crate::input::tower_input;
use crate::messages::{note, report};
use crate::output::{check_not_input, check_not_inputs, deliver, deliver_both};

/// Reads any tower and writes it in another format; data that the format cannot store are reported
/// on standard error.
pub(crate) fn run(arguments: &ConvertArguments) -> Result<(), Failure> {
    let output = arguments.output();
    check_not_input(&arguments.input.file, output)?;
    let to = arguments.to()?;
    let to = to.ok_or(Failure::usage(NO_FORMAT))?;
    arguments.check(to)?;
    let input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let options = options(arguments, to);
    let converted = convert(&input, to.format(), &options);
    let converted = match (converted, input.tower()) {
        (Err(failure), Ok(tower)) => explained(Err(failure), (&tower, &input)),
        (converted, _) => converted.map_err(Failure::from),
    }?;
    note(&input.notes);
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

/// The options of the conversion; the section file of a deck has the name of its main file.
fn options(arguments: &ConvertArguments, to: Target) -> ConvertOptions {
    let stem = arguments.output().and_then(Path::file_stem);
    let stem = stem.filter(|_| to == Target::Bmodes);
    ConvertOptions {
        sections_file: stem.map(|stem| format!("{}_sections.dat", stem.to_string_lossy())),
        from_height_m: arguments.from_height,
    }
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
    Err(Failure::failed(format!(
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
