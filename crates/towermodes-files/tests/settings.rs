//! Numbers that are set by name after a file is read: values, notes, places of errors and warnings.

use std::path::{Path, PathBuf};

use towermodes::Place;
use towermodes_files::{Setting, TowerInput, read_tower};
use towermodes_testing::Says;

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../examples")
        .join(name)
}

fn input(name: &str) -> TowerInput {
    read_tower(example(name)).expect("a tower").input
}

/// The input with numbers set by these texts.
#[track_caller]
fn set(name: &str, texts: &[&str]) -> TowerInput {
    let mut input = input(name);
    let settings = texts.iter().map(|text| text.parse().expect("a setting"));
    let settings: Vec<Setting> = settings.collect();
    input.set(&settings, "--set").expect("set");
    input
}

#[track_caller]
fn refused(texts: &[&str], words: &str) {
    let mut input = input("nrel-5mw.toml");
    let before = input.description.clone();
    let settings: Result<Vec<Setting>, _> = texts.iter().map(|text| text.parse()).collect();
    let done = settings.and_then(|settings| input.set(&settings, "--set"));
    done.expect_err("refused").says(words);
    assert_eq!(input.description, before);
}

#[test]
fn all_three_forms_change_the_tower_and_are_noted() {
    let old = input("nrel-5mw.toml");
    let input = set(
        "nrel-5mw.toml",
        &[
            "rna.mass = 3.6e5",
            "scale(stations[*].wall)=2",
            "add(stations[0].diameter)=0.5",
        ],
    );
    assert_eq!(input.description.rna.mass_kg, 3.6e5);
    let stations = input
        .description
        .stations
        .iter()
        .zip(&old.description.stations);
    for (new, old) in stations {
        assert_eq!(new.wall_thickness_m, 2.0 * old.wall_thickness_m);
    }
    let expected = old.description.stations[0].outer_diameter_m + 0.5;
    assert_eq!(input.description.stations[0].outer_diameter_m, expected);
    let notes: Vec<String> = input.notes.iter().map(ToString::to_string).collect();
    assert_eq!(
        notes[old.notes.len()..],
        [
            "rna.mass = 360000 kg by --set; the file has 350000",
            "scale(stations[*].wall) = 2 by --set: 2 values, now 0.0494 to 0.0702 m; the file has 0.0247 to 0.0351",
            "add(stations[0].diameter) = 0.5 by --set: now 6.5 m; the file has 6",
        ]
    );
}

#[test]
fn texts_that_are_no_settings() {
    refused(&["rna.mass"], "is not NAME=VALUE");
    refused(&["=3"], "is not NAME=VALUE");
    refused(&["rna.mass=heavy"], "is `heavy`, but must be a number");
    refused(
        &["rna.mass=360 t"],
        "write only the number, in the unit of the tower file",
    );
    let words = "values that are not numbers are changed in the tower file";
    refused(&["tower.shear=true"], words);
    refused(&["tower.stations=[[0, 4, 0.03]]"], words);
    refused(&["rna.mass=0,5"], "write a decimal point: 0.5");
    let words = "write 350000, or 350.000 if the comma is a decimal comma";
    refused(&["rna.mass=350,000"], words);
    refused(&["rna.mass=nan"], "must be a finite number");
    refused(&["rna.mass=1e999"], "must be a finite number");
    refused(&["scale(rna.mass)=inf"], "must be a finite number");
    refused(&["rna.mas=1"], "did you mean `rna.mass`?");
    refused(&["stations[7].wall=0.02"], "index 7 is too large");
    let words = "which `rna.mass` already changes";
    refused(&["rna.mass=1", "rna.mass=2"], words);
}

/// A rigid spring is a number that is set by a word.
#[test]
fn infinity_may_be_set() {
    let input = set("monopile.toml", &["gravity.acceleration=0"]);
    assert_eq!(input.description.gravity_m_per_s2, 0.0);
    for word in ["inf", "Infinity", "INF", "+inf"] {
        let setting: Setting = format!("foundation.lateral={word}")
            .parse()
            .expect("a setting");
        assert_eq!(setting.value(), f64::INFINITY);
    }
}

#[test]
fn an_impossible_value_is_shown_at_its_setting() {
    let input = set("nrel-5mw.toml", &["rna.mass=1", "stations[1].wall=9"]);
    let error = input.tower().expect_err("no tower").to_string();
    error.begins("--set:2:18: ");
    error.says("less than twice the wall thickness 9 m");
    // The value that is wrong is that of the file, beside a number that was set.
    let input = set("nrel-5mw.toml", &["stations[1].height=-1"]);
    input.tower().expect_err("no tower").begins("--set:1:20: ");
    let wall = Place::Station {
        index: 1,
        key: "height",
    };
    assert_eq!(input.line_of(wall), Some(("--set", 1)));
}

#[test]
fn an_error_in_the_file_beside_a_setting_says_so() {
    // The second row is below the first, which was raised.
    let input = set("nrel-5mw.toml", &["stations[0].height=90"]);
    let error = input.tower().expect_err("no tower").to_string();
    error.says_all("nrel-5mw.toml: & the line shown is from the file, without the change by --set");
}

#[test]
fn files_are_those_that_were_read() {
    let input = set("nrel-5mw.toml", &["rna.mass=1e5"]);
    assert_eq!(input.files().count(), 1);
    assert_eq!(input.sources().len(), 1);
}

/// The elements of a deck are at heights of its tower.
#[test]
fn borders_of_a_deck_are_dropped_with_a_note_if_heights_change() {
    assert!(input("nrel-5mw.bmi").prescribed.borders_m.is_some());
    let kept = set("nrel-5mw.bmi", &["scale(properties[*].mass_kg_per_m)=1.1"]);
    assert!(kept.prescribed.borders_m.is_some());
    let dropped = set("nrel-5mw.bmi", &["scale(properties[*].z_m)=1.1"]);
    assert!(dropped.prescribed.borders_m.is_none());
    let is_said = |note: &towermodes_files::Note| note.message.contains("elements of the deck");
    assert!(dropped.notes.iter().any(is_said));
}
