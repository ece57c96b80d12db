//! Files of measured frequencies: every mistake with its line and column, damaged files, the
//! schema.

use crate::sources::source;
use towermodes_files::{Diagnostic, ReadError, measured_schema, read_measured, read_tower};
use towermodes_testing::{Says, number, rows};

const RIGHT: &str = r#"
[calibrate.unknowns]
"foundation.rocking" = { prior = [1e10, 5e9], bounds = [1e9, 1e12] }
"rna.mass" = {}

[[measured]]
mode = "fore-aft 1"
frequency = 0.2585
deviation = 0.001
shape = [[10.0, 0.1, 0.0], [80.0, 1.0, 0.0]]
"#;

fn read(text: &str) -> Result<towermodes_files::MeasuredFile, ReadError> {
    read_measured(&source("measured.toml", text))
}

/// The mistakes of a file that is refused.
#[track_caller]
fn mistakes(text: &str) -> Vec<Diagnostic> {
    match read(text) {
        Err(ReadError::Mistakes { mistakes, .. }) => mistakes,
        other => panic!("{other:?}"),
    }
}

#[test]
fn everything_is_read() {
    let file = read(RIGHT).expect("a file");
    assert_eq!(file.unknowns[0].prior, Some([1e10, 5e9]));
    assert_eq!(file.unknowns[0].bounds, Some([1e9, 1e12]));
    assert_eq!(file.unknowns[1].prior, None);
    assert_eq!(file.unknowns[1].bounds, None);
    let one = &file.measured[0];
    assert_eq!(one.mode.expect("a mode").to_string(), "fore-aft 1");
    assert_eq!((one.frequency_hz, one.deviation_hz), (0.2585, 0.001));
    assert_eq!(one.shape, [[10.0, 0.1, 0.0], [80.0, 1.0, 0.0]]);
}

/// Each change of the right file, and what the message contains.
#[test]
fn every_mistake_is_at_its_place_with_what_would_be_right() {
    let table = r#"
        [1e10, 5e9] | [1e10, 0.0] | 3 | the standard deviation is 0
        [1e10, 5e9] | [1e10] | 3 | prior
        [1e10, 5e9] | 1e10 | 3 | a list in brackets
        [1e9, 1e12] | [1e12, 1e9] | 3 | the lower limit 1e12 is not below
        bounds = | bound = | 3 | did you mean `bounds`?
        "rna.mass" = {} | "rna.mass" = 3 | 4 | a table in braces
        fore-aft 1 | fore-aft | 7 | write `fore-aft 1`
        0.2585 | 0.0 | 8 | frequency
        0.2585 | "x" | 8 | a number
        deviation = 0.001 | deviaton = 0.001 | 9 | did you mean `deviation`?
        deviation = 0.001 |  | 6 | deviation
        0.001 | -0.001 | 9 | positive
        [10.0, 0.1, 0.0] | [10.0, 0.1] | 10 | height in m, fore-aft displacement
        [[10.0, 0.1, 0.0], [80.0, 1.0, 0.0]] | [[10.0, 0.0, 0.0]] | 10 | other than 0
        [calibrate.unknowns] | [calibrated.unknowns] | 2 | did you mean `calibrate`?
        [[measured]] | [measured] | 6 | double brackets
        "rna.mass" = {} | rna.mass = {} | 4 | the name `rna.mass` must be in quotation marks
        0.2585 | nan | 8 | NaN, not a finite number
        0.001 | 0 | 9 | deviation is 0, but must be positive
        "#;
    for [old, new, line, words] in rows(table) {
        let line = number(line);
        let text = RIGHT.replacen(old, new, 1);
        assert_ne!(text, RIGHT, "{old}");
        let mistakes = mistakes(&text);
        let said: Vec<String> = mistakes
            .iter()
            .map(|one| format!("{} {}", one.message(), one.hint.clone().unwrap_or_default()))
            .collect();
        let said = said.join("\n");
        assert!(said.contains(words), "{new}: {said}");
        let start = mistakes[0].span.start;
        let found = text[..start].lines().count().max(1);
        assert!(found.abs_diff(line) <= 1, "{new}: line {found}");
    }
}

/// Two frequencies of one mode would have to be weighted; of modes without a name each may be
/// another one.
#[test]
fn a_mode_is_measured_once() {
    let again = "[[measured]]\nmode = \"fore-aft 1\"\nfrequency = 0.26\ndeviation = 0.001\n";
    let mistakes = mistakes(&format!("{RIGHT}{again}"));
    assert_eq!(mistakes[0].span.start, RIGHT.len());
    let said = mistakes[0].message();
    said.says("the measured mode `fore-aft 1` occurs 2 times");
    let unnamed = again.replace("mode = \"fore-aft 1\"\n", "");
    let file = read(&format!("{RIGHT}{unnamed}{unnamed}")).expect("a file");
    assert_eq!(file.measured.len(), 3);
}

#[test]
fn other_files_are_recognized() {
    let table = r#"
         | the file is empty
        [tower]\n | a tower file, not measured frequencies
        [sweep]\n | a sweep study, not measured frequencies
        [calibrate]\n | measured
        [[measured]\n | invalid TOML
        "#;
    for [text, words] in rows(table) {
        let error = read(text).expect_err("refused").to_string();
        assert!(error.contains(words), "{text}: {error}");
    }
    let folder = std::env::temp_dir().join(format!("towermodes-measured-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join("measured.toml");
    std::fs::write(&path, RIGHT).expect("written");
    let error = read_tower(&path).expect_err("no tower").to_string();
    std::fs::remove_dir_all(&folder).expect("removed");
    error.says("measured frequencies, not a tower");
}

/// No text crashes the reader.
#[test]
fn damaged_files_are_refused_or_read() {
    let mut state = 7_u64;
    let mut random = |below: usize| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 33) as usize % below
    };
    for _ in 0..2000 {
        let mut bytes = RIGHT.as_bytes().to_vec();
        for _ in 0..=random(3) {
            if bytes.is_empty() {
                break;
            }
            let place = random(bytes.len());
            match random(3) {
                0 => bytes[place] = b"[]{}=\",.-e0\n"[random(12)],
                1 => drop(bytes.remove(place)),
                _ => bytes.truncate(place.max(1)),
            }
        }
        let _ = read(&String::from_utf8(bytes).expect("ASCII"));
    }
}

#[test]
fn every_key_is_in_the_book() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/calibrate.md");
    let page = std::fs::read_to_string(path).expect("the page");
    for table in measured_schema() {
        for key in table.key_names() {
            let forms = [format!("`{key}`"), format!("{key}]"), format!("[{key}.")];
            let is_there = forms.iter().any(|form| page.contains(form));
            assert!(is_there, "{key} of {}", table.name);
        }
    }
}
