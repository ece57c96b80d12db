//! Slips in windIO files that a reader could pass over: misspelled keys, angles in the other unit,
//! tables that are not used, masses by another name.

use crate::sources::source;
use crate::windio_files;

use towermodes::{MissingPart, Options, solve};
use towermodes_files::{ReadError, ReadOptions, Source, TowerInput, TowerPart, read_windio};
use towermodes_testing::{Says, with};
use windio_files::{LAYERED, VERSION_1, VERSION_2};

fn read_with(text: &str, options: &ReadOptions) -> Result<TowerInput, ReadError> {
    let source = source("turbine.yaml", text);
    read_windio(source, options)
}

fn read(text: &str) -> TowerInput {
    read_with(text, &ReadOptions::default()).expect("a tower")
}

/// The notes with these words, each with its line.
fn notes(text: &str, words: &str) -> Vec<(usize, String)> {
    let notes = read(text).notes.into_iter();
    let placed = notes.filter(|note| note.message.contains(words));
    placed
        .map(|note| (note.place.map_or(0, |(_, line)| line), note.message))
        .collect()
}

/// The text with a change, which is there once, and the line of the change.
#[track_caller]
fn with(text: &str, old: &str, new: &str) -> (String, usize) {
    assert_eq!(text.matches(old).count(), 1, "{old}");
    let changed = text.replacen(old, new, 1);
    let at = text.find(old).expect("there");
    let line = changed[..at].matches('\n').count() + 1;
    (changed, line)
}

#[test]
fn misspelled_keys_are_noted_at_their_line() {
    for (text, key, misspelled, of) in [
        (
            VERSION_2,
            "outfitting_factor",
            "outfiting_factor",
            "tower.structure",
        ),
        (
            VERSION_2,
            "transition_piece_mass",
            "transition_peice_mass",
            "monopile",
        ),
        (VERSION_2, "    drivetrain", "    drivetrian", "components"),
        (VERSION_1, "environment:", "enviroment:", "the file"),
        (VERSION_1, "water_depth", "waterdepth", "environment"),
        (VERSION_1, "number_of_blades", "number_of_blade", "assembly"),
        (
            VERSION_1,
            "yaw_mass",
            "yawmass",
            "nacelle.elastic_properties_mb",
        ),
        (VERSION_1, "uptilt", "up_tilt", "nacelle.drivetrain"),
        (VERSION_1, "cone_angle", "coneangle", "hub"),
    ] {
        let (changed, line) = with(text, key, misspelled);
        let words = format!(
            "`{}` of {of} is not read: did you mean `{}`?",
            misspelled.trim().trim_end_matches(':'),
            key.trim().trim_end_matches(':')
        );
        let found = notes(&changed, &words);
        assert_eq!(found.len(), 1, "{misspelled}: {:?}", read(&changed).notes);
        assert_eq!(found[0].0, line, "{misspelled}");
    }
    // The slip changes the frequency, which is why it must be said.
    let first_hz = |text: &str| {
        let tower = read(text).tower().expect("a tower");
        solve(&tower, &Options::default()).expect("solved").modes[0].frequency_hz
    };
    let (changed, _) = with(VERSION_2, "transition_piece_mass", "transition_peice_mass");
    assert!(first_hz(&changed) > first_hz(VERSION_2));
}

#[test]
fn keys_of_the_format_that_are_not_read_are_not_noted() {
    let (text, _) = with(
        VERSION_2,
        "transition_piece_mass: 5e4",
        "transition_piece_mass: 5e4\n        transition_piece_cost: 1e5\n        my_own_key: 3",
    );
    assert!(notes(&text, "is not read").is_empty());
    let new = "yaw_mass: 200\n            system_inertia_tt: [1, 1, 1, 0, 0, 0]";
    let (text, _) = with(VERSION_1, "yaw_mass: 200", new);
    for text in [&text, LAYERED, windio_files::TABLE] {
        let holds = notes(text, "is not read").is_empty();
        assert!(holds, "{:?}", read(text).notes);
    }
}

