//! Files that are right are not warned of; files with a slip say where it stands.

use crate::sources::source;
use std::path::{Path, PathBuf};

use towermodes::{Place, Quantity, Warning};
use towermodes_files::{Input, ReadOptions, SiblingFiles, Source, TowerInput, read_source};
use towermodes_testing::{Says, with};

use crate::round_trips::towers;

/// All files of a folder and the folders in it.
fn files_in(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let paths = entries.map(|entry| entry.expect("an entry of the folder").path());
    let below = |path: PathBuf| match path.is_dir() {
        true => files_in(&path),
        false => vec![path],
    };
    paths.flat_map(below).collect()
}

/// What a file describes, if it is a tower; a file that does not say the tower's height is given 90
/// m.
fn tower_of(path: &Path) -> Option<TowerInput> {
    [None, Some(90.0)].into_iter().find_map(|tower_height_m| {
        let options = with!(ReadOptions, tower_height_m);
        let source = Source::from_path(path).ok()?;
        match read_source(source, &SiblingFiles::of(path), &options).ok()? {
            Input::Tower(tower) => Some(*tower),
            Input::Blade(_) | Input::Substructure(_) | Input::Mooring(_) => None,
        }
    })
}

/// The warnings of all towers of a folder with their files, and how many towers there are.
fn warned(folder: &Path) -> (usize, Vec<String>) {
    let mut said = Vec::new();
    let mut count = 0;
    for path in files_in(folder) {
        let Some(tower) = tower_of(&path).and_then(|input| input.tower().ok()) else {
            continue;
        };
        count += 1;
        // That entries of a platform's matrix are rounded differently, and which parts of a model
        // are not read, is said of every such file, and is no slip.
        let is_slip =
            |w: &&Warning| !matches!(w, Warning::Symmetrized { .. } | Warning::PartsMissing(_));
        let slips = tower.warnings().iter().filter(is_slip);
        said.extend(slips.map(|warning| format!("{}: {warning}", path.display())));
    }
    (count, said)
}

#[test]
fn examples_are_not_warned_of() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let (count, said) = warned(&folder);
    assert_eq!((count >= 11, said), (true, vec![]));
}

#[test]
fn public_files_are_not_warned_of() {
    let Some(folder) = std::env::var_os("TOWERMODES_PEER_DATA").map(PathBuf::from) else {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
        return;
    };
    let (count, said) = warned(&folder);
    assert_eq!((count >= 20, said), (true, vec![]));
}

#[test]
fn towers_of_the_tests_are_not_warned_of() {
    for (name, description) in towers::all() {
        let tower = towermodes::Tower::new(description).expect("a tower");
        assert_eq!(tower.warnings(), [], "{name}");
    }
}

/// The input of a text in TOML.
fn read_text(text: &str) -> TowerInput {
    let source = source("tower.toml", text);
    match read_source(
        source,
        &SiblingFiles::of(Path::new("tower.toml")),
        &ReadOptions::default(),
    ) {
        Ok(Input::Tower(tower)) => *tower,
        other => panic!("{other:?}"),
    }
}

const MONOPILE: &str = include_str!("../../../examples/monopile.toml");

/// Asserts that the example with a text replaced is warned of once, at the line where the replaced
/// text stands.
#[track_caller]
fn slip(from: &str, to: &str, is_expected: impl Fn(&Warning) -> bool) {
    MONOPILE.says(from);
    let text = MONOPILE.replacen(from, to, 1);
    let input = read_text(&text);
    let tower = input.tower().expect("a tower");
    let warnings = tower.warnings();
    assert!(warnings.len() == 1, "{warnings:?}");
    assert!(is_expected(&warnings[0]), "{warnings:?}");
    let line = 1 + text[..text.find(to).expect("it was put there")]
        .matches('\n')
        .count();
    let place = warnings[0].place().expect("a place");
    let expected = Some(("tower.toml", line));
    assert_eq!(input.line_of(place), expected, "{place:?}");
}

#[test]
fn slips_are_said_with_their_line() {
    let odd = |quantity: Quantity| move |w: &Warning| matches!(w, Warning::Unusual { quantity: got, .. } if *got == quantity);
    slip(
        "xx = 4.370e7, yy = 2.353e7, zz = 2.542e7, xz = 1.169e6",
        "xx = 4.370e4, yy = 2.353e4, zz = 2.542e4, xz = 1.169e3",
        |w| odd(Quantity::RadiusOfBody)(w),
    );
    let is_expected = odd(Quantity::CentreDistance);
    slip("center = [-0.41", "center = [-410.0", is_expected);
    slip("density = 8500.0", "density = 8.5", odd(Quantity::Density));
    slip("level = 0.0 ", "level = 98.0 ", |w| {
        matches!(w, Warning::UnderWater { .. })
    });
    let is_expected = odd(Quantity::RadiusOfBody);
    let from = "xx = 1.5e6, yy = 1.5e6";
    slip(from, "xx = 1.5e9, yy = 1.5e9", is_expected);
}

#[test]
fn no_gravity_is_noted() {
    let text = MONOPILE.replace("acceleration = 9.80665", "acceleration = 0.0");
    let input = read_text(&text);
    let notes: Vec<String> = input.notes.iter().map(ToString::to_string).collect();
    assert_eq!(notes.len(), 1, "{notes:?}");
    notes[0].begins("tower.toml:");
    notes[0].says("acceleration = 0 has no effect");
    assert!(read_text(MONOPILE).notes.is_empty());
}

#[test]
fn a_machine_without_inertia_is_meant_so_where_zeros_say_so() {
    const POINT: &str = include_str!("../../../examples/reference-tower-350t.toml");
    let said = read_text(POINT);
    assert!(said.description.rna_is_point);
    assert!(said.tower().expect("a tower").warnings().is_empty());
    let zeros = POINT
        .lines()
        .find(|line| line.starts_with("inertia"))
        .expect("zeros");
    let forgotten = read_text(&POINT.replace(zeros, ""));
    assert!(!forgotten.description.rna_is_point);
    let tower = forgotten.tower().expect("a tower");
    let place = Place::Rna { key: "inertia" };
    let warning = &tower.warnings()[0];
    assert!(matches!(warning, Warning::RnaWithoutInertia { .. }));
    // The place of what is left out is its table.
    let line = POINT
        .lines()
        .position(|line| line == "[rna]")
        .expect("the table")
        + 1;
    assert_eq!(forgotten.line_of(place).map(|(_, at)| at), Some(line));
}
