//! Tower files whose numbers are changed in the text: every number of every example by itself and
//! all together, comments kept, and files that must be written anew.

use crate::sources::source;
use std::path::{Path, PathBuf};

use towermodes::{Change, Parameter, TowerDescription};
use towermodes_files::{
    FileFormat, InMemory, Input, ReadOptions, TowerInput, WrittenAnew, read_source, read_tower,
    rewritten,
};
use towermodes_testing::Says;

const MATRICES: &str = r#"
[materials.a]
density = 7_850      # a comment
youngs_modulus = +2.1e11
poissons_ratio = 0.3
[materials.b]
density = 2400
youngs_modulus = 4e10
shear_modulus = 1.6e10
[tower]
stations = [[0, 6, 0.03, "a"], [50.0, 5.0, 0.03, "b"], [80, 4, 0.02, "a"]]
shear = 0.5
outfitting_factor = 1.0
[rna]
mass = 3e5
center = [0.0, 0.0, 0.0]
[foundation]
type = "stiffness"
matrix = [
  [1e9, 0, 0, 0, -2e9, 0], # x
  [0, 1e9, 0, 2e9, 0, 0],
  [0, 0, 1e10, 0, 0, 0],
  [0, 2e9, 0, 1e11, 0, 0],
  [-2e9, 0, 0, 0, 1e11, 0],
  [0, 0, 0, 0, 0, 1e11],
]
"#;

fn examples() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let files = std::fs::read_dir(folder).expect("examples");
    let paths = files.map(|file| file.expect("a file").path());
    let mut paths: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    paths.sort();
    paths
}

fn of_text(text: &str) -> TowerInput {
    read_with(text, &InMemory::default())
}

#[track_caller]
fn read_with(text: &str, files: &InMemory) -> TowerInput {
    read_or_refused(text, files).unwrap_or_else(|why| panic!("the text is no tower file: {why}"))
}

/// The tower of a text, or why the reader refuses it.
fn read_or_refused(text: &str, files: &InMemory) -> Result<TowerInput, String> {
    let source = source("tower.toml", text);
    match read_source(source, files, &ReadOptions::default()) {
        Ok(Input::Tower(input)) => Ok(*input),
        Ok(Input::Blade(_) | Input::Substructure(_) | Input::Mooring(_)) => {
            Err("it is no tower".to_owned())
        }
        Err(error) => Err(error.to_string()),
    }
}

fn towers() -> Vec<TowerInput> {
    let examples = examples();
    assert!(examples.len() >= 5);
    let read = |path: &PathBuf| read_tower(path).expect("a tower").input;
    let mut towers: Vec<TowerInput> = examples.iter().map(read).collect();
    towers.retain(|tower| tower.format == FileFormat::Toml);
    towers.push(of_text(MATRICES));
    towers
}

/// What differs between two texts: the words of the old one, and those of the new one.
fn changed_words(old: &str, new: &str) -> usize {
    let words = |text: &str| -> Vec<String> {
        let separate = |c: char| c.is_whitespace() || "[],{}".contains(c);
        let words = text.split(separate).filter(|word| !word.is_empty());
        words.map(str::to_owned).collect()
    };
    let (old, new) = (words(old), words(new));
    assert_eq!(old.len(), new.len(), "words appeared or disappeared");
    old.iter().zip(&new).filter(|(a, b)| a != b).count()
}

fn with(input: &TowerInput, parameter: Parameter) -> TowerDescription {
    let mut changed = input.description.clone();
    let value = parameter.value(&changed);
    let value = if value == 0.0 { 0.125 } else { value * 1.03125 };
    let value = if value.is_infinite() { 3e9 } else { value };
    parameter.set(&mut changed, value);
    changed
}

#[test]
fn every_number_is_changed_where_it_is_written_and_nowhere_else() {
    let mut absent = Vec::new();
    let mut count = 0;
    for input in towers() {
        let old = input.sources()[0].text.clone();
        for parameter in Parameter::all(&input.description) {
            let changed = with(&input, parameter);
            let file = rewritten(&input, &changed);
            // An RNA with an inertia is no point in the file, whatever the description calls it.
            let mut read = of_text_beside(&input, &file.text).unwrap_or_else(|why| {
                panic!("{parameter} has a new value, and the reader refuses the file that the writer wrote: {why}")
            });
            read.rna_is_point = changed.rna_is_point;
            assert!(
                read == changed,
                "{parameter} has a new value, and the file that the writer wrote is read as another tower: {}",
                first_difference(&read, &changed)
            );
            match file.anew {
                None => {
                    let words = changed_words(&old, &file.text);
                    let is_of_matrix = parameter.to_string().ends_with(']');
                    let expected = if is_of_matrix { 1..=2 } else { 1..=1 };
                    assert!(expected.contains(&words), "{parameter}: {words} words");
                    count += 1;
                }
                // One column may be that of both planes, and inertias follow from others.
                Some(WrittenAnew::Other) => {
                    parameter.begins("properties[");
                }
                Some(reason) => absent.push(reason),
            }
        }
    }
    assert!(count > 150, "{count}");
    let is_expected = |reason: &WrittenAnew| {
        matches!(
            reason,
            WrittenAnew::Absent { .. } | WrittenAnew::OtherFile { .. }
        )
    };
    absent.retain(|reason| !is_expected(reason));
    assert_eq!(absent, []);
}

