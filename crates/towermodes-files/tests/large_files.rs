//! Large files take time and memory that grow with their size and no faster; what is wrong with
//! them is said a hundred times at most.

use towermodes_files::{Diagnostic, tower_from_toml};
use towermodes_testing::Says;

const MATERIAL: &str = "density = 8500.0\nyoungs_modulus = 2.1e11\nshear_modulus = 8.08e10\n";

fn mistakes(text: &str) -> Vec<Diagnostic> {
    let mistakes = tower_from_toml(text).expect_err("mistakes");
    for mistake in &mistakes {
        assert!(text.get(mistake.span.clone()).is_some(), "{mistake:?}");
        let hint = mistake.hint.as_deref().unwrap_or_default();
        assert!(hint.len() < 10_000, "a hint of {} bytes", hint.len());
    }
    mistakes
}

/// A tower with so many materials, `m0` and so on, whose stations have what comes after their three
/// numbers.
fn tower_of_materials(materials: usize, fourth: impl Fn(usize) -> String) -> String {
    let table = |i| format!("[materials.m{i}]\n{MATERIAL}");
    let row = |i| format!("[{i}.0, 6.0, 0.02{}],\n", fourth(i));
    let (tables, rows): (String, String) = (0..materials).map(|i| (table(i), row(i))).unzip();
    format!("{tables}[tower]\nstations = [{rows}]\n")
}

/// To compare a key with those of the format takes as long as both are; this one would take
/// minutes.
#[test]
fn a_key_as_long_as_a_book_is_not_compared() {
    let key = "a".repeat(20_000_000);
    let text = format!("[material]\n{MATERIAL}[tower]\n{key} = 1\n");
    let mistakes = mistakes(&text);
    mistakes[0].message().says("[tower] has no `stations`");
    let expected = Some("valid keys: stations, properties, outfitting_factor, shear");
    assert_eq!(mistakes[1].hint.as_deref(), expected);
}

#[test]
fn a_hundred_unknown_keys_are_enough() {
    let text: String = (0..300_000).map(|i| format!("k{i} = 1\n")).collect();
    let mistakes = mistakes(&text);
    assert_eq!(mistakes.len(), 100);
    assert_eq!(mistakes[0].message(), "`k0` is not a key of the file");
}

/// Each name was compared with each, and each hint listed all of them.
#[test]
fn unknown_materials_among_thousands_are_named_a_hundred_times() {
    let unknown = tower_of_materials(20_000, |i| format!(", \"another{i}\""));
    let all = mistakes(&unknown);
    assert_eq!(all.len(), 100);
    assert_eq!(all[0].message(), "there is no material `another0`");
    let hint = all[0].hint.as_deref().expect("a hint");
    hint.begins("materials: m0, m1, ");
    hint.ends(", …");

    let nameless = mistakes(&tower_of_materials(20_000, |_| String::new()));
    assert_eq!(nameless.len(), 100);
    let words = "the material of station 1 (the file has no [material]) is missing";
    assert_eq!(nameless[0].message(), words);
}

#[test]
fn thousands_of_materials_are_told_apart() {
    let text = tower_of_materials(20_000, |i| format!(", \"m{i}\""));
    let description = towermodes_files::description_from_toml(&text).expect("a tower");
    let materials: Vec<usize> = description.stations.iter().map(|s| s.material).collect();
    assert_eq!(materials.len(), 20_000);
    // 20 000 different ones, each once: which is which depends on the order of the names.
    let mut sorted = materials;
    sorted.sort_unstable();
    assert!(sorted.into_iter().eq(0..20_000));
}
