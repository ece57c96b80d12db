//! Studies of designs: what a study says, and every mistake with its line and column.

use crate::sources::source;
use towermodes::{Method, Station, TowerDescription};
use towermodes_files::{
    DesignBand, DesignEach, DesignStudy, ReadError, design_study_schema, read_design_study,
};
use towermodes_testing::{Says, number, rows};

const GOOD: &str = r#"[design]
segments = 40
method = "spectral"
rotary_inertia = false
[design.variables]
"stations[*].wall" = { between = [0.012, 0.060], each = "can", order = "falling", step = 0.001 }
"stations[*].diameter" = { between = [3, 6.5], each = "height", order = "free" }
[design.frequencies]
"fore-aft 1" = { between = "1P-3P", margin = 0.1 }
"side-side 1" = { between = [0.2, 0.3] }
"torsion 1" = { min = 1.5, max = 3 }
[design.limits]
diameter_to_wall = [60, 200]
cone_angle = 3
"#;

fn read(text: &str) -> Result<DesignStudy, ReadError> {
    read_design_study(&source("design.toml", text))
}

/// Line, column, message and hint of the first mistake.
fn first_mistake(error: ReadError, text: &str) -> (usize, usize, String, String) {
    let ReadError::Mistakes { mistakes, .. } = error else {
        panic!("mistakes")
    };
    let first = &mistakes[0];
    let before = &text[..first.span.start];
    let line = 1 + before.matches('\n').count();
    let column = 1 + before.len() - before.rfind('\n').map_or(0, |at| at + 1);
    (
        line,
        column,
        first.message(),
        first.hint.clone().unwrap_or_default(),
    )
}

#[test]
fn a_study_is_what_its_text_says() {
    let study = read(GOOD).expect("a study");
    assert_eq!(study.variables[0].name.value, "stations[*].wall");
    assert_eq!(study.variables[0].between, [0.012, 0.060]);
    assert_eq!(study.variables[0].step, Some(0.001));
    assert_eq!(study.variables[0].each, DesignEach::Can);
    assert!(study.variables[0].is_falling && !study.variables[1].is_falling);
    let bands: Vec<DesignBand> = study.frequencies.iter().map(|of| of.band).collect();
    let expected = [
        DesignBand::Multiples([1, 3], Some(0.1)),
        DesignBand::Hz([0.2, 0.3]),
        DesignBand::Hz([1.5, 3.0]),
    ];
    assert_eq!(bands, expected);
    assert_eq!(study.diameter_to_wall, Some([60.0, 200.0]));
    assert_eq!(study.cone_angle_deg, Some(3.0));
    assert_eq!(study.segments, Some(40));
    assert_eq!(study.method, Some(Method::Spectral));
    assert!(!study.rotary_inertia);
}