#[test]
fn keys_of_a_part_that_is_not_wanted_are_not_noted() {
    let (text, _) = with(VERSION_2, "transition_piece_mass", "transition_peice_mass");
    let options = with!(ReadOptions, part = TowerPart::Tower);
    let input = read_with(&text, &options).expect("a tower");
    assert!(
        !input
            .notes
            .iter()
            .any(|note| note.message.contains("is not read"))
    );
}

#[test]
fn angles_in_the_other_unit_are_noted() {
    let noted = |text: &str, key: &str, value: &str| {
        let old = format!("{key}: 0.0");
        let (text, _) = with(text, &old, &format!("{key}: {value}"));
        notes(&text, &format!("{key} is {value}"))
    };
    for key in ["uptilt", "cone_angle"] {
        assert!(noted(VERSION_1, key, "0.1047").is_empty());
        assert!(noted(VERSION_1, key, "0.34").is_empty());
        assert_eq!(noted(VERSION_1, key, "0.36").len(), 1);
        let said = noted(VERSION_1, key, "6");
        said[0].1.says("6 degrees are 0.10472 rad");
    }
    let later = |value: &str| {
        let shaft = format!(
            "drivetrain:\n        outer_shape: {{uptilt: {value}, overhang: 5, distance_tt_hub: 3}}"
        );
        let hub = "hub: {diameter: 4, elastic_properties: {mass: 5e3}}\n    ";
        let (text, _) = with(VERSION_2, "drivetrain:", &format!("{hub}{shaft}"));
        notes(&text, "uptilt is")
    };
    for good in ["6.0", "0.0", "0.2", "20", "-5"] {
        assert!(later(good).is_empty(), "{good}");
    }
    later("0.1047")[0].1.says("are 5.99887 degrees");
    assert_eq!(later("20.1").len(), 1);
}

#[test]
fn angles_that_no_unit_makes_possible_are_refused() {
    let (text, line) = with(VERSION_1, "uptilt: 0.0", "uptilt: 6000");
    let error = read_with(&text, &ReadOptions::default()).expect_err("no tilt");
    let ReadError::Mistakes { mistakes, .. } = error else {
        panic!("{error}");
    };
    let said = mistakes[0].to_string();
    said.says_all("uptilt is 6000 rad & 0.10472");
    assert_eq!(mistakes[0].line_and_column(&text).0, line);
}

#[test]
fn lengths_of_the_machine_in_millimetres_are_noted() {
    let (text, line) = with(VERSION_1, "overhang: 5.0", "overhang: 5000");
    assert_eq!(notes(&text, "overhang is 5000 m")[0].0, line);
    let (text, _) = with(VERSION_1, "overhang: 5.0", "overhang: 49");
    assert!(notes(&text, "overhang is").is_empty());
}

/// Elastic properties with seven values on a grid of eleven, as in the example of the IEA 22 MW
/// turbine that comes with windIO 2.
const BROKEN_TABLE: &str = "elastic_properties:
                inertia_matrix: {grid: [0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1], mass: [1, 2, 3, 4, 5, 6, 7]}
                stiffness_matrix: {grid: [0, 1], K44: [1, 1], K55: [1, 1]}
";

#[test]
fn a_table_that_is_not_used_may_be_broken() {
    let new = format!("outfitting_factor: 1.05\n            {BROKEN_TABLE}");
    let (text, line) = with(LAYERED, "outfitting_factor: 1.05\n", &new);
    let found = notes(&text, "elastic properties of the tower cannot be read");
    assert_eq!(found.len(), 1, "{:?}", read(&text).notes);
    assert_eq!(found[0].0, line + 2);
    found[0]
        .1
        .says("has 7 values instead of 11, the number of values in its grid");
    assert_eq!(read(&text).description, read(LAYERED).description);
}

#[test]
fn a_table_that_is_needed_may_not() {
    let from = LAYERED.find("            layers:").expect("there");
    let to = LAYERED.find("        reference_axis").expect("there");
    let text = format!(
        "{}            {BROKEN_TABLE}{}",
        &LAYERED[..from],
        &LAYERED[to..]
    );
    let error = read_with(&text, &ReadOptions::default()).expect_err("no table");
    error.says("11, the number of values in its grid");
}

