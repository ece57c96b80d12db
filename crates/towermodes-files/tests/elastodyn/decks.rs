//! Whole decks: the tower they describe, and files that are not there.

use towermodes::{Foundation, Rna};
use towermodes_files::elastodyn::read_elastodyn;
use towermodes_files::{InMemory, InputError, ReadOptions};

use crate::elastodyn::texts::{BLADE, TOWER, deck, files, main_text, source};

#[test]
fn a_deck_is_a_clamped_tower() {
    let deck = deck(&[("TowerBsHt", "10"), ("PtfmPDOF", "True")]);
    let tower = &deck.input.description;
    let heights: Vec<f64> = tower.properties.iter().map(|row| row.height_m).collect();
    assert_eq!(heights, [10.0, 17.5, 40.0]);
    let row = tower.properties[1].properties;
    assert_eq!(row.mass_kg_per_m, 1800.0);
    assert_eq!(
        (row.bending_n_m2.fore_aft, row.bending_n_m2.side_side),
        (2.7e10, 7.2e10)
    );
    assert_eq!(
        (row.torsion_n_m2, row.axial_n),
        (f64::INFINITY, f64::INFINITY)
    );
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
            .any(|note| note.contains("neither twist nor stretch"))
    );
    assert!(
        notes.iter().any(|note| note.contains("GBRatio^2 = 1.8")),
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
    assert!(
        error.to_string().contains("ed/mien.dat: no such file"),
        "{error}"
    );
}

#[test]
fn files_that_are_not_there_or_not_main_files_are_said() {
    let missing = |changes: &[(&str, &str)]| {
        let main = source("main.dat", main_text(5, changes));
        read_elastodyn(main, &files(TOWER), &ReadOptions::default()).expect_err("no file")
    };
    let InputError::Mistakes {
        source_file,
        mistakes,
    } = missing(&[("BldFile(2)", "\"b2.dat\"")])
    else {
        panic!("a mistake in the main file");
    };
    assert!(
        mistakes[0]
            .message
            .contains("BldFile(2) cannot be read: b2.dat: no such file")
    );
    assert_eq!(&source_file.text[mistakes[0].span.clone()], "\"b2.dat\"");
    assert!(
        missing(&[("TwrFile", "t.dat")])
            .to_string()
            .contains("t.dat: no such file")
    );
    for (text, part) in [(TOWER, "a tower file"), (BLADE, "a blade file")] {
        let error = read_elastodyn(source("x", text), &files(TOWER), &ReadOptions::default());
        assert!(error.expect_err(part).to_string().contains(part));
    }
    let mistake = TOWER.replace(" 1.0 800", " 1.0 -800");
    let main = source("main.dat", main_text(5, &[]));
    let error =
        read_elastodyn(main, &files(&mistake), &ReadOptions::default()).expect_err("negative");
    assert!(
        error
            .to_string()
            .starts_with("tower.dat: TMassDen of row 3 is -800"),
        "{error}"
    );
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
        let Err(InputError::Mistakes {
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
    assert_eq!(
        refused(|tower| tower.rna.mass_kg = -1.0),
        at("main.dat", "2000")
    );
    assert_eq!(
        refused(|tower| tower.rna.inertia_kg_m2.xx = -1e9),
        at("main.dat", "4000")
    );
}
