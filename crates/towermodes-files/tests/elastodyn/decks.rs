//! Whole decks: the tower they describe, and files that are not there.

use towermodes::{Foundation, Rna, Tower};
use towermodes_analysis::elastodyn::Damping;
use towermodes_files::elastodyn::{ElastoDynDeck, read_elastodyn};
use towermodes_files::{InMemory, ReadError, ReadOptions, RotorLock, read_source};
use towermodes_testing::{Says, with};

use crate::elastodyn::texts::{BLADE, TOWER, deck, files, main_text, source};

#[test]
fn a_deck_is_a_clamped_tower() {
    let deck = deck(&[("TowerBsHt", "10"), ("PtfmPDOF", "True")]);
    let tower = &deck.input.description;
    let heights: Vec<f64> = tower.properties.iter().map(|row| row.height_m).collect();
    assert_eq!(heights, [10.0, 17.5, 40.0]);
    let row = tower.properties[1].properties;
    assert_eq!(row.mass_kg_per_m, 1800.0);
    assert_eq!(row.bending_n_m2.fore_aft, 2.7e10);
    assert_eq!(row.bending_n_m2.side_side, 7.2e10);
    assert_eq!(row.torsion_n_m2, f64::INFINITY);
    assert_eq!(row.axial_n, f64::INFINITY);
    assert_eq!(tower.point_masses[0].height_m, 25.0);
    assert_eq!(tower.foundation, Foundation::Clamped);
    assert_eq!(tower.rna, Rna::from(deck.rna));
    let notes: Vec<String> = deck.input.notes.iter().map(ToString::to_string).collect();
    assert!(
        notes
            .iter()
            .any(|note| note.contains("clamped at z = 10 m (the platform moves)"))
    );
    assert!(
        notes
            .iter()
            .any(|note| note.contains("rigid in torsion and axially"))
    );
    assert!(
        notes.iter().any(|note| note.starts_with("main.dat:")
            && note.contains("GenIner counts once, without the factor GBRatio^2")),
        "{notes:?}"
    );
    let files: Vec<&str> = deck.input.files().collect();
    assert_eq!(files, ["main.dat", "tower.dat", "parts\\blade.dat"]);
}

#[test]
fn an_fst_file_leads_to_the_deck() {
    let fst = "OpenFAST INPUT FILE\nx\n1 CompElast - (switch)\n\"ed/main.dat\" EDFile - file\n";
    let mut companions = InMemory::default();
    for (name, text) in [
        ("ed/main.dat", main_text(1, &[])),
        ("ed/tower.dat", TOWER.into()),
        ("ed/parts\\blade.dat", BLADE.into()),
    ] {
        companions.files.insert(name.into(), text);
    }
    let read =
        |text: &str| read_elastodyn(source("a.fst", text), &companions, &ReadOptions::default());
    let deck = read(fst).expect("a deck");
    assert_eq!(deck.input.files().count(), 4);
    assert_eq!(deck.main.gravity_m_per_s2, Some(9.81));
    let beamdyn = read(&fst.replace("1 CompElast", "2 CompElast")).expect("a deck");
    assert_eq!(beamdyn.input.notes[0].place, Some(("a.fst".into(), 3)));
    let error = read(&fst.replace("main", "mien")).expect_err("no such file");
    error.says("ed/mien.dat: no such file");
}

/// A deck with an `.fst` file of these lines beside its own.
pub fn by_fst(
    lines: &str,
    version: usize,
    options: &ReadOptions,
) -> Result<ElastoDynDeck, ReadError> {
    let fst = format!("OpenFAST INPUT FILE\nx\n\"main.dat\" EDFile - file\n{lines}");
    let mut companions = files(TOWER);
    let main = main_text(version, &[]);
    companions.files.insert("main.dat".into(), main);
    read_elastodyn(source("a.fst", fst), &companions, options)
}

pub fn messages(deck: &ElastoDynDeck) -> Vec<String> {
    deck.input.notes.iter().map(ToString::to_string).collect()
}