#[test]
fn every_mistake_has_its_place() {
    let cases = r#"
        segments = 40 | segmnts = 40 | 2 | 1 | `segmnts` is not a key of [design] | did you mean `segments`?
        [0.012, 0.060] | [0.060, 0.012] | 6 | 34 |  | write { between
        [0.012, 0.060] | [0.060] | 6 | 34 | between has 1 value instead of 2 | write { between
        each = "can" | each = "cam" | 6 | 57 |  | did you mean `can`?
        each = "can",␣ |  | 6 | 58 | `order` has no effect without `each` | add each
        step = 0.001 | step = 0 | 6 | 90 | step is 0, but must be positive |
        "fore-aft 1" | "foreaft 1" | 9 | 1 | `foreaft 1` is not the name of a mode |
        "1P-3P" | "3P-1P" | 9 | 28 |  | write { min
        margin = 0.1 | margin = 10 | 9 | 46 | margin is 10, but must be a fraction |
        { between = [0.2, 0.3] } | { between = [0.2, 0.3], margin = 0.1 } | 10 | 50 | `margin` has no effect | remove it
        { min = 1.5, max = 3 } | { min = 4, max = 3 } | 11 | 23 | min is 4, but must be below max, 3 |
        { min = 1.5, max = 3 } | { } | 11 | 15 | the band of `torsion 1` is missing | write { min
        { min = 1.5, max = 3 } | { mim = 1.5 } | 11 | 17 | `mim` is not a key | did you mean `min`?
        cone_angle = 3 | cone_angle = 90 | 14 | 14 | cone_angle is 90, but must be between |
        "stations[*].diameter" | rna.mass | 7 | 1 | the name `rna.mass` must be in quotation marks | write "rna.mass"
        [60, 200] | 0 | 13 | 20 | diameter_to_wall is 0, but must be positive |
        "#;
    for [old, new, line, column, message, hint] in rows(cases) {
        let line = number(line);
        let column = number(column);
        let text = GOOD.replace(old, new);
        assert_ne!(text, GOOD, "{old}");
        let error = read(&text).expect_err(new);
        let found = first_mistake(error, &text);
        assert_eq!((found.0, found.1), (line, column), "{new}: {found:?}");
        assert!(found.2.contains(message), "{new}: {found:?}");
        assert!(found.3.contains(hint), "{new}: {found:?}");
    }
}

#[test]
fn other_files_are_said_to_be_other_files() {
    for (text, message) in [
        ("", "the file is empty"),
        ("[tower]\n", "a tower file"),
        ("[sweep]\n", "a sweep study"),
        ("[design]\n", "[design] has no `variables`"),
    ] {
        let found = first_mistake(read(text).expect_err("a mistake"), text);
        found.2.says(message);
    }
}

fn tower() -> TowerDescription {
    TowerDescription {
        stations: vec![
            Station::new(0.0, 6.0, 0.030),
            Station::new(40.0, 5.0, 0.030),
            Station::new(40.0, 5.0, 0.020),
            Station::new(80.0, 4.0, 0.020),
        ],
        ..TowerDescription::default()
    }
}

#[test]
fn cans_have_one_wall_and_flanges_one_diameter() {
    let choices = read(GOOD)
        .expect("a study")
        .choices(&tower())
        .expect("choices");
    let names: Vec<&str> = choices
        .variables
        .iter()
        .map(|one| one.change.name())
        .collect();
    let expected = [
        "set(stations[0].wall, stations[1].wall)",
        "set(stations[2].wall, stations[3].wall)",
        "stations[0].diameter",
        "set(stations[1].diameter, stations[2].diameter)",
        "stations[3].diameter",
    ];
    assert_eq!(names, expected);
    let pairs: Vec<String> = choices
        .falling
        .iter()
        .map(|[below, above]| format!("{below} {above}"))
        .collect();
    assert_eq!(pairs, ["stations[0].wall stations[2].wall"]);
}

#[test]
fn names_are_found_in_the_tower() {
    let mistake = |old: &str, new: &str| {
        let text = GOOD.replace(old, new);
        let study = read(&text).expect("a study");
        first_mistake(study.choices(&tower()).expect_err(new), &text)
    };
    let (line, column, message, _) = mistake("\"stations[*].wall\"", "\"stations[*].wal\"");
    assert_eq!((line, column), (6, 1));
    message.says("did you mean `stations[*].wall`?");
    let (line, _, message, _) = mistake(
        "\"stations[*].diameter\" = { between = [3, 6.5], each = \"height\", order = \"free\" }",
        "\"stations[0].wall\" = { between = [0.01, 0.06] }",
    );
    assert_eq!(line, 7);
    message.says("stations[0].wall");
    let (_, _, message, _) = mistake(
        "\"stations[*].diameter\" = { between = [3, 6.5], each = \"height\", order = \"free\" }",
        "\"rna.mass\" = { between = [1, 2], each = \"height\" }",
    );
    message.says("input values of stations");
    let (_, _, message, _) = mistake(
        "\"stations[*].diameter\" = { between = [3, 6.5], each = \"height\", order = \"free\" }",
        "\"scale(rna.mass)\" = { between = [1, 2], step = 0.1 }",
    );
    message.says("`step` has no effect");
}

#[test]
fn every_key_is_in_the_book() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/design.md");
    let page = std::fs::read_to_string(path).expect("the page");
    for table in design_study_schema() {
        for key in table.key_names() {
            let (name, table) = (format!("`{key}`"), table.name);
            let is_there = page.contains(&name) || page.contains(&format!("[design.{key}]"));
            assert!(is_there || key == "design", "{name} of {table}");
        }
    }
}
