//! What every picture must keep, and the towers of examples/.

// Each test uses what it needs.
#![allow(dead_code)]

use std::path::{Path, PathBuf};

use towermodes::{Material, Options, Solution, Station, Tower, TowerDescription, solve};
use towermodes_files::{Input, ReadOptions, TowerInput, read};
use towermodes_report::figures;
use towermodes_report::svg::{Figure, LabelBox, Look};
use towermodes_testing::{stations, with};

/// The towers of examples/.
pub const EXAMPLES: [&str; 9] = [
    "nrel-5mw.toml",
    "reference-tower.toml",
    "reference-tower-350t.toml",
    "guyed.toml",
    "monopile.toml",
    "floating.toml",
    "nrel-5mw-table.toml",
    "nrel-5mw.bmi",
    "nrel-5mw.yaml",
];

/// Smallest text that is read in print.
const SMALLEST: f64 = 9.0;

pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// What a file of examples/ says, and its tower.
pub fn input(name: &str) -> (TowerInput, Tower) {
    let path = root().join("examples").join(name);
    let Ok(Input::Tower(input)) = read(&path, &ReadOptions::default()) else {
        panic!("{name} is no tower");
    };
    let tower = input.tower().expect("a tower");
    (*input, tower)
}

/// A tower of examples/ with its lowest modes.
pub fn example(name: &str, modes: usize) -> (TowerDescription, Tower, Solution) {
    let (input, tower) = input(name);
    let solution = solve(&tower, &with!(Options, modes)).expect("its modes");
    (input.description, tower, solution)
}

/// Whether the picture is [readable](check_labels) and has its words and its numbers.
pub fn check(what: &str, figure: &Figure) {
    check_labels(what, figure);
    let svg = figure.to_svg(Look::Standalone);
    assert!(!svg.contains("NaN"), "{what}: no number");
    assert!(!svg.contains("inf"), "{what}: no number");
    assert!(!figure.title.is_empty(), "{what}");
    assert!(!figure.description.is_empty(), "{what}");
    let table = &figure.table;
    assert!(!table.rows.is_empty(), "{what}: no numbers");
    let holds = table.rows.iter().all(|row| row.len() == table.header.len());
    assert!(holds, "{what}");
}

/// Whether every text is inside the picture, apart from the others and large enough.
pub fn check_labels(what: &str, figure: &Figure) {
    let (width, height) = (figure.drawing.width, figure.drawing.height);
    assert_eq!(width, 900.0, "{what}");
    assert!((380.0..=1400.0).contains(&height), "{what}: {height} high");
    let labels = figure.labels();
    assert!(!labels.is_empty(), "{what}: no text");
    for (index, label) in labels.iter().enumerate() {
        let holds = is_inside(label, width, height);
        assert!(holds, "{what}: {label:?} reaches beyond");
        for other in &labels[index + 1..] {
            assert!(!label.overlaps(other), "{what}: {label:?} and {other:?}");
        }
    }
    let svg = figure.to_svg(Look::Standalone);
    for size in svg.split("font-size=\"").skip(1) {
        let size = size.split('"').next().expect("its end");
        let holds = size.parse::<f64>().expect("a number") >= SMALLEST;
        assert!(holds, "{what}: text of {size}");
    }
}

fn is_inside(label: &LabelBox, width: f64, height: f64) -> bool {
    label.left >= 0.0 && label.top >= 0.0 && label.right <= width && label.bottom <= height
}

/// A steel tower.
pub fn steel(stations: Vec<Station>) -> TowerDescription {
    TowerDescription {
        materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
        stations,
        ..TowerDescription::default()
    }
}

pub fn plain() -> TowerDescription {
    steel(stations(&[(0.0, 6.0, 0.027), (87.6, 3.87, 0.019)]))
}

pub fn solved(tower: &Tower, modes: usize) -> Solution {
    let options = with!(Options, modes);
    solve(tower, &options).expect("its modes")
}

/// Both pictures of a tower.
pub fn look(what: &str, description: &TowerDescription, modes: usize) {
    let tower = Tower::new(description.clone()).unwrap_or_else(|error| panic!("{what}: {error}"));
    check(what, &figures::tower(description, &tower));
    let solution = solved(&tower, modes);
    let figure = figures::shapes(description, &tower, &solution);
    check(what, &figure);
    keep(what, &[figures::tower(description, &tower), figure]);
}

/// Leaves the pictures in the folder that `TOWERMODES_PICTURES` names, for eyes.
pub fn keep(what: &str, pictures: &[Figure]) {
    let Some(folder) = std::env::var_os("TOWERMODES_PICTURES") else {
        return;
    };
    for picture in pictures {
        let file = format!("{}-{}.svg", picture.name, what.replace(' ', "-"));
        let path = Path::new(&folder).join(file);
        std::fs::write(path, picture.to_svg(Look::Standalone)).expect("a folder");
    }
}