/// The gravity of a deck, and what is said of it.
fn gravity(deck: &ElastoDynDeck) -> (f64, Vec<String>) {
    let said = messages(deck).into_iter();
    let said = said.filter(|note| note.contains("Gravity")).collect();
    (deck.input.description.gravity_m_per_s2, said)
}

#[test]
fn gravity_is_that_of_the_fst_file_then_of_the_main_file_then_the_standard() {
    let options = ReadOptions::default();
    let of = |lines, version| gravity(&by_fst(lines, version, &options).expect("a deck"));
    assert_eq!(of("9.7 Gravity - (m/s^2)\n", 5), (9.7, vec![]));
    assert_eq!(of("", 1), (9.81, vec![]));
    assert_eq!(of("0 Gravity\n", 5), (0.0, vec![]));
    let (both, said) = of("9.7 Gravity\n", 1);
    assert_eq!(both, 9.7);
    assert_eq!(
        said,
        ["Gravity is 9.7 m/s2 in a.fst and 9.81 m/s2 in main.dat: the first is used"]
    );
    let (standard, said) = of("", 5);
    assert_eq!(standard, 9.80665);
    assert_eq!(
        said,
        ["neither a.fst nor main.dat has Gravity: 9.80665 m/s2 is assumed (--no-gravity omits it)"]
    );
    let wrong = by_fst("-9.81 Gravity\n", 5, &options).expect_err("negative");
    wrong.says(": Gravity");
}

#[test]
fn gravity_may_be_left_out_of_any_file() {
    let options = with!(ReadOptions, without_gravity = true);
    let deck = by_fst("9.7 Gravity\n", 5, &options).expect("a deck");
    assert_eq!(gravity(&deck), (0.0, vec![]));
    let toml = "[gravity]\n[material]\ndensity = 7850\nyoungs_modulus = 2.1e11\nshear_modulus = 8.1e10\n\
                [tower]\nstations = [[0, 6, 0.03], [80, 4, 0.02]]\n";
    let read = |options: &ReadOptions| {
        let input = read_source(source("t.toml", toml), &InMemory::default(), options);
        match input.expect("a tower") {
            towermodes_files::Input::Tower(tower) => tower.description.gravity_m_per_s2,
            towermodes_files::Input::Blade(_)
            | towermodes_files::Input::Substructure(_)
            | towermodes_files::Input::Mooring(_) => {
                panic!("no tower")
            }
        }
    };
    assert_eq!(read(&ReadOptions::default()), 9.80665);
    assert_eq!(read(&options), 0.0);
}

/// ElastoDyn adds the weights to its shapes' stiffness itself; any other tower is as its file
/// describes it.
#[test]
fn shapes_are_those_of_a_deck_without_gravity() {
    let input = deck(&[]).input;
    let gravity = |tower: Tower| tower.gravity_m_per_s2();
    assert_eq!(input.tower().map(gravity).expect("a tower"), 9.80665);
    assert_eq!(input.tower_for_shapes().map(gravity).expect("a tower"), 0.0);
    assert!(input.note_on_shapes().is_some());
    let mut weightless = deck(&[]).input;
    weightless.description.gravity_m_per_s2 = 0.0;
    assert_eq!(weightless.note_on_shapes(), None);
    // Of a tower in TOML that has it gravity stays.
    let mut own = input;
    own.format = towermodes_files::FileFormat::Toml;
    let found = own.tower_for_shapes().map(gravity).expect("a tower");
    assert_eq!(found, 9.80665);
}

#[test]
fn modules_under_the_tower_are_left_out_with_a_note() {
    let options = ReadOptions::default();
    let lines = "1 CompHydro\n0 CompSub\n3 CompMooring\n\"hd.dat\" HydroFile\n\
                 \"sub.dat\" SubFile\n\"moor.dat\" MooringFile\n";
    let deck = by_fst(lines, 5, &options).expect("a deck");
    let left_out: Vec<String> = messages(&deck)
        .into_iter()
        .filter(|note| note.contains("left out"))
        .collect();
    assert_eq!(
        left_out,
        [
            "a.fst:4: CompHydro is switched on, but its file (hd.dat) is not read, because CompSub is 0 and no motion of the platform is switched on (PtfmSgDOF to PtfmYDOF): the mass and stiffness of the water are left out",
            "a.fst:6: CompMooring is switched on, but its file (moor.dat) is not read, because CompSub is 0 and no motion of the platform is switched on (PtfmSgDOF to PtfmYDOF): the mooring lines are left out",
        ]
    );
    assert!(
        deck.input
            .notes
            .iter()
            .any(|note| note.is_on_missing_part())
    );
}

