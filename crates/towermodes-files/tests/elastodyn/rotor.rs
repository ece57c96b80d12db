//! The rotor of a deck, and the blade that turns with it.

use std::f64::consts::TAU;

use towermodes::{Blade, BladeDescription, BladeFamily, RigidBody, Solver};
use towermodes_files::elastodyn::{ElastoDynDeck, read_elastodyn, read_main_file};
use towermodes_files::{InMemory, ReadError, ReadOptions};
use towermodes_testing::{Says, rows, with};

use crate::elastodyn::texts::{BLADE, TOWER, close, deck, files, main_text, source};

/// The notes on the blade.
fn notes_on_blade(deck: &ElastoDynDeck) -> Vec<String> {
    let notes = deck.input.rotor_notes.others.iter();
    notes.map(ToString::to_string).collect()
}

fn notes(deck: &ElastoDynDeck) -> Vec<String> {
    let notes = deck.input.rotor_notes.iter();
    notes.map(ToString::to_string).collect()
}

/// A deck whose blade file is another.
fn with_blade(blade: &str) -> Result<ElastoDynDeck, ReadError> {
    let companions = InMemory {
        files: [("tower.dat", TOWER), ("parts\\blade.dat", blade)]
            .map(|(name, text)| (name.to_owned(), text.to_owned()))
            .into(),
    };
    let main = source("main.dat", main_text(5, &[]));
    read_elastodyn(main, &companions, &ReadOptions::default())
}

fn blade_of(text: &str) -> BladeDescription {
    let deck = with_blade(text).unwrap_or_else(|error| panic!("{error}"));
    deck.input.blade.expect("a blade")
}

/// The speed at which a simulation begins is no range of operation.
#[test]
fn the_speed_at_the_start_is_no_operating_speed() {
    for rpm in ["17.5", "0"] {
        let deck = deck(&[("RotSpeed", rpm)]);
        assert_eq!(deck.input.description.rotor, None);
        let said = notes(&deck);
        assert_eq!(said.len(), 1, "{said:?}");
        let start = format!("RotSpeed = {rpm} rpm is the initial speed of the simulation");
        assert!(said[0].contains(&start), "{said:?}");
        // It matters for what it excites, and for nothing else.
        let others = deck.input.notes.iter().map(ToString::to_string);
        assert!(others.into_iter().all(|note| !note.contains("RotSpeed")));
    }
}

#[test]
fn blades_are_known_without_speeds() {
    let still = deck(&[]);
    assert_eq!(still.input.description.rotor, None);
    // How many blades it has is known for all that.
    assert_eq!(still.input.blades, Some(3));
    let two = deck(&[("NumBl", "2"), ("HubIner_Teeter", "600")]);
    assert_eq!(two.input.description.rotor, None);
    assert_eq!(two.input.blades, Some(2));
}

/// Twist and pitch of the deck are positive towards feather, those of the library the other way.
#[test]
fn the_first_blade_bends_only() {
    let changes = [
        ("BlPitch(1)", "5"),
        ("BlPitch(2)", "5"),
        ("BlPitch(3)", "5"),
        ("TipMass(1)", "3"),
        ("TipMass(2)", "3"),
        ("TipMass(3)", "3"),
    ];
    let deck = deck(&changes);
    let said = notes_on_blade(&deck);
    assert_eq!(said.len(), 1, "{said:?}");
    said[0].says("BlPitch(1) = 5 degrees, the initial pitch");
    let blade = deck.input.blade.expect("a blade");
    assert_eq!((blade.hub_radius_m, blade.tip_radius_m), (1.0, 11.0));
    assert_eq!(blade.tip, RigidBody::point(3.0, [0.0; 3]));
    assert_eq!((blade.tip_is_pulled, blade.borders.len()), (true, 51));
    close(blade.pitch_rad, -5.0 * TAU / 360.0, 1e-15);
    let [root, tip] = &blade.sections[..] else {
        panic!("{:?}", blade.sections);
    };
    close(root.twist_rad, -13.0 * TAU / 360.0, 1e-15);
    assert_eq!((root.span, tip.span, tip.twist_rad), (0.0, 1.0, 0.0));
    for section in [root, tip] {
        // Twice 50 kg/m.
        assert_eq!(section.mass_kg_per_m, 100.0);
        assert_eq!((section.flap_n_m2, section.edge_n_m2), (1e9, 1e9));
        let rigid = (section.torsion_n_m2, section.axial_n);
        assert_eq!(rigid, (f64::INFINITY, f64::INFINITY));
    }
}