#[test]
fn the_mass_above_the_yaw_system_is_the_nacelles() {
    let rna = |text: &str| read(text).description.rna;
    let expected = rna(VERSION_1);
    let (text, line) = with(VERSION_1, "system_mass: 1000\n", "above_yaw_mass: 1000\n");
    assert_eq!(rna(&text), expected);
    let found = notes(&text, "above_yaw_mass = 1000 kg and no system_mass");
    assert_eq!(found[0].0, line);
    // The mass of the whole nacelle has the yaw system in it already.
    let new = "system_mass: 1200\n            above_yaw_mass: 1000\n";
    let (text, _) = with(VERSION_1, "system_mass: 1000\n", new);
    assert_eq!(rna(&text), expected);
    assert_eq!(
        notes(
            &text,
            "system_mass = 1200 kg: above_yaw_mass plus yaw_mass is used"
        )
        .len(),
        1
    );
}

/// WISDEM writes the masses of the nacelle under its drive train.
#[test]
fn the_nacelle_is_found_under_its_drive_train_too() {
    let expected = read(VERSION_1).description.rna;
    let (text, _) = with(
        VERSION_1,
        "        drivetrain: {uptilt: 0.0, distance_tt_hub: 2.0, overhang: 5.0}
        elastic_properties_mb:
            system_mass: 1000
            yaw_mass: 200
            system_inertia: [40, 50, 60, 0, 0, 0]
            system_center_mass: [0, 0, 1.0]
",
        "        drivetrain:
            uptilt: 0.0
            distance_tt_hub: 2.0
            overhang: 5.0
            elastic_properties_mb:
                system_mass: 1000
                yaw_mass: 200
                system_inertia: [40, 50, 60, 0, 0, 0]
                system_center_mass: [0, 0, 1.0]
",
    );
    assert_eq!(read(&text).description.rna, expected);
    assert!(notes(&text, "INCOMPLETE").is_empty());
}

/// Files of version 2 may have bodies by the keys of version 1.
#[test]
fn older_bodies_in_a_newer_file_are_read() {
    let (text, _) = with(
        VERSION_2,
        "    drivetrain:
        elastic_properties:
            mass: 100000
            inertia: [1.0e5, 2e5, 3e5, 0, 0, 0]
            location: [-1.0, 0.0, 2.0]
",
        "    hub: {diameter: 2, elastic_properties_mb: {system_mass: 500}}
    drivetrain:
        outer_shape: {uptilt: 0, overhang: 5, distance_tt_hub: 2}
        elastic_properties_mb: {system_mass: 1000, system_center_mass: [0, 0, 1]}
",
    );
    let rna = read(&text).description.rna;
    assert_eq!(rna.mass_kg, 1500.0);
    assert!((rna.center_m[0] + 5.0 * 500.0 / 1500.0).abs() < 1e-12);
}

/// The first files of version 1 have the whole assembly as one body, its inertia about the tower
/// top: 3000 kg at (-2, 0, 1) m add 3000, 15000 and 12000 kg m2 to the diagonal of an inertia of
/// 100, 200 and 300 kg m2, and 6000 kg m2 to the entry xz.
#[test]
fn a_whole_assembly_stands_for_its_parts() {
    let (start, rest) = VERSION_1.split_once("    hub:\n").expect("a hub");
    let (_, tower) = rest.split_once("    tower:\n").expect("a tower");
    let body = "    RNA:
        elastic_properties_mb:
            mass: 3000
            inertia: [3100, 15200, 12300, 0, 6000, 0]
            center_mass: [-2, 0, 1]
";
    let text = format!("{start}{body}    tower:\n{tower}");
    let rna = read(&text).description.rna;
    assert_eq!((rna.mass_kg, rna.center_m), (3000.0, [-2.0, 0.0, 1.0]));
    let inertia = rna.inertia_kg_m2;
    assert_eq!([inertia.xx, inertia.yy, inertia.zz], [100.0, 200.0, 300.0]);
    assert_eq!([inertia.xy, inertia.xz, inertia.yz], [0.0, 0.0, 0.0]);
    assert!(notes(&text, "INCOMPLETE").is_empty());
    let found = notes(&text, "the inertia of RNA is about the tower top").len();
    assert_eq!(found, 1);
}