/// A file that is switched on and not there is a mistake: the tower without it is another
/// structure. The first versions of FAST 8 have flags.
#[test]
fn a_file_that_is_not_there_is_refused() {
    let options = ReadOptions::default();
    for (lines, key, switch) in [
        ("1 CompSub\n\"sub.dat\" SubFile\n", "SubFile", "CompSub"),
        (
            "True CompSub\nFalse CompHydro\n\"sub.dat\" SDFile\n",
            "SubFile",
            "CompSub",
        ),
    ] {
        let error = by_fst(lines, 5, &options).expect_err("no such file");
        error.says(key);
        error.says("sub.dat");
        let ReadError::Mistakes { mistakes, .. } = &error else {
            panic!("{error}");
        };
        let hint = mistakes[0].hint.clone().expect("a hint");
        hint.says(&format!(
            "{switch} 0 leaves this part out of the model, --clamped clamps"
        ));
        let clamped = with!(ReadOptions, clamped = true);
        let said = messages(&by_fst(lines, 5, &clamped).expect("a tower"));
        said[0].says("(sub.dat) is not read, because of --clamped: the substructure is left out");
    }
    let other = "2 CompSub\n\"x.dat\" SubFile\n";
    let said = messages(&by_fst(other, 5, &options).expect("a tower"));
    said[0].says("(x.dat) is not read, because CompSub 2 is ExtPtfm, which is not modelled");
    let main = [("PtfmPDOF", "True"), ("TowerBsHt", "10")];
    let mut companions = files(TOWER);
    companions
        .files
        .insert("main.dat".into(), main_text(5, &main));
    let fst = format!("OpenFAST INPUT FILE\nx\n\"main.dat\" EDFile\n0 CompHydro\n{other}");
    let said =
        messages(&read_elastodyn(source("a.fst", fst), &companions, &options).expect("a tower"));
    let clamped = said.iter().find(|note| note.contains("is clamped at"));
    clamped
        .expect("a note")
        .says("(the platform moves); its foundation is in other files");
}

/// Without quotes a name ends at its first slash, also in OpenFAST; a quote that is not closed
/// takes the whole line.
#[test]
fn names_of_files_must_be_whole() {
    let options = ReadOptions::default();
    let wrong = |result: Result<ElastoDynDeck, ReadError>, name: &str, hint: &str| {
        let Err(ReadError::Mistakes {
            source_file,
            mistakes,
        }) = result
        else {
            panic!("a mistake: {name}");
        };
        assert_eq!(&source_file.text[mistakes[0].span.clone()], name);
        mistakes[0].message().says("a file name between two quotes");
        mistakes[0].hint.clone().expect("a hint").says(hint);
    };
    let slash = "without quotes a name ends at its first `/`";
    let quote = "close the quote";
    for (name, hint) in [
        ("ed/main.dat", slash),
        ("../main.dat", slash),
        ("\"main.dat", quote),
    ] {
        let fst = source("a.fst", format!("x\nx\n{name} EDFile - (quoted string)\n"));
        wrong(read_elastodyn(fst, &files(TOWER), &options), name, hint);
        let lines = format!("1 CompSub\n{name} SubFile - file\n");
        wrong(by_fst(&lines, 5, &options), name, hint);
        let main = source("main.dat", main_text(5, &[("TwrFile", name)]));
        wrong(read_elastodyn(main, &files(TOWER), &options), name, hint);
    }
}

