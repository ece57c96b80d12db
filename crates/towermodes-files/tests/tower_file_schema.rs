//! The schema of the tower file against the help of `solve`, the book, and the reader.

use std::path::Path;

use towermodes_files::{description_from_toml, tower_file_schema};

fn text(path: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    std::fs::read_to_string(root.join(path)).expect("a file of the project")
}

/// Whether a key is in a text as a word.
fn names(text: &str, key: &str) -> bool {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(key).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let after = text[at + key.len()..].chars().next();
        !before.is_some_and(is_part) && !after.is_some_and(is_part)
    })
}

#[test]
fn the_help_and_the_book_name_each_key() {
    let help = text("crates/towermodes-cli/src/args/tower-file.txt");
    let book = text("book/src/tower-file.md");
    for table in tower_file_schema() {
        for key in table.keys {
            let is_in_help = names(&help, key.name) || SHORT.contains(&key.name);
            assert!(is_in_help, "the help: {} {}", table.name, key.name);
            assert!(
                names(&book, key.name),
                "the book: {} {}",
                table.name,
                key.name
            );
        }
    }
}

/// Keys that the help describes with a similar one.
const SHORT: [&str; 8] = [
    "azimuth_deg",
    "hydrostatic_height",
    "mooring_height",
    "rotary_inertia_side_side_kg_m",
    "shear_stiffness_side_side_n",
    "xy",
    "xz",
    "yz",
];

#[test]
fn every_required_key_is_missed_by_the_reader() {
    for table in tower_file_schema() {
        let is_plain = table.name.starts_with('[') && !table.name.contains("type");
        if !is_plain || table.keys.iter().all(|key| !key.is_required) {
            continue;
        }
        let text = format!("{}\n", table.name);
        let mistakes = description_from_toml(&text).expect_err("keys are missing");
        for key in table.keys.iter().filter(|key| key.is_required) {
            let missing = format!("{} has no `{}`", table.name, key.name);
            let is_said = mistakes.iter().any(|m| m.message() == missing);
            // The columns of a table of properties are asked for after their heights.
            assert!(is_said || table.name == "[tower.properties]", "{missing}");
        }
    }
}