/// The first number that two towers have with different values.
fn first_difference(read: &TowerDescription, written: &TowerDescription) -> String {
    let mut numbers = Parameter::all(written).into_iter();
    let is_there = |name: &Parameter| Parameter::all(read).contains(name);
    let different = numbers.find_map(|number| {
        let wanted = number.value(written);
        if !is_there(&number) {
            return Some(format!("{number} is missing"));
        }
        let found = number.value(read);
        (found != wanted).then(|| format!("{number} is {found} in place of {wanted}"))
    });
    different.unwrap_or_else(|| "all numbers are the same, a name or a choice is not".to_owned())
}

/// The description in a text, with the files that the tower has beside its own; or why the reader
/// refuses it.
fn of_text_beside(input: &TowerInput, text: &str) -> Result<TowerDescription, String> {
    let others = input.sources().iter().skip(1);
    let named = others.map(|source| ("cans.csv".to_owned(), source.text.clone()));
    let files = InMemory {
        files: named.collect(),
    };
    Ok(read_or_refused(text, &files)?.description)
}

#[test]
fn all_numbers_of_the_stations_together_keep_the_comments_in_their_columns() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let input = read_tower(folder.join("monopile.toml"))
        .expect("a tower")
        .input;
    let mut changed = input.description.clone();
    let apply = |name: &str, value: f64, changed: &mut TowerDescription| {
        Change::parse(name, changed)
            .expect("a change")
            .apply(changed, value);
    };
    apply("scale(stations[*].wall)", 2.0, &mut changed);
    apply("foundation.lateral", 123_456_789.0, &mut changed);
    apply("water.level", 0.5, &mut changed);
    let file = rewritten(&input, &changed);
    assert_eq!(file.anew, None);
    for line in [
        "  [-45.0, 6.00, 0.12],",
        "  [ 97.6, 3.87, 0.038],",
        "lateral = 1.23456789e8         # N/m",
        "level = 0.5                    # m",
        "shear = true                   # Timoshenko: the pile is short for its diameter",
    ] {
        assert!(file.text.contains(line), "{line} is not in\n{}", file.text);
    }
    let old = &input.sources()[0].text;
    assert_eq!(file.text.lines().count(), old.lines().count());
}

#[test]
fn both_entries_of_a_symmetric_matrix_change() {
    let input = of_text(MATRICES);
    let mut changed = input.description.clone();
    let entry = Change::parse("foundation.matrix[0][4]", &changed).expect("an entry");
    entry.apply(&mut changed, -3e9);
    let file = rewritten(&input, &changed);
    assert_eq!(file.anew, None);
    file.text.says("[1e9, 0, 0, 0, -3e9, 0], # x");
    file.text.says("[-3e9, 0, 0, 0, 1e11, 0],");
}

#[test]
fn what_the_text_does_not_contain_is_written_anew_with_the_reason() {
    let anew = |text: &str, name: &str, value: f64| {
        let input = of_text(text);
        let mut changed = input.description.clone();
        Change::parse(name, &changed)
            .expect("a change")
            .apply(&mut changed, value);
        let file = rewritten(&input, &changed);
        assert_eq!(of_text(&file.text).description, changed);
        file.anew.map(|reason| reason.to_string())
    };
    let absent = |name: &str| Some(format!("the old file does not contain {name}"));
    let found = anew(MATRICES, "rna.inertia.xx", 1e6);
    assert_eq!(found, absent("rna.inertia.xx"));
    let found = anew(MATRICES, "gravity.acceleration", 9.81);
    assert_eq!(found, absent("gravity.acceleration"));
    assert_eq!(anew(MATRICES, "rna.mass", 4e5), None);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let cans = read_tower(folder.join("cans.toml")).expect("a tower").input;
    let mut changed = cans.description.clone();
    changed.stations[0].wall_thickness_m *= 1.1;
    let reason = rewritten(&cans, &changed)
        .anew
        .expect("a reason")
        .to_string();
    reason.says("stations[0].wall is in another file, ");
    changed = cans.description.clone();
    changed.rna.mass_kg *= 1.1;
    assert_eq!(rewritten(&cans, &changed).anew, None);
    let table = read_tower(folder.join("nrel-5mw-table.toml")).expect("a tower");
    let mut both = table.input.description.clone();
    both.properties[3].properties.bending_n_m2.fore_aft *= 2.0;
    both.properties[3].properties.bending_n_m2.side_side *= 2.0;
    both.properties[3].properties.axial_n *= 0.5;
    assert_eq!(rewritten(&table.input, &both).anew, None);
    let deck = read_tower(folder.join("nrel-5mw.bmi"))
        .expect("a deck")
        .input;
    let file = rewritten(&deck, &deck.description);
    assert_eq!(file.anew, Some(WrittenAnew::NotToml));
    let alone = TowerInput::from_description(deck.description.clone());
    let file = rewritten(&alone, &deck.description);
    assert_eq!(file.anew, Some(WrittenAnew::Other));
}

#[test]
fn a_tower_that_is_not_changed_keeps_its_text() {
    for input in towers() {
        let file = rewritten(&input, &input.description);
        assert_eq!(file.anew, None);
        assert_eq!(file.text, input.sources()[0].text);
    }
}
