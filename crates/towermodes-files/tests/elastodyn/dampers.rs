//! Structural controls of ServoDyn: their masses on nacelle, tower and platform.

use std::f64::consts::TAU;

use towermodes::{Foundation, RigidBody};
use towermodes_files::elastodyn::{ElastoDynDeck, read_elastodyn};
use towermodes_files::{Note, ReadOptions};
use towermodes_testing::Says;

use crate::elastodyn::texts::{TOWER, files, main_text, source};
use crate::hydrodyn::texts::{Layout, deck as hydrodyn};

const SERVO: &str = "------ SERVODYN\nx\n0 NumBStC - n\n\"unused\" BStCfiles\n1 NumNStC - n\n\
    \"n.dat\" NStCfiles\n2 NumTStC - n\n\"t.dat\" \"t2.dat\" TStCfiles\n1 NumSStC - n\n\"p.dat\" SStCfiles\n";

/// A file of OpenFAST 3 with a mass for each direction; y is switched off.
fn damper(mode: u8, position: [f64; 3]) -> String {
    let [x, y, z] = position;
    format!(
        "---- STRUCTURAL CONTROL\na damper\n{mode} StC_DOF_MODE - DOF mode {{0: no; 1: three}}\nTrue StC_X_DOF - x\n\
         False StC_Y_DOF - y\nTrue StC_Z_DOF - z\n{x} StC_P_X - m\n{y} StC_P_Y - m\n{z} StC_P_Z - m\n\
         400 StC_X_M - kg\n999 StC_Y_M - kg\n100 StC_Z_M - kg\n700 StC_XY_M - kg\n\
         1600 StC_X_K - N/m\n0 StC_Y_K - N/m\n400 StC_Z_K - N/m\n"
    )
}

/// The small turbine, floating on a tube, with these files of structural controls.
fn read(servo: &str, controls: &[(&str, String)], is_on: bool) -> ElastoDynDeck {
    let fst = format!(
        "OpenFAST\nx\n{} CompServo\n1 CompHydro\n0 CompMooring\n\"main.dat\" EDFile\n\"s/s.dat\" ServoFile\n\
         \"wet.dat\" HydroFile\n",
        u8::from(is_on)
    );
    let mut companions = files(TOWER);
    let main = main_text(
        5,
        &[
            ("TowerBsHt", "10"),
            ("PtfmHvDOF", "True"),
            ("PtfmMass", "5000"),
            ("PtfmCMzt", "-5"),
            ("PtfmRefzt", "2"),
        ],
    );
    let all = [
        ("main.dat", main),
        ("s/s.dat", servo.to_owned()),
        ("wet.dat", hydrodyn(Layout::V26, &[("NFillGroups", "")])),
    ];
    for (name, text) in all {
        companions.files.insert(name.into(), text);
    }
    for (name, text) in controls {
        companions.files.insert(format!("s/{name}"), text.clone());
    }
    let deck = read_elastodyn(source("a.fst", fst), &companions, &ReadOptions::default());
    deck.unwrap_or_else(|error| panic!("{error}"))
}

/// What is said of structural controls.
fn said(deck: &ElastoDynDeck) -> Vec<Note> {
    let notes = deck.input.notes.iter();
    let is_it = |note: &&Note| {
        let words = ["structural control", "damper of"];
        words.iter().any(|words| note.message.contains(words))
    };
    notes.filter(is_it).cloned().collect()
}