#[test]
fn what_holds_the_tower_and_is_not_read_is_missing() {
    let text = VERSION_2.replacen(
        "components:\n",
        "components:\n    floating_platform: {joints: []}\n    mooring: {lines: []}\n",
        1,
    );
    let clamped = ReadOptions {
        clamped: true,
        ..ReadOptions::default()
    };
    let missing = read_with(&text, &clamped)
        .expect("a tower")
        .description
        .missing_parts;
    let holds = [MissingPart::Platform, MissingPart::MooringLines];
    // Its drivetrain is all that has a mass at the top.
    let above = [MissingPart::Hub, MissingPart::Blades];
    assert_eq!(missing, [holds, above].concat());
    assert_eq!(read(VERSION_2).description.missing_parts, above);
}

#[test]
fn a_shear_modulus_that_contradicts_is_noted_with_the_one_that_is_taken() {
    // E / (2 (1 + nu)) is 8e10 Pa.
    let (text, line) = with(VERSION_1, "G: 8.e+010", "G: 7.e+010");
    let found = notes(
        &text,
        "G of material `steel` is 7e10 Pa, but E and nu = 0.25 give 8.0000e10 Pa: G is used",
    );
    assert_eq!(found[0].0, line);
    assert_eq!(read(&text).description.materials[0].shear_modulus_pa, 7e10);
    assert!(notes(VERSION_1, "G is used").is_empty());
}

#[test]
fn public_files_have_no_lookalikes() {
    let Some(folder) = std::env::var_os("TOWERMODES_PEER_DATA") else {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
        return;
    };
    let folder = std::path::PathBuf::from(folder);
    for name in [
        "windio/v1/IEA-15-240-RWT.yaml",
        "windio/v2/IEA-15-240-RWT.yaml",
        "openfast/iea10/IEA-10-198-RWT.yaml",
        "openfast/iea15_monopile/IEA-15-240-RWT.yaml",
        "openfast/nrel5mw_land/nrel5mw.yaml",
        "openfast/nrel5mw_land/nrel5mw_tower.yaml",
        "openfast/nrel5mw_oc3hywind/nrel5mw-spar_oc3.yaml",
        "openfast/nrel5mw_oc3monopile/nrel5mw_monopile.yaml",
    ] {
        let source = Source::from_path(&folder.join(name)).expect("the file is there");
        let Ok(input) = read_windio(source, &ReadOptions::default()) else {
            // Some are decks of other programs.
            continue;
        };
        for note in &input.notes {
            for words in ["is not read", "degrees", "lengths are in metres"] {
                assert!(!note.message.contains(words), "{name}: {note}");
            }
        }
    }
}

/// Masses that WISDEM takes in place of its own, where they are not read.
#[test]
fn masses_of_the_user_that_are_not_read_are_noted_at_their_line() {
    let at = "    tower:\n";
    let (text, line) = with(
        VERSION_2,
        at,
        "    tower:\n        tower_mass_user: 250000.0\n",
    );
    let found = notes(&text, "tower_mass_user");
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].0, line + 1);
    found[0].1.says("tower_mass_user = 250000 kg is not used");
    let none = text.replace("250000.0", "0.0");
    assert!(notes(&none, "tower_mass_user").is_empty());
}

#[test]
fn masses_of_components_are_noted_where_the_whole_has_none() {
    let words = "masses of single components";
    let hub = "    hub: {diameter: 3, hub_shell_mass_user: 2700.0, spinner_mass_user: 500.0}\n";
    let at = "    drivetrain:\n";
    let (text, line) = with(
        VERSION_2,
        at,
        &format!("{hub}{at}        bedplate: {{mass_user: 9.0}}\n"),
    );
    let found = notes(&text, words);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].0, line);
    found[0]
        .1
        .says("hub.hub_shell_mass_user, hub.spinner_mass_user (together 3200 kg)");
    assert!(notes(VERSION_2, words).is_empty());
}