#[test]
fn comments_on_lines_of_their_own_are_refused() {
    let refusal = |main: String, tower: String| {
        let main = source("main.dat", main);
        let result = read_elastodyn(main, &files(&tower), &ReadOptions::default());
        result.expect_err("a comment").to_string()
    };
    let good = main_text(5, &[]);
    for (name, comment) in [
        ("TipRad", "! longer"),
        ("NacMass", "# NacMass was 1"),
        ("Echo", "%"),
    ] {
        let line = good.lines().find(|line| line.contains(name)).expect(name);
        let said = refusal(
            good.replace(line, &format!("{comment}\n{line}")),
            TOWER.to_owned(),
        );
        said.says(&format!("expected {name} here, found a comment"));
    }
    let rows: Vec<&str> = TOWER
        .lines()
        .skip_while(|line| !line.contains("HtFract"))
        .collect();
    let said = refusal(
        good.clone(),
        TOWER.replace(rows[3], &format!("! base\n{}", rows[3])),
    );
    said.says("found a comment");
    // The heading of a table may be any text, and is two lines.
    let said = refusal(
        good,
        TOWER.replace(rows[0], &format!("# my tower\n{}", rows[0])),
    );
    said.says("row 1 of the distributed properties");
}

/// A model of several rotors has a tower in each of its main files.
#[test]
fn a_model_with_several_rotors_is_refused() {
    let options = ReadOptions::default();
    assert!(by_fst("1 NRotors\n", 5, &options).is_ok());
    let error = by_fst("2 NRotors\n", 5, &options).expect_err("two rotors");
    error.says("NRotors is 2: a model with more than one rotor is not solved");
    let ReadError::Mistakes { mistakes, .. } = &error else {
        panic!("{error}");
    };
    mistakes[0].hint.clone().expect("a hint").says("EDFile");
}

#[test]
fn a_turbine_in_a_current_has_a_note() {
    let options = ReadOptions::default();
    let said = |lines: &str| messages(&by_fst(lines, 5, &options).expect("a tower"));
    let is_it = |note: &String| note.contains("so the turbine is in water");
    assert!(!said("0 MHK\n").iter().any(is_it));
    // The first line is a title.
    for lines in ["1 MHK\n", "Floating MHK turbine\n2 MHK\n"] {
        let said = said(lines);
        assert!(said.iter().any(is_it), "{said:?}");
    }
}

/// The tower of a floating turbine in a current: TowerHt −24 m, TowerBsHt −9 m, the nacelle below
/// the top.
#[test]
fn a_tower_that_hangs_is_solved_upside_down() {
    let hanging = [
        ("TowerHt", "-24"),
        ("TowerBsHt", "-9"),
        ("Twr2Shft", "-2"),
        ("NacCMzn", "-1"),
        ("ShftTilt", "5"),
    ];
    let standing = [("TowerHt", "24"), ("TowerBsHt", "9"), ("ShftTilt", "-5")];
    let (down, up) = (deck(&hanging), deck(&standing));
    assert!(down.main.tower_hangs() && !up.main.tower_hangs());
    assert_eq!(down.main.tower_length_m(), 15.0);
    let (tower, mirror) = (&down.input.description, &up.input.description);
    assert_eq!(tower.properties, mirror.properties);
    assert_eq!(tower.point_masses, mirror.point_masses);
    for (found, expected) in tower.rna.center_m.iter().zip(mirror.rna.center_m) {
        assert!((found - expected).abs() < 1e-12);
    }
    let (found, expected) = (tower.rna.inertia_kg_m2, mirror.rna.inertia_kg_m2);
    assert!((found.xz - expected.xz).abs() < 1e-6 && expected.xz.abs() > 1.0);
    assert!((found.yz - expected.yz).abs() < 1e-6 && expected.yz.abs() > 1.0);
    assert_eq!(tower.gravity_m_per_s2, 0.0);
    let said = messages(&down);
    let hangs = "the tower hangs from z = -9 m down to -24 m: it is solved upside down";
    assert!(said.iter().any(|note| note.starts_with(hangs)), "{said:?}");
    // Above the sea the top is above the base.
    let text = main_text(5, &[("TowerHt", "5"), ("TowerBsHt", "9")]);
    let main = source("main.dat", text);
    let refused = read_elastodyn(main, &files(TOWER), &ReadOptions::default());
    assert!(refused.is_err());
}

