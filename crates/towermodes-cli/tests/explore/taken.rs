//! A file of the examples that is taken away from the page: `solve` and `campbell` of it give the
//! digits of the page.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use towermodes_testing::Says;

use super::answers::{changed, frequencies_hz, json_of, stem};
use super::server::Explorer;
use crate::pages::root;

/// A copy of the examples, because a tower file may name files beside it.
fn copy(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    copy_folder(&root().join("examples"), &folder);
    folder
}

fn copy_folder(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).expect("a folder");
    for entry in std::fs::read_dir(from).expect("a folder").flatten() {
        let target = to.join(entry.file_name());
        match entry.path().is_dir() {
            true => copy_folder(&entry.path(), &target),
            false => std::fs::copy(entry.path(), &target)
                .map(|_| ())
                .expect("copied"),
        }
    }
}

/// Every tower of the examples: the files that `explore` opens.
fn towers(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        let name = entry.file_name().to_string_lossy().into_owned();
        let is_tower = ["toml", "bmi", "yaml"].iter().any(|of| name.ends_with(of));
        // Studies and measured frequencies are no towers.
        let is_other = name.contains("frequency") || name == "studies";
        if path.is_dir() && !is_other {
            found.extend(towers(&path));
        } else if (is_tower && !is_other) || name == "ElastoDyn.dat" {
            found.push(path);
        }
    }
    found.sort();
    found
}

#[test]
fn examples_taken_away_have_the_bits_of_the_page() {
    let folder = copy("taken-away-examples");
    let towers = towers(&folder);
    assert!(towers.len() >= 20, "{towers:?}");
    for tower in towers {
        same_bits(&tower);
    }
}

/// The file that is taken away has the verdicts of the page without the options of the page.
#[test]
fn speeds_of_the_command_line_are_in_the_file() {
    let folder = copy("taken-away-speeds");
    let tower = folder.join("reference-tower.toml");
    let file = tower.to_string_lossy().into_owned();
    let explorer = Explorer::start(&[&file, "--rpm", "5,9", "--blades", "4"]);
    let question = json!({ "numbers": {}, "what": "tower" }).to_string();
    let taken = explorer.ask("POST", "take", question.as_bytes());
    let variant = folder.join("reference-tower-variant.toml");
    std::fs::write(&variant, &taken.body).expect("written");
    let found = json_of(&["campbell", &variant.to_string_lossy()]);
    let rotor = &found["rotor"];
    assert_eq!(
        *rotor,
        json_of(&["campbell", &file, "--rpm", "5,9", "--blades", "4"])["rotor"]
    );
}

fn same_bits(tower: &Path) {
    let file = tower.to_string_lossy().into_owned();
    let explorer = Explorer::start(&[&file]);
    let sheet = explorer.ask("GET", "sheet", b"").body;
    let (name, value) = changed(&serde_json::from_slice(&sheet).expect("JSON"));
    let set = format!("{name}={value:e}");
    let numbers = json!({ name: value });
    let answer = explorer.answer("solve", &json!({ "numbers": numbers }));
    let question = json!({ "numbers": numbers, "what": "tower" }).to_string();
    let taken = explorer.ask("POST", "take", question.as_bytes());
    let variant = tower.with_file_name(format!("{}-variant.toml", stem(&file)));
    std::fs::write(&variant, &taken.body).expect("written");
    if file.ends_with("nrel-5mw.toml") {
        let comments = |text: &str| text.matches('#').count();
        let original = std::fs::read_to_string(tower).expect("a file");
        assert_eq!(comments(&taken.text()), comments(&original));
    }
    let variant = variant.to_string_lossy().into_owned();
    let lacks =
        explorer.answer("reproduce", &json!({ "numbers": numbers }))["left_out"].to_string();
    // A tower file has no method; the page says so.
    let is_deck = file.ends_with(".bmi");
    let method: &[&str] = match is_deck {
        true => &["--method", "bmodes", "--segments", "60"],
        false => &[],
    };
    if is_deck {
        lacks.says("solved by the method bmodes with 60 prescribed elements");
    }
    let own = frequencies_hz(&answer["modes"]);
    // The page lists the modes up to the highest excitation; the digits are those of as many modes.
    let count = own.len().to_string();
    let modes = ["--modes", &*count];
    let solved = json_of(&[&["solve", &variant], &modes[..], method].concat());
    same(
        &own,
        &frequencies_hz(&solved["modes"]),
        rounding(&file),
        &file,
    );
    // A deck prescribes its number of modes too.
    let modes = if is_deck { &modes[..] } else { &[] };
    let theirs = [&["campbell", &variant], modes, method].concat();
    let [own, theirs] = [&["campbell", &file, "--set", &set], &theirs[..]].map(json_of);
    // The errors of lines are estimated from other meshes, which are not those of the deck.
    let parts: &[&str] = match is_deck {
        true => &["margins"],
        false => &["margins", "lines", "curves"],
    };
    assert_eq!(own["verdict"], theirs["verdict"], "{file}");
    for part in parts {
        let (own, theirs) = (numbers_of(&own[*part]), numbers_of(&theirs[*part]));
        same(&own, &theirs, rounding(&file), &format!("{file}: {part}"));
    }
}

/// A turbine and elements of another format are written in other quantities, which are rounded.
fn rounding(file: &str) -> f64 {
    match file.ends_with(".bmi") || file.ends_with(".dat") {
        true => 1e-12,
        false => 0.0,
    }
}

/// All numbers of a value, in order.
fn numbers_of(value: &Value) -> Vec<f64> {
    match value {
        Value::Number(number) => number.as_f64().into_iter().collect(),
        Value::Array(values) => values.iter().flat_map(numbers_of).collect(),
        Value::Object(values) => values.values().flat_map(numbers_of).collect(),
        Value::Null | Value::Bool(_) | Value::String(_) => Vec::new(),
    }
}

#[track_caller]
fn same(own: &[f64], theirs: &[f64], rounding: f64, what: &str) {
    assert_eq!(own.len(), theirs.len(), "{what}");
    for (own, theirs) in own.iter().zip(theirs) {
        let off = (own - theirs).abs();
        assert!(
            off <= rounding * own.abs().max(1.0),
            "{what}: {own} {theirs}"
        );
    }
}
