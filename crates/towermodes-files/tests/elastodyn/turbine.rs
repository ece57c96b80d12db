//! The turning turbine of a deck: its numbers, what is assumed, and why there is none.

use towermodes::Inertia;
use towermodes::turbine::TurbineModel;
use towermodes_files::elastodyn::{ElastoDynDeck, read_elastodyn};
use towermodes_files::{NoteKind, ReadOptions, RotorLock, Setting};
use towermodes_testing::{Says, rows, with, words};

use crate::elastodyn::texts::{BLADE, TOWER, close, deck, files, main_text, source};

/// The reason why there is no turbine, with its place.
fn missing(deck: &ElastoDynDeck) -> String {
    assert!(deck.input.turbine.is_none());
    assert!(deck.input.whole_turbine().expect("no mistake").is_none());
    let reason = deck.input.turbine_missing.as_ref().expect("a reason");
    assert_eq!(reason.kind, NoteKind::MissingPart);
    reason.to_string()
}

fn notes(deck: &ElastoDynDeck) -> Vec<String> {
    assert_eq!(deck.input.turbine_missing, None);
    let notes = deck.input.turbine_notes.iter();
    notes.map(|note| note.message.clone()).collect()
}

#[test]
fn a_deck_has_the_numbers_of_its_turbine() {
    let deck = deck(&[
        ("ShftTilt", "-5"),
        ("PreCone(1)", "-3"),
        ("PreCone(2)", "-3"),
        ("PreCone(3)", "-3"),
        ("BlPitch(1)", "10"),
        ("BlPitch(2)", "10"),
        ("BlPitch(3)", "10"),
        ("TipMass(1)", "7"),
        ("TipMass(2)", "7"),
        ("TipMass(3)", "7"),
        ("DrTrDOF", "True"),
        ("DTTorSpr", "5e7"),
        ("GenDOF", "True"),
    ]);
    let turbine = deck.input.turbine.as_ref().expect("a turbine");
    assert_eq!(turbine.nacelle.mass_kg, 2000.0);
    assert_eq!(turbine.nacelle.center_m, [1.0, 0.5, 1.0]);
    // 4000 − 2000 (1² + 0.5²).
    let own = with!(Inertia, zz = 1500.0);
    assert_eq!(turbine.nacelle.inertia_kg_m2, own);
    assert_eq!(turbine.yaw_bearing_mass_kg, 300.0);
    assert_eq!(turbine.yaw_n_m_per_rad, f64::INFINITY);
    assert_eq!((turbine.overhang_m, turbine.tower_to_shaft_m), (-4.0, 2.0));
    close(turbine.tilt_rad.to_degrees(), -5.0, 1e-12);
    close(turbine.cone_rad.to_degrees(), -3.0, 1e-12);
    let hub = turbine.hub;
    assert_eq!((hub.mass_kg, hub.center_m), (500.0, 1.0));
    assert_eq!(hub.polar_inertia_kg_m2, 70.0);
    assert_eq!(hub.transverse_inertia_kg_m2, 0.0);
    assert_eq!(turbine.shaft_n_m_per_rad, 5e7);
    let generator = turbine.generator;
    assert_eq!((generator.inertia_kg_m2, generator.gear_ratio), (2.0, 3.0));
    assert!(!generator.is_locked);
    let blade = &turbine.blade;
    assert_eq!((blade.hub_radius_m, blade.tip_radius_m), (1.0, 11.0));
    // AdjBlMs is 2; the twist is positive to feather, as in the file.
    assert_eq!(blade.sections[0].mass_kg_per_m, 100.0);
    close(blade.sections[0].twist_rad.to_degrees(), 13.0, 1e-12);
    close(blade.pitch_rad.to_degrees(), 10.0, 1e-12);
    assert_eq!((blade.tip.mass_kg, blade.tip_is_pulled), (7.0, true));
    assert_eq!(blade.borders.len(), 11);
    assert_eq!(blade.sections[1].torsion_n_m2, f64::INFINITY);
    assert_eq!(blade.sections[1].axial_n, f64::INFINITY);
    let turbine = deck
        .input
        .whole_turbine()
        .expect("a turbine")
        .expect("a turbine");
    let mut model = TurbineModel::new(&turbine, &Default::default()).expect("a mesh");
    assert!(model.frequencies(5.0, 9.5).expect("a spectrum").is_complete);
}

