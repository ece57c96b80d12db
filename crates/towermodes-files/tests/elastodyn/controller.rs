//! Operating speeds from the controller beside a model, and parts of the model that are not read.

use std::f64::consts::TAU;

use towermodes::{MissingPart, Place};
use towermodes_files::elastodyn::{ElastoDynDeck, read_elastodyn, read_main_file};
use towermodes_files::{InMemory, NoteKind, ReadOptions, tower_from_toml, write_toml};
use towermodes_testing::{Says, rows};

use crate::elastodyn::texts::{BLADE, TOWER, main_text, source};

const SERVO: &str =
    "------- SERVODYN\nx\n5 VSContrl - (switch)\n\"sub/DISCON.IN\" DLL_InFile - (-)\n";
/// 36.0 and 122.9 rad/s of the generator at a ratio of 97.
const ROSCO: &str = "! Controller\n0.1  ! F_LPFCornerFreq\t- x\n1 2 3 ! PC_GS_angles - x\n122.9000  ! PC_RefSpd\t- Desired speed, [rad/s].\n36.0 !VS_MinOMSpd - Minimum\n97.0 ! WE_GearboxRatio - ratio\n";

/// A deck of a gearbox of 97 with an `.fst` file of these lines, a file of ServoDyn in a folder,
/// and the input of a controller in a folder below.
fn with(lines: &str, servo: &str, controller: Option<&str>) -> ElastoDynDeck {
    let fst = format!("OpenFAST INPUT FILE\nx\n\"main.dat\" EDFile - file\n{lines}");
    let main = main_text(5, &[("GBRatio", "97")]);
    let mut files = vec![
        ("main.dat", main),
        ("tower.dat", TOWER.into()),
        ("parts\\blade.dat", BLADE.into()),
        ("servo/servo.dat", servo.into()),
    ];
    files.extend(controller.map(|text| ("servo/sub/DISCON.IN", text.to_owned())));
    let files = files
        .into_iter()
        .map(|(name, text)| (name.to_owned(), text));
    let files = InMemory {
        files: files.collect(),
    };
    read_elastodyn(source("a.fst", fst), &files, &ReadOptions::default()).expect("a deck")
}

const NAMED: &str = "1 CompServo\n\"servo/servo.dat\" ServoFile\n";

fn speeds(deck: &ElastoDynDeck) -> Option<[f64; 2]> {
    let rotor = deck.input.description.rotor?;
    Some([rotor.lowest_rpm, rotor.highest_rpm])
}

fn said(deck: &ElastoDynDeck) -> Vec<String> {
    let notes = deck.input.rotor_notes.speeds.iter();
    notes.map(ToString::to_string).collect()
}

#[test]
fn the_controller_has_the_operating_speeds() {
    let deck = with(NAMED, SERVO, Some(ROSCO));
    let [lowest, highest] = speeds(&deck).expect("speeds");
    // 36/97 rad/s = 3.5441 rpm and 122.9/97 rad/s = 12.09905 rpm.
    assert!((lowest / (36.0 / 97.0 * 60.0 / TAU) - 1.0).abs() < 1e-14);
    assert!((highest - 12.09905).abs() < 1e-4, "{highest}");
    let notes = said(&deck);
    assert_eq!(notes.len(), 1, "{notes:?}");
    notes[0].begins("servo/sub/DISCON.IN:4: operating speeds 3.544 to 12.099 rpm");
    assert!(deck.input.files().any(|file| file.ends_with("DISCON.IN")));
    let place = deck.input.line_of(Place::Rotor { key: "rpm" });
    assert_eq!(place, Some(("servo/sub/DISCON.IN", 4)));
}

/// The rotor of the simulation turns by GBRatio, whatever the controller believes.
#[test]
fn a_gearbox_ratio_of_its_own_is_remarked() {
    let direct = ROSCO.replace("97.0 ! WE_G", "1.0 ! WE_G");
    let deck = with(NAMED, SERVO, Some(&direct));
    assert!((speeds(&deck).expect("speeds")[1] - 12.09905).abs() < 1e-4);
    let notes = said(&deck);
    notes[1].begins("servo/sub/DISCON.IN:6: WE_GearboxRatio is 1.0, but GBRatio");
    // An older file has none.
    let none = ROSCO.replace("WE_GearboxRatio", "WE_Jtot");
    let deck = with(NAMED, SERVO, Some(&none));
    assert!((speeds(&deck).expect("speeds")[1] - 12.09905).abs() < 1e-4);
    assert_eq!(said(&deck).len(), 1);
}