/// One row is the whole tower.
#[test]
fn a_tower_of_one_row_is_uniform() {
    let one_row = TOWER
        .replace("3 NTwInpSt", "1 NTwInpSt")
        .replace(" 0.25 900 9e9 1.8e10\n 1.0 800 8e9 1.6e10\n", "");
    let read = |text: &str| {
        let main = source("main.dat", main_text(5, &[]));
        read_elastodyn(main, &files(text), &ReadOptions::default())
    };
    let deck = read(&one_row).expect("a uniform tower");
    let rows = &deck.input.description.properties;
    assert_eq!(rows.len(), 2);
    assert_eq!(rows[0].height_m, 0.0);
    assert_eq!(rows[1].height_m, 40.0);
    assert_eq!(rows[0].properties, rows[1].properties);
    assert_eq!(rows[0].properties.mass_kg_per_m, 2000.0);
    // ElastoDyn's own tower of it: 2000 kg/m over 40 m.
    let model = deck.tower.model(40.0, 20, 0.0);
    let modes = deck.tower.modes().fore_aft;
    let quantities = model.generalized(towermodes::Plane::ForeAft, &modes);
    let mass_kg = quantities.expect("a model").tower_mass_kg;
    assert!((mass_kg - 80e3).abs() < 1e-6, "{mass_kg}");
    // A mistake at the top is one in the only row.
    let mut input = deck.input;
    input.description.properties[1].properties.mass_kg_per_m = -1.0;
    let Err(ReadError::Mistakes {
        source_file,
        mistakes,
    }) = input.tower()
    else {
        panic!("a negative mass");
    };
    assert_eq!(&source_file.text[mistakes[0].span.clone()], "1.0D3");
    let error = read(&one_row.replace(" 0.0 1.0D3", " 1.0 1.0D3")).expect_err("it begins at 0");
    error.says("HtFract of the first row is 1");
}

#[test]
fn the_rotor_is_held_or_free_with_a_note() {
    let read = |rotor| {
        let options = with!(ReadOptions, rotor);
        let main = source("main.dat", main_text(5, &[]));
        messages(&read_elastodyn(main, &files(TOWER), &options).expect("a deck"))
    };
    let locked = read(RotorLock::Locked);
    let says = |said: &[String], what: &str| said.iter().any(|note| note.contains(what));
    // 133070 + 2 kg m² locked; 133070 · 8/133088 = 7.9989 free.
    assert!(says(
        &locked,
        "the inertia about the shaft is 1.3307e5 kg m2, in which GenIner counts once, without the factor GBRatio^2; use --rotor free"
    ));
    let free = read(RotorLock::Free);
    assert!(says(
        &free,
        "the inertia about the shaft is 7.9989e0 kg m2 instead of 1.3307e5"
    ));
}

#[test]
fn files_that_are_not_there_or_not_main_files_are_said() {
    let missing = |changes: &[(&str, &str)]| {
        let main = source("main.dat", main_text(5, changes));
        read_elastodyn(main, &files(TOWER), &ReadOptions::default()).expect_err("no file")
    };
    let ReadError::Mistakes {
        source_file,
        mistakes,
    } = missing(&[("BldFile(2)", "\"b2.dat\"")])
    else {
        panic!("a mistake in the main file");
    };
    mistakes[0]
        .message()
        .says("BldFile(2) cannot be read: b2.dat: no such file");
    assert_eq!(&source_file.text[mistakes[0].span.clone()], "\"b2.dat\"");
    missing(&[("TwrFile", "t.dat")]).says("t.dat: no such file");
    for (text, part) in [(TOWER, "a tower file"), (BLADE, "a blade file")] {
        let error = read_elastodyn(source("x", text), &files(TOWER), &ReadOptions::default());
        error.expect_err(part).says(part);
    }
    let mistake = TOWER.replace(" 1.0 800", " 1.0 -800");
    let main = source("main.dat", main_text(5, &[]));
    let error =
        read_elastodyn(main, &files(&mistake), &ReadOptions::default()).expect_err("negative");
    error.begins("tower.dat:22:6: TMassDen of row 3 is -800");
}