#[test]
fn locked_dampers_are_masses_on_their_part() {
    let controls = [
        ("n.dat", damper(1, [2.0, 0.0, 1.0])),
        ("t.dat", damper(2, [0.0, 0.0, 12.0])),
        ("t2.dat", damper(2, [0.0, 0.0, 31.0])),
        ("p.dat", damper(1, [6.0, 0.0, -8.0])),
    ];
    let with = read(SERVO, &controls, true);
    let without = read(SERVO, &controls, false);
    assert!(said(&without).is_empty());
    // Masses along x and z, from the tower top.
    let expected = RigidBody::combined(&[without.rna, RigidBody::point(500.0, [2.0, 0.0, 1.0])]);
    assert_eq!(with.rna, expected);
    let nacelle = |deck: &ElastoDynDeck| deck.input.turbine.as_ref().expect("a turbine").nacelle;
    assert_eq!(nacelle(&with).mass_kg, nacelle(&without).mass_kg + 500.0);
    // 12 m above the tower base at 10 m; the tower ends 30 m above it.
    let masses = &with.input.description.point_masses;
    assert_eq!(masses.len(), 1);
    assert_eq!((masses[0].height_m, masses[0].mass_kg), (22.0, 700.0));
    // The reference point of the platform is at 2 m.
    let body = |deck: &ElastoDynDeck| match &deck.input.description.foundation {
        Foundation::Floating(platform) => RigidBody {
            mass_kg: platform.mass_kg,
            center_m: platform.center_m,
            inertia_kg_m2: platform.inertia_kg_m2,
        },
        other => panic!("{other:?}"),
    };
    let damper = RigidBody::point(500.0, [6.0, 0.0, -6.0]);
    let expected = RigidBody::combined(&[body(&without), damper]);
    let found = body(&with);
    let values = |body: &RigidBody| {
        let tensor = body.inertia_kg_m2.tensor();
        let all = body
            .center_m
            .into_iter()
            .chain(tensor.into_iter().flatten());
        [body.mass_kg].into_iter().chain(all).collect::<Vec<f64>>()
    };
    for (found, expected) in values(&found).into_iter().zip(values(&expected)) {
        assert!((found - expected).abs() <= 1e-12 * expected.abs().max(1.0));
    }
}

#[test]
fn each_damper_has_a_note_with_its_own_frequency() {
    let controls = [
        ("n.dat", damper(1, [2.0, 0.0, 1.0])),
        ("t.dat", damper(2, [0.0, 0.5, 12.0])),
        ("t2.dat", damper(2, [0.0, 0.0, 31.0])),
        (
            "p.dat",
            damper(1, [6.0, 0.0, -8.0]).replace("400 StC_X_M", "-4 StC_X_M"),
        ),
    ];
    let notes = said(&read(SERVO, &controls, true));
    let texts: Vec<String> = notes.iter().map(ToString::to_string).collect();
    assert_eq!(texts.len(), 4, "{texts:?}");
    // √(1600/400)/2π = √(400/100)/2π.
    let own = format!("{:.5} Hz along x", 2.0 / TAU);
    texts[0].says_all(&format!(
        "n.dat:3: the damper of the nacelle is locked: its mass of 500 kg & (2, 0, 1) m from the tower top & {own}, {:.5} Hz along z",
        2.0 / TAU
    ));
    texts[1].says_all("t.dat:3: & 700 kg & on the axis of the tower & Hz along x;");
    texts[2].says_all("t2.dat:3: & left out & StC_P_Z is 31 m & from 0 to 30 m");
    texts[3].says_all("s.dat:10: & p.dat is left out, with the mass: & StC_X_M");
    let warnings: Vec<bool> = notes.iter().map(Note::is_warning).collect();
    assert_eq!(warnings[2..], [true, true]);
}

#[test]
fn what_has_no_mass_on_springs_is_left_out() {
    let kinds = [
        (0, "is off"),
        (3, "a liquid column"),
        (4, "a force"),
        (5, "a force"),
    ];
    for (mode, words) in kinds {
        let controls = [("n.dat", damper(mode, [0.0; 3]))];
        let deck = read(SERVO, &controls, true);
        assert_eq!(deck.rna, read(SERVO, &controls, false).rna);
        said(&deck)[0]
            .to_string()
            .says_all(&format!("n.dat:3: & {words}"));
    }
    // Since OpenFAST 4.2 kind 3 is one mass for all directions.
    let newer = damper(3, [0.0; 3]).replace("StC_XY_M", "StC_Omni_M");
    let deck = read(SERVO, &[("n.dat", newer)], true);
    said(&deck)[0]
        .to_string()
        .says_all("its mass of 700 kg & Hz along z");
}

#[test]
fn missing_files_and_blades_are_warned_of() {
    let servo = SERVO.replace("0 NumBStC", "2 NumBStC");
    let notes = said(&read(&servo, &[], true));
    let texts: Vec<String> = notes.iter().map(ToString::to_string).collect();
    assert_eq!(texts.len(), 5, "{texts:?}");
    assert!(notes.iter().all(Note::is_warning));
    texts[0].begins(
        "s/s.dat:3: the 2 structural controls of the blades (NumBStC) are left out, with the mass",
    );
    texts[3].says_all("s.dat:8: & the tower in t2.dat is left out & cannot be read");
    // FAST 8 has no files of this kind.
    let old = said(&read(
        "SERVODYN\nx\nTrue CompNTMD - x\n\"n.dat\" NTMDfile\n",
        &[],
        true,
    ));
    old[0]
        .to_string()
        .says_all("structural control of the nacelle (CompNTMD) is left out");
}