#[test]
fn what_is_assumed_of_the_turbine_is_said() {
    let said = notes(&deck(&[
        ("DTTorSpr", "5e7"),
        ("YawDOF", "True"),
        ("EdgeDOF", "True"),
    ]));
    assert_eq!(
        said,
        [
            "GenDOF is False: the generator of the operating turbine has a constant speed",
            "DrTrDOF is False: the shaft is rigid, and DTTorSpr = 5e7 N m/rad is left out",
            "YawDOF is True, but the spring YawSpr of the yaw drive is in the file of ServoDyn: the nacelle does not yaw on the tower; give the .fst file, which names that file",
            "FlapDOF1 is False, but here all bending modes of the blades are included",
        ]
    );
    let moving = [
        ("FlapDOF1", "True"),
        ("FlapDOF2", "True"),
        ("EdgeDOF", "True"),
    ];
    let said = notes(&deck(
        &[&moving[..], &[("GenDOF", "True"), ("PitchDOF", "True")]].concat(),
    ));
    assert_eq!(
        said,
        [
            "GenDOF is True: the generator of the operating turbine rotates freely",
            "PitchDOF is True, but the blades do not rotate on their pitch bearings here",
        ]
    );
}

#[test]
fn a_rotor_that_the_user_frees_has_a_free_generator() {
    let main = source("main.dat", main_text(5, &[]));
    let options = with!(ReadOptions, rotor = RotorLock::Free);
    let deck = read_elastodyn(main, &files(TOWER), &options).expect("a deck");
    let turbine = deck.input.turbine.as_ref().expect("a turbine");
    assert!(!turbine.generator.is_locked);
    notes(&deck)[0].says("as requested by --rotor free");
}

#[test]
fn a_model_that_makes_no_turbine_says_why() {
    let table = r#"
        NumBl 2 & HubIner_Teeter 600 | main.dat:45: a rotor of 2 blades is not supported: seen from the tower, its inertia and stiffness vary periodically, which would need Floquet theory; the number of blades must be 3 or more
        NumBl 2 & HubIner_Teeter 600 & TeetDOF True | the number of blades must be 3 or more; teeter (TeetDOF) is not supported either
        Furling True | Furling is True: a furling rotor and tail (FurlFile) are not supported; for the frequencies of the turbine Furling must be False
        PreCone(3) -2.5 | main.dat:50: PreCone(3) is -2.5 degrees and PreCone(1) is 0 degrees: different blades are not supported; both must be equal
        BlPitch(2) 90 | BlPitch(2) is 90 degrees and BlPitch(1) is 0 degrees
        TipMass(2) 90 | TipMass(2) is 90 kg and TipMass(1) is 0 kg
        DrTrDOF True & GenDOF True | DTTorSpr is 0 N m/rad although DrTrDOF is True: nothing holds rotor and generator together; DTTorSpr must be greater than 0, or DrTrDOF False for a rigid shaft
        GBRatio -3 | the gear ratio is -3; it must be positive
        GenDOF True & GenIner 0 | the inertia of a free generator is 0; it must be positive
        ShftTilt 60 | the tilt of the shaft is 60.00 degrees; it must be between -45 and 45 degrees
    "#;
    for [changes, reason] in rows(table) {
        let changes = words(changes).into_iter();
        let changes: Vec<_> = changes.filter_map(|one| one.split_once(' ')).collect();
        let found = missing(&deck(&changes));
        found.says(reason);
        found.begins("main.dat:");
    }
}

#[test]
fn a_hanging_tower_has_no_turbine() {
    let hangs = deck(&[("TowerHt", "-40"), ("TowerBsHt", "-10"), ("OverHang", "4")]);
    missing(&hangs).says("a turbine on a hanging tower is not supported");
}

/// A deck whose second blade has a file of its own.
fn with_second_blade(blade: &str) -> ElastoDynDeck {
    let mut companions = files(TOWER);
    companions.files.insert("other.dat".into(), blade.into());
    let main = main_text(5, &[("BldFile(2)", "\"other.dat\"")]);
    let expected = source("main.dat", main);
    let deck = read_elastodyn(expected, &companions, &ReadOptions::default());
    deck.expect("a deck")
}

#[test]
fn blades_of_equal_files_are_equal_and_others_are_not() {
    assert!(with_second_blade(BLADE).input.turbine.is_some());
    let heavier = with_second_blade(&BLADE.replace(" 2 AdjBlMs", " 2.1 AdjBlMs"));
    let found = missing(&heavier);
    let reason = "blade 2 (other.dat) has another table or other factors than blade 1 (parts\\blade.dat): different blades are not supported; all files BldFile must have the same content";
    found.says(reason);
}

#[test]
fn a_table_of_very_many_rows_makes_no_turbine() {
    let row = |k: usize| format!(" {} 0.25 0 50 1e9 1e9\n", k as f64 / 1500.0);
    let rows: String = (0..=1500).map(row).collect();
    let (head, _) = BLADE.split_once(" 0 0.25 13").expect("a table");
    let text = head.replace(" 2 NBlInpSt", " 1501 NBlInpSt") + &rows;
    let mut companions = files(TOWER);
    companions.files.insert("parts\\blade.dat".into(), text);
    let main = source("main.dat", main_text(5, &[]));
    let deck = read_elastodyn(main, &companions, &ReadOptions::default()).expect("a deck");
    missing(&deck).says("the blade file has 1501 rows");
}