#[test]
fn what_the_library_refuses_is_in_the_right_file() {
    let refused = |change: fn(&mut towermodes::TowerDescription)| {
        let mut input = deck(&[]).input;
        for row in &mut input.description.properties {
            (row.properties.torsion_n_m2, row.properties.axial_n) = (1e10, 1e10);
            row.properties.polar_inertia_kg_m = 1.0;
        }
        change(&mut input.description);
        let Err(ReadError::Mistakes {
            source_file,
            mistakes,
        }) = input.tower()
        else {
            panic!("it is refused");
        };
        let text = source_file.text[mistakes[0].span.clone()].to_owned();
        (source_file.name, text)
    };
    let at = |file: &str, text: &str| (file.to_owned(), text.to_owned());
    let station = refused(|tower| tower.properties[1].properties.mass_kg_per_m = -1.0);
    assert_eq!(station, at("tower.dat", "900"));
    let stiffness = refused(|tower| tower.properties[2].properties.bending_n_m2.side_side = 0.0);
    assert_eq!(stiffness, at("tower.dat", "1.6e10"));
    let torsion = refused(|tower| tower.properties[1].properties.torsion_n_m2 = -1.0);
    assert_eq!(torsion, at("tower.dat", "0.25 900 9e9 1.8e10"));
    let mass = refused(|tower| tower.point_masses[0].height_m = 99.0);
    assert_eq!(mass, at("tower.dat", "0.5"));
    let found = refused(|tower| tower.rna.mass_kg = -1.0);
    assert_eq!(found, at("main.dat", "2000"));
    let found = refused(|tower| tower.rna.inertia_kg_m2.xx = -1e9);
    assert_eq!(found, at("main.dat", "4000"));
}

/// Without gravity a platform has neither weight nor buoyancy to hold it.
#[test]
fn shapes_of_a_floating_deck_are_with_gravity() {
    let mut input = deck(&[]).input;
    input.description.foundation = Foundation::Floating(Box::default());
    assert_eq!(input.description_for_shapes().gravity_m_per_s2, 9.80665);
    let note = input.note_on_shapes().expect("a note").to_string();
    note.says("with gravity, because the stiffness of the floating platform depends on weight and buoyancy");
}

/// The tower file of a deck is written with its damping, and with tuners of 1, which is said.
#[test]
fn a_written_tower_file_has_the_damping_of_the_deck() {
    let found = deck(&[]);
    let given = (
        found.tower.fore_aft_damping_percent,
        found.tower.side_side_damping_percent,
    );
    let Damping::Kept(kept) = found.input.damping_for_tower_file() else {
        panic!("the damping of the deck is not kept");
    };
    assert_eq!((kept.fore_aft, kept.side_side), given);
    let notes: Vec<String> = found
        .input
        .notes_on_tower_file()
        .iter()
        .map(ToString::to_string)
        .collect();
    notes.join(" ").says("are reset to 1 in the written file");
}

/// -5 degrees in radians.
#[test]
fn a_tilt_in_radians_is_a_warning() {
    let said = |tilt: &str| {
        let said = messages(&deck(&[("ShftTilt", tilt)]));
        said.iter()
            .any(|note| note.contains("ShftTilt is -0.0873 degrees"))
    };
    assert!(said("-0.0873") && !said("-5") && !said("0"));
    let small = messages(&deck(&[("ShftTilt", "0.3")]));
    assert!(!small.iter().any(|note| note.contains("ShftTilt is")));
}

/// 644.857 in place of 644857.
#[test]
fn a_nacelle_in_tonnes_is_a_warning() {
    let said = |mass: &str| {
        let deck = deck(&[("NacMass", mass), ("NacYIner", "1e6"), ("TowerHt", "90")]);
        messages(&deck)
            .iter()
            .any(|note| note.contains("NacMass is 644.857 kg on a tower of"))
    };
    assert!(said("644.857") && !said("644857"));
}
