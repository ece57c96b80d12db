//! Values and files that look wrong in a deck and are not, and an adjustment factor that is.

use towermodes::{Place, Tower, Warning};
use towermodes_files::elastodyn::read_elastodyn;
use towermodes_files::{FileError, FileResolver, InMemory, ReadOptions, Source};
use towermodes_testing::with;

use super::decks::{by_fst, messages};
use super::texts::{TOWER, deck, files, main_text, source};
use crate::hydrodyn::texts::{Layout, deck as hydrodyn};

/// Buoyancy carries much of the weight of a turbine that stands in water: it has no gravity here,
/// with a note.
#[test]
fn weight_and_buoyancy_of_a_turbine_in_a_current_are_left_out() {
    let options = ReadOptions::default();
    let read = |lines: &str, options: &ReadOptions| by_fst(lines, 5, options).expect("a tower");
    let note = "its weight and its buoyancy, which act against each other, are both left out";
    let dry = read("0 MHK\n9.81 Gravity\n", &options);
    assert_eq!(dry.input.description.gravity_m_per_s2, 9.81);
    let wet = read("1 MHK\n9.81 Gravity\n", &options);
    assert_eq!(wet.input.description.gravity_m_per_s2, 0.0);
    let said = messages(&wet);
    assert!(said.iter().any(|said| said.contains(note)), "{said:?}");
    let without = with!(ReadOptions, without_gravity = true);
    let said = messages(&read("1 MHK\n", &without));
    assert!(!said.iter().any(|said| said.contains(note)), "{said:?}");
}

/// ElastoDyn has only the inertia of the nacelle about the yaw axis: moments that no body has are
/// no mistake.
#[test]
fn the_inertia_of_a_nacelle_about_its_yaw_axis_is_enough() {
    let on_inertia = |said: &String| said.contains("only moment of inertia of the nacelle");
    let tower = |yaw: &str| {
        let deck = deck(&[("NacYIner", yaw)]);
        let is_noted = messages(&deck).iter().any(on_inertia);
        (
            Tower::new(deck.input.description).expect("a tower"),
            is_noted,
        )
    };
    let impossible = |tower: &Tower| {
        let mut warnings = tower.warnings().iter();
        warnings.any(|warning| matches!(warning, Warning::TriangleInequality { .. }))
    };
    let (large, is_noted) = tower("1e9");
    let [least, middle, largest] = large.rna().inertia_kg_m2.principal_kg_m2();
    assert!(largest > least + middle && is_noted && !impossible(&large));
    let mut description = deck(&[("NacYIner", "1e9")]).input.description;
    description.rna_inertia_is_partial = false;
    assert!(impossible(&Tower::new(description).expect("a tower")));
    let (usual, is_noted) = tower("4000");
    let [least, middle, largest] = usual.rna().inertia_kg_m2.principal_kg_m2();
    assert!(largest < least + middle && !is_noted);
}

/// A factor that makes a stiffness wrong is named, and warnings on the product are on its line.
#[test]
fn a_wrong_adjustment_factor_is_named_with_its_line() {
    let text = TOWER.replace(" 3 AdjFASt", " 3e-3 AdjFASt");
    let line = 1 + text
        .lines()
        .position(|line| line.contains("AdjFASt"))
        .expect("a line");
    let main = source("main.dat", main_text(5, &[]));
    let deck = read_elastodyn(main, &files(&text), &ReadOptions::default()).expect("a deck");
    let said = messages(&deck);
    let begins = format!("tower.dat:{line}: AdjFASt is 0.003 and multiplies its column");
    assert!(
        said.iter().any(|said| said.starts_with(&begins)),
        "{said:?}"
    );
    let place = |key| deck.input.line_of(Place::Station { index: 0, key });
    assert_eq!(place("ei_fore_aft_n_m2"), Some(("tower.dat", line)));
    assert_ne!(place("ei_side_side_n_m2"), Some(("tower.dat", line)));
}

/// Files that are found by their names alone, as those of a copied folder.
struct Flat(InMemory);

impl FileResolver for Flat {
    fn read(&self, path: &str) -> Result<Source, FileError> {
        let name = path.rsplit('/').next().unwrap_or(path);
        let found = self.0.read(name);
        found.map_err(|_| FileError::Missing { name: path.into() })
    }
}