/// A cantilever of 10 m with 4e9 and 9e9 N m² and 100 kg/m: ω = 1.8751041² √(EI/m)/L², in flap
/// 222.3723 and in lag 333.5585 rad/s.
#[test]
fn factors_of_stiffness_count() {
    let straight = BLADE.replace("0 0.25 13", "0 0.25 0");
    let stiffer = straight
        .replace("1 AdjFlSt", "4 AdjFlSt")
        .replace("1 AdjEdSt", "9 AdjEdSt");
    let blade = Blade::new(blade_of(&stiffer)).expect("a blade");
    let solution = Solver::default().blade(&blade, 2, &[]).expect("modes");
    let modes = solution.modes.iter();
    let found: Vec<_> = modes.map(|m| (m.family, TAU * m.frequency_hz)).collect();
    let expected = [
        (BladeFamily::Flap, 222.372_331),
        (BladeFamily::Lag, 333.558_496),
    ];
    for ((family, found), (expected_family, expected)) in found.into_iter().zip(expected) {
        assert_eq!(family, expected_family);
        close(found, expected, 1e-4);
    }
}

#[test]
fn a_fine_table_has_as_many_elements() {
    let rows: String = (0..=80)
        .map(|k| format!(" {} 0.25 0 50 1e9 1e9\n", f64::from(k) / 80.0))
        .collect();
    let head = BLADE.split(" 0 0.25 13").next().expect("before the table");
    let fine = head.replace(" 2 NBlInpSt", " 81 NBlInpSt") + &rows;
    assert_eq!(blade_of(&fine).borders.len(), 81);
}

#[test]
fn what_is_left_out_of_the_blade_is_said() {
    let said = notes_on_blade(&deck(&[
        ("PreCone(1)", "-2.5"),
        ("TipMass(2)", "3"),
        ("BlPitch(3)", "90"),
    ]));
    assert_eq!(said.len(), 3, "{said:?}");
    said[0].says("PreCone(1) = -2.5 degrees is ignored");
    said[1].says("blade 2 has another file, tip mass or pitch");
    said[2].says("blade 3 has another file, tip mass or pitch");
}

#[test]
fn without_the_machine_there_is_no_blade() {
    let options = with!(ReadOptions, without_rna = true);
    let text = main_text(5, &[("RotSpeed", "17.5"), ("PreCone(1)", "2")]);
    let main = source("main.dat", text);
    let deck = read_elastodyn(main, &files(TOWER), &options).expect("a deck");
    assert_eq!(deck.input.blade, None);
    assert_eq!(notes(&deck).len(), 1);
}

#[test]
fn speeds_and_pitches_that_cannot_be_are_refused() {
    for (key, value) in [
        ("RotSpeed", "-1"),
        ("RotSpeed", "fast"),
        ("BlPitch(1)", "181"),
        ("BlPitch(3)", "-181"),
    ] {
        let text = main_text(5, &[(key, value)]);
        let mistake = read_main_file(&source("main.dat", text)).expect_err("a mistake");
        mistake.message().says(key);
    }
    // Two blades have no third.
    let two = main_text(
        5,
        &[
            ("NumBl", "2"),
            ("HubIner_Teeter", "600"),
            ("BlPitch(3)", "999"),
        ],
    );
    let main = read_main_file(&source("main.dat", two));
    assert_eq!(main.map(|main| main.blade_count), Ok(2));
}

#[test]
fn blades_without_stiffness_are_refused() {
    let table = r#"
        50 1e9 1e9\n 1␣ | 50 0 1e9\n 1␣ | FlpStff of row 1 is 0
        50 1e9 1e9\n 1␣ | 50 1e9 -1\n 1␣ | EdgStff of row 1 is -1
        50 1e9 1e9\n 1␣ | 50 1e9\n 1␣ | EdgStff
        1 AdjFlSt | 0 AdjFlSt | AdjFlSt
        1 AdjEdSt | -1 AdjEdSt | AdjEdSt
        0.25 13 50 | 0.25 x 50 | StrcTwst
        "#;
    for [from, to, message] in rows(table) {
        BLADE.says(from);
        let error = with_blade(&BLADE.replace(from, to)).expect_err("a mistake");
        error.says(message);
    }
}
