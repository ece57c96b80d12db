//! `towermodes report`.

use std::fs;
use std::path::Path;

use sha2::{Digest, Sha256};
use towermodes::Planes;
use towermodes::{Solution, Tower};
use towermodes_analysis::resonance::Campbell;
use towermodes_files::elastodyn::{MakeOptions, make_tower_file};
use towermodes_files::{FileFormat, Note, Source, TowerInput, encoded_as};
use towermodes_report::report::{
    ElastoDynShapes, InputFile, ReportContent, html, markdown, quoted,
};

use crate::args::{PageFormat, Prescribed, ReportArguments};
use crate::campbell::{campbell_of, solved_to_reach};
use crate::failure::{Failure, note, warn};
use crate::input::tower_input;
use crate::output::{check_not_input, check_not_inputs, check_terminal, deliver};
use crate::side_by_side::all_methods;

/// Reads the tower, computes all results and writes the report.
pub(crate) fn run(arguments: &ReportArguments) -> Result<(), Failure> {
    let output = arguments.output();
    check_not_input(&arguments.input.file, output)?;
    let format = arguments.format().map_err(Failure::Ending)?;
    let what = match format {
        PageFormat::Html => "a page of HTML",
        PageFormat::Md => "a report",
    };
    check_terminal(arguments.asked_output(), what, "report.html")?;
    let mut input = tower_input(&arguments.input)?;
    check_not_inputs(input.files(), output)?;
    let tower = input.tower().map_err(Failure::Input)?;
    let content = content(&mut input, tower, arguments)?;
    let text = match format {
        PageFormat::Html => html(&content).map_err(|error| Failure::Refused(error.to_string()))?,
        PageFormat::Md => markdown(&content),
    };
    note(&input.notes);
    warn(&content.solution.warnings, &input);
    deliver(text.as_bytes(), output)
}

/// The content of the report; the notes of the input include those about the rotor.
fn content(
    input: &mut TowerInput,
    tower: Tower,
    arguments: &ReportArguments,
) -> Result<ReportContent, Failure> {
    let prescribed = Prescribed::of(input);
    let mut options = arguments.options(prescribed).map_err(Failure::Usage)?;
    let is_given = arguments.has_modes();
    let solution = solved_to_reach(input, &tower, &arguments.rotor, &mut options, is_given)?;
    let campbell = resonance(input, &tower, &solution, arguments)?;
    // On a monopile the ElastoDyn tower is the part above it.
    let shapes_from_m = input.joint_m.unwrap_or(tower.base_m());
    input.notes.extend(input.note_on_shapes());
    let of_model = input.notes.iter().filter(|note| note.is_on_missing_part());
    Ok(ReportContent {
        title: arguments.title.clone().unwrap_or_default(),
        title_block: arguments.title_block(),
        description: input.description.clone(),
        comparison: all_methods(&tower, &options, arguments.segments),
        elastodyn: elastodyn(
            &input.tower_for_shapes().map_err(Failure::Input)?,
            shapes_from_m,
        ),
        shapes_from_m,
        campbell: campbell.map(Ok),
        tower,
        options,
        solution,
        notes: input.notes.iter().map(Note::to_string).collect(),
        model_notes: of_model.map(|note| note.message.clone()).collect(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        command_line: command_line(),
        reading: arguments.input.reading.typed(),
        is_own_format: input.format == FileFormat::Toml,
        files: input.sources().iter().map(input_file).collect(),
    })
}

/// The tower file that `towermodes elastodyn tower` writes.
fn elastodyn(tower: &Tower, from_m: f64) -> Result<ElastoDynShapes, String> {
    let options = MakeOptions {
        from_m: Some(from_m),
        ..MakeOptions::default()
    };
    let made = make_tower_file(tower, &options).map_err(|error| error.to_string())?;
    let quantities = made.quantities;
    Ok(ElastoDynShapes {
        shapes: made.shapes,
        frequency_alone_hz: Planes {
            fore_aft: quantities.fore_aft.frequency_alone_hz,
            side_side: quantities.side_side.frequency_alone_hz,
        },
    })
}

/// The resonance check; none if the rotor speed is not given.
fn resonance(
    input: &mut TowerInput,
    tower: &Tower,
    solution: &Solution,
    arguments: &ReportArguments,
) -> Result<Option<Campbell>, Failure> {
    match campbell_of(input, tower, solution, &arguments.rotor) {
        Ok((campbell, notes)) => {
            input.notes.extend(notes);
            Ok(Some(campbell))
        }
        Err(Failure::NoRotor { .. }) if !arguments.rotor.is_given() => Ok(None),
        Err(failure) => Err(failure),
    }
}

/// The command as it was typed.
fn command_line() -> String {
    let arguments = std::env::args_os().skip(1);
    let quoted = arguments.map(|argument| quoted(&argument.to_string_lossy()));
    let words: Vec<String> = std::iter::once("towermodes".to_owned())
        .chain(quoted)
        .collect();
    words.join(" ")
}

fn input_file(source: &Source) -> InputFile {
    let on_disk = bytes_on_disk(source);
    let is_of_text = on_disk.is_none();
    let bytes = on_disk.unwrap_or_else(|| source.text.clone().into_bytes());
    InputFile {
        name: source.name.clone(),
        is_of_text,
        bytes: bytes.len() as u64,
        sha256: hexadecimal(&Sha256::digest(&bytes)),
        text: source.text.clone(),
    }
}

/// The bytes of an input file; none if it is not a file or has changed.
fn bytes_on_disk(source: &Source) -> Option<Vec<u8>> {
    let path = Path::new(&source.name);
    if !fs::metadata(path).is_ok_and(|of| of.is_file()) {
        return None;
    }
    let bytes = fs::read(path).ok()?;
    (encoded_as(&source.text, &bytes) == bytes).then_some(bytes)
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use towermodes_files::Source;

    use super::input_file;

    #[test]
    fn a_text_that_is_no_file_has_the_sum_of_its_bytes() {
        // FIPS 180-4's example "abc".
        let source = Source {
            name: "<standard input>".into(),
            text: "abc".into(),
        };
        let file = input_file(&source);
        assert!(file.is_of_text);
        assert_eq!(file.bytes, 3);
        assert_eq!(
            file.sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
        );
    }
}