/// The files of a folder, found by the last part of a path without regard to capital letters.
struct Folder(InMemory);

impl FileResolver for Folder {
    fn read(&self, path: &str) -> Result<Source, FileError> {
        let last = path.rsplit(['/', '\\']).next().unwrap_or(path);
        let mut files = self.0.files.iter();
        let found = files.find(|(name, _)| name.eq_ignore_ascii_case(last));
        let missing = || FileError::Missing { name: path.into() };
        let (name, text) = found.ok_or_else(missing)?;
        let (name, text) = (format!("deck/{name}"), text.clone());
        Ok(Source { name, text })
    }
}

const BLADES: [&str; 3] = ["BldFile(1)", "BldFile(2)", "BldFile(3)"];

/// A path of another machine and other capital letters are read, with a note.
#[test]
fn a_file_in_place_of_another_has_a_note() {
    let mut companions = files(TOWER);
    let blade = companions.files.remove("parts\\blade.dat");
    let blade = blade.expect("a blade");
    companions.files.insert("blade.dat".into(), blade);
    let said = |tower: &str, blade: &str| {
        let blades = BLADES.map(|key| (key, blade));
        let main = main_text(5, &[&blades[..], &[("TwrFile", tower)]].concat());
        let files = Folder(companions.clone());
        let read = read_elastodyn(source("main.dat", &main), &files, &ReadOptions::default());
        let said = messages(&read.expect("a deck")).into_iter();
        let said = said.filter(|note| note.contains("there is no"));
        said.map(|note| note.split_once(": ").expect("a place").1.to_owned())
            .collect::<Vec<_>>()
    };
    let none: [&str; 0] = [];
    assert_eq!(said("\"tower.dat\"", "\"blade.dat\""), none);
    let expected = [
        "TwrFile: there is no C:\\models\\tower.dat; deck/tower.dat is used",
        "BldFile(1): there is no Blade.dat; deck/blade.dat is used, whose name has other capital letters",
    ];
    assert_eq!(said("\"C:\\models\\tower.dat\"", "\"Blade.dat\""), expected);
}

/// Where a file is found beside the `.fst` file, a note says so, and the files that it names are
/// looked for from there.
#[test]
fn a_file_that_is_found_by_its_name_alone_has_a_note() {
    let free = ["Sg", "Sw", "Hv", "R", "P", "Y"].map(|motion| format!("Ptfm{motion}DOF"));
    let changes: Vec<(&str, &str)> = free.iter().map(|name| (name.as_str(), "True")).collect();
    let mut companions = files(TOWER);
    let blade = companions
        .files
        .remove("parts\\blade.dat")
        .expect("a blade");
    let water = hydrodyn(Layout::V41, &[("PotMod", "1")]);
    let water = water.replace("\"body\" PotFile", "\"data/body\" PotFile");
    let others = [
        ("parts\\blade.dat", blade),
        ("main.dat", main_text(5, &changes)),
        ("wet.dat", water),
    ];
    companions
        .files
        .extend(others.map(|(name, text)| (name.to_owned(), text)));
    let fst = "OpenFAST INPUT FILE\nx\n\"main.dat\" EDFile\n1 CompHydro\n\"old/wet.dat\" HydroFile\n\
               9.81 Gravity\n1025 WtrDens\n200 WtrDpth\n0 MSL2SWL\n";
    let read = |companions: InMemory| {
        read_elastodyn(
            source("a.fst", fst),
            &Flat(companions),
            &ReadOptions::default(),
        )
    };
    let error = read(companions.clone())
        .expect_err("no file of WAMIT")
        .to_string();
    assert!(error.contains("data/body.1: no such file"), "{error}");
    assert!(!error.contains("old/data"), "{error}");
    let dry = hydrodyn(Layout::V41, &[]);
    companions.files.insert("wet.dat".into(), dry);
    let deck = read(companions).expect("a deck");
    let said = messages(&deck);
    let note = "a.fst:5: HydroFile: there is no old/wet.dat; the file of this name";
    assert!(said.iter().any(|said| said.starts_with(note)), "{said:?}");
    assert!(
        !said.iter().any(|said| said.contains("EDFile: there")),
        "{said:?}"
    );
}
