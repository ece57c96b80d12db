//! The schema of the tower file against the help of `solve`, the book, and the reader.

use std::path::Path;

use towermodes_files::{
    KeySchema, TableSchema, ValueKind, description_from_toml, tower_file_schema,
};

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

/// A file with one table: its required keys, and one key whose value has a type that no key has, a
/// date.
fn file_with_a_date(table: &TableSchema, key: &str) -> String {
    // [tower] requires stations or properties.
    let is_required = |k: &KeySchema| k.is_required || k.name == "stations";
    let required = table.keys.iter();
    let required = required.filter(|k| is_required(k) && k.name != key);
    let mut lines: Vec<String> = required.map(example).collect();
    lines.push(format!("{key} = {DATE}"));
    match table.name.split_once(" of type ") {
        Some((head, name)) if key != "type" => {
            lines.retain(|line| !line.starts_with("type"));
            format!("{head}\ntype = {name}\n{}\n", lines.join("\n"))
        }
        Some((head, _)) => format!("{head}\n{}\n", lines.join("\n")),
        None if table.name == "the file" => lines.join("\n"),
        None if table.name == "inertia" => {
            format!("[rna]\nmass = 1\ninertia = {{ {} }}\n", lines.join(", "))
        }
        None if table.name == "[tower]" => {
            format!("[tower]\n{}\n[material]\n{STEEL}", lines.join("\n"))
        }
        None => format!("{}\n{}\n", table.name, lines.join("\n")),
    }
}

/// A key with a value of its type.
fn example(key: &KeySchema) -> String {
    let value = match key.kind {
        ValueKind::Number | ValueKind::Any => "1.0",
        ValueKind::Flag => "true",
        ValueKind::Text => "\"steel\"",
        ValueKind::Numbers => "[1.0, 2.0]",
        ValueKind::Rows => "[[0, 6, 0.03], [80, 4, 0.02]]",
        ValueKind::Table => "{ stations = [[0, 6, 0.03], [80, 4, 0.02]] }",
        ValueKind::Matrix => &format!("[{}]", ["[1, 0, 0, 0, 0, 0]"; 6].join(", ")),
    };
    format!("{} = {value}", key.name)
}

const STEEL: &str = "density = 7850\nyoungs_modulus = 2.1e11\nshear_modulus = 8e10\n";

const DATE: &str = "1979-05-27";

/// A reader that forgets a key would accept the file, and the key would have no effect.
#[test]
fn every_key_is_read() {
    let mut forgotten = Vec::new();
    for table in tower_file_schema() {
        for key in table.keys {
            let text = file_with_a_date(table, key.name);
            let date = text.find(DATE).expect("the value");
            let mistakes = description_from_toml(&text).expect_err("a date is no value");
            if !mistakes.iter().any(|mistake| mistake.span.start == date) {
                forgotten.push(text);
            }
        }
    }
    assert!(forgotten.is_empty(), "{}", forgotten.join("\n"));
}