#[test]
fn without_a_controller_the_speeds_are_unknown_for_a_reason() {
    let table = r#"
         | SERVO |  |  | no ServoFile
        0 CompServo\n | SERVO |  | a.fst:4:␣ | CompServo is 0
        1 CompServo\n"x.dat" ServoFile\n | SERVO |  | a.fst:5:␣ | x.dat: no such file
        NAMED | x\n |  |  | has no VSContrl
        NAMED | x\n1 VSContrl\n |  | servo/servo.dat:2:␣ | VSContrl is 1
        NAMED | x\n5 VSContrl\n |  |  | has no DLL_InFile
        NAMED | SERVO |  | servo/servo.dat:4:␣ | DISCON.IN: no such file
        NAMED | SERVO | ROSCO -> another controller\n |  | has no VS_MinOMSpd, so it is not an input file of ROSCO
        NAMED | SERVO | PC_RefSpd -> OTHER |  | has no PC_RefSpd
        NAMED | SERVO | 36.0 ! -> 0.0 ! | servo/sub/DISCON.IN:5:␣ | VS_MinOMSpd is 0.0, not a number above 0
        NAMED | SERVO | 122.9000 -> fast | servo/sub/DISCON.IN:4:␣ | PC_RefSpd is fast
        NAMED | SERVO | 36.0 ! -> 136.0 ! | servo/sub/DISCON.IN:5:␣ | VS_MinOMSpd = 136 rad/s is above
    "#;
    for [lines, servo, change, at, reason] in rows(table) {
        let (lines, servo) = (lines.replace("NAMED", NAMED), servo.replace("SERVO", SERVO));
        let change = change.split_once(" -> ");
        let controller = change.map(|(from, to)| match from {
            "ROSCO" => to.to_owned(),
            _ => ROSCO.replace(from, to),
        });
        let deck = with(&lines, &servo, controller.as_deref());
        assert_eq!(speeds(&deck), None, "{reason}");
        let notes = said(&deck);
        notes[0].begins(at);
        notes[0].says(reason);
        notes[0].says("unknown");
        assert_eq!(deck.input.blades, Some(3));
    }
}

fn missing(lines: &str) -> Vec<MissingPart> {
    with(lines, SERVO, None).input.description.missing_parts
}

#[test]
fn modules_that_are_not_read_are_missing_parts() {
    use MissingPart::{MooringLines, Soil, Substructure, Water};
    for (lines, parts) in [
        ("", vec![]),
        ("0 CompHydro\n0 CompSub\n0 CompMooring\n", vec![]),
        ("1 CompSub\n", vec![Substructure]),
        ("1 CompHydro\n1 CompSeaSt\n", vec![Water]),
        ("1 CompSeaSt\n", vec![Water]),
        ("3 CompMooring\n", vec![MooringLines]),
        ("True CompMAP\n", vec![MooringLines]),
        ("1 CompSoil\n1 CompSub\n", vec![Substructure, Soil]),
    ] {
        assert_eq!(missing(lines), parts, "{lines}");
    }
}

/// A platform that moves is a missing part of its own, unless a substructure moves it.
#[test]
fn a_platform_that_moves_is_missing() {
    let moving = |lines: &str| {
        let fst = format!("OpenFAST INPUT FILE\nx\n\"main.dat\" EDFile - file\n{lines}");
        let main = main_text(5, &[("PtfmPDOF", "True")]);
        let files = [
            ("main.dat", main.as_str()),
            ("tower.dat", TOWER),
            ("parts\\blade.dat", BLADE),
        ];
        let files = files.map(|(name, text)| (name.to_owned(), text.to_owned()));
        let files = InMemory {
            files: files.into(),
        };
        let deck = read_elastodyn(source("a.fst", fst), &files, &ReadOptions::default());
        deck.expect("a deck").input.description.missing_parts
    };
    assert_eq!(moving(""), [MissingPart::Platform]);
    assert_eq!(moving("1 CompSub\n"), [MissingPart::Substructure]);
}