#[test]
fn wrong_numbers_of_the_drivetrain_are_refused_at_their_lines() {
    let table = r#"
        DTTorSpr | -1 | DTTorSpr (torsional stiffness of the shaft, N m/rad) is -1, but must be non-negative
        DTTorSpr | NaN | DTTorSpr
        GenDOF | perhaps | GenDOF
        YawDOF | 3.5 | YawDOF
    "#;
    for [key, value, said] in rows(table) {
        let main = source("main.dat", main_text(5, &[(key, value)]));
        let read = read_elastodyn(main.clone(), &files(TOWER), &ReadOptions::default());
        let error = read.expect_err("refused").to_string();
        let line = main
            .text
            .lines()
            .position(|line| line.contains(&format!(" {key} ")));
        let place = format!("main.dat:{}:", line.expect("a line") + 1);
        assert!(error.contains(said) && error.contains(&place), "{error}");
    }
}

/// A deck by an `.fst` file with these lines, and a ServoDyn file with these.
fn by_fst(lines: &str, servo: &str) -> ElastoDynDeck {
    let fst = format!("OpenFAST INPUT FILE\nx\n\"main.dat\" EDFile - file\n{lines}");
    let mut companions = files(TOWER);
    let main = main_text(5, &[("YawDOF", "True")]);
    companions.files.insert("main.dat".into(), main);
    companions.files.insert("servo.dat".into(), servo.into());
    let deck = read_elastodyn(source("a.fst", fst), &companions, &ReadOptions::default());
    deck.expect("a deck")
}

#[test]
fn the_yaw_spring_is_that_of_servodyn() {
    let named = "1 CompServo\n\"servo.dat\" ServoFile\n";
    let deck = by_fst(named, "SERVODYN\nx\n  9.02832E+09   YawSpr - spring\n");
    let turbine = deck.input.turbine.as_ref().expect("a turbine");
    assert_eq!(turbine.yaw_n_m_per_rad, 9.028_32e9);
    assert!(notes(&deck).iter().all(|note| !note.contains("Yaw")));
    for (lines, servo, words) in [
        (
            named,
            "nothing\n",
            "servo.dat has no YawSpr: the nacelle does not yaw on the tower",
        ),
        (
            "1 CompServo\n\"x.dat\" ServoFile\n",
            "",
            "cannot be read (x.dat: no such file)",
        ),
        (
            "0 CompServo\n\"servo.dat\" ServoFile\n",
            "",
            "CompServo is 0",
        ),
        ("", "", "the .fst file has no ServoFile"),
    ] {
        let deck = by_fst(lines, servo);
        let turbine = deck.input.turbine.as_ref().expect("a turbine");
        assert_eq!(turbine.yaw_n_m_per_rad, f64::INFINITY);
        let holds = notes(&deck).iter().any(|note| note.contains(words));
        assert!(holds, "{words}");
    }
    let table = r#"
        x\n0 YawSpr\n | servo.dat:2: YawSpr is 0 N m/rad although YawDOF is True
        x\n-5 YawSpr\n | servo.dat:2: YawSpr (stiffness of the yaw drive, N m/rad) is -5, but must be non-negative
        x\nstiff YawSpr\n | servo.dat:2:␣
    "#;
    for [servo, said] in rows(table) {
        missing(&by_fst(named, servo)).says(said);
    }
}

#[test]
fn blades_of_beamdyn_are_said() {
    let lines = "2 CompElast\n1 CompServo\n\"servo.dat\" ServoFile\n";
    let deck = by_fst(lines, "x\n1e9 YawSpr\n");
    assert!(notes(&deck).iter().any(|note| note.contains("BeamDyn")));
}

#[test]
fn a_changed_assembly_or_none_has_no_turbine() {
    let mut input = deck(&[]).input;
    input
        .set(&[Setting::new("rna.mass", 1e4)], "--set")
        .expect("a number");
    let reason = input
        .turbine_missing
        .as_ref()
        .expect("a reason")
        .to_string();
    assert!(input.turbine.is_none(), "{reason}");
    reason.says("changed by --set");
    let options = with!(ReadOptions, without_rna = true);
    let text = main_text(5, &[("NumBl", "2"), ("HubIner_Teeter", "600")]);
    let main = source("main.dat", text);
    let deck = read_elastodyn(main, &files(TOWER), &options).expect("a deck");
    assert!(deck.input.turbine.is_none() && deck.input.turbine_missing.is_none());
}