/// With BeamDyn, ElastoDyn reads no blade files: they need not be there, and the blades are a
/// missing part.
#[test]
fn blades_of_beamdyn_need_no_blade_file() {
    let read = |switch: &str| {
        let fst =
            format!("OpenFAST INPUT FILE\nx\n\"main.dat\" EDFile - file\n{switch} CompElast\n");
        let main = main_text(5, &[]);
        let files = [("main.dat", main.as_str()), ("tower.dat", TOWER)];
        let files = files.map(|(name, text)| (name.to_owned(), text.to_owned()));
        let files = InMemory {
            files: files.into(),
        };
        read_elastodyn(source("a.fst", fst), &files, &ReadOptions::default())
    };
    let deck = read("2").expect("a deck");
    let input = deck.input;
    assert_eq!(input.description.missing_parts, [MissingPart::Blades]);
    assert!(input.blade.is_none() && input.turbine.is_none());
    let reason = input.turbine_missing.clone().expect("a reason").to_string();
    reason.says("the blades are defined in BeamDyn");
    let tower = input.tower().expect("a tower");
    let missing = tower.missing_parts().expect("blades").to_string();
    assert_eq!(missing, "the mass of the blades is not in this model");
    assert!(read("1").is_err());
}

/// OpenFAST reads by position: neighbours with each other's names and equal values are the same.
#[test]
fn neighbours_may_have_each_others_names() {
    let text = main_text(5, &[("PtfmPDOF", "True"), ("PtfmYDOF", "True")]);
    let exchanged = |text: &str| {
        let text = text
            .replace("PtfmPDOF", "@")
            .replace("PtfmYDOF", "PtfmPDOF");
        text.replace('@', "PtfmYDOF")
    };
    let main = read_main_file(&source("main.dat", exchanged(&text))).expect("a main file");
    assert!(main.platform_dofs[4] && main.platform_dofs[5]);
    // Which is which would matter here.
    let text = main_text(5, &[("PtfmPDOF", "True"), ("PtfmYDOF", "False")]);
    let mistake = read_main_file(&source("main.dat", exchanged(&text))).expect_err("a mistake");
    mistake.message().says("PtfmYDOF");
}

/// The warning is in a TOML file that the model is converted to, and in what is read from it.
#[test]
fn missing_parts_survive_a_tower_file() {
    let deck = with("1 CompSub\n1 CompHydro\n", SERVO, None);
    let (text, _) = write_toml(&deck.input.description);
    text.says("# WARNING: ");
    text.says("missing_parts = [\"substructure\", \"water\"]");
    let tower = tower_from_toml(&text).expect("a tower");
    let said: Vec<String> = tower.warnings().iter().map(ToString::to_string).collect();
    assert!(said[0].starts_with(
        "clamped at the tower base; the file has a substructure and water, which are not in this model"
    ));
    let parts = &tower.missing_parts().expect("missing parts").parts;
    assert_eq!(*parts, [MissingPart::Substructure, MissingPart::Water]);
    let wrong = text.replace("\"water\"", "\"watr\"");
    let mistakes = tower_from_toml(&wrong).expect_err("no such part");
    mistakes[0].message().says("watr");
}

/// The note on the rotor of the rigid body names the factor only where there is one.
#[test]
fn the_note_on_the_locked_rotor_is_true() {
    let note = |ratio: &str| {
        let main = main_text(5, &[("GBRatio", ratio)]);
        let files = crate::elastodyn::texts::files(TOWER);
        let deck = read_elastodyn(source("main.dat", main), &files, &ReadOptions::default());
        let notes = deck.expect("a deck").input.notes;
        let mut notes = notes
            .into_iter()
            .filter(|note| note.kind == NoteKind::RigidRotor);
        notes.next().expect("a note").message
    };
    note("97").says("GenIner counts once, without the factor GBRatio^2");
    for same in ["1", "-1"] {
        assert!(!note(same).contains("GBRatio"), "{}", note(same));
    }
}
