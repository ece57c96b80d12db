//! Studies of sweeps: what a study says, every mistake with its line and column, and texts that are
//! damaged at random.

use crate::sources::source;
use std::path::Path;

use proptest::prelude::*;
use towermodes::{Family, Method, ModeName};
use towermodes_files::{
    Distribution, ReadError, RotorLock, SamplingKind, SweepModes, SweepRows, SweepStudy, TowerPart,
    ValueKind, description_from_toml, read_sweep_study, read_tower, sweep_study_schema,
};
use towermodes_testing::{Says, rows};

use crate::mutations::{any_mutation, mutated};

const GOOD: &str = r#"[sweep]
base = "tower.toml"
sampling = "sobol"
rows = 1_000
seed = 7
[sweep.vary]
"rna.mass" = { uniform = [3.3e5, 3.7e5] }
"material.youngs_modulus" = { normal = [2.1e11, 3e9], truncated = [2.0e11, 2.2e11] }
"scale(stations[*].wall)" = { normal = [1.0, 0.02] }
"material.density" = { lognormal = [8500, 100] }
"rna.center[2]" = { values = [1.9, 2.0] }
[[sweep.correlation]]
between = ["rna.mass", "material.density"]
score_coefficient = 0.5
[[sweep.correlation]]
between = ["material.density", "material.youngs_modulus"]
score_coefficient = -0.2
[sweep.results]
modes = ["fore-aft 1", "torsion 1"]
segments = 30
method = "spectral"
rotary_inertia = false
inputs = false
[sweep.reading]
no_rna = false
no_gravity = true
rotor = "free"
bmodes_quirks = true
part = "tower"
tower_height = 87.6
tower_base = 10
subset = [1, 2]
"#;

fn read(text: &str) -> Result<SweepStudy, ReadError> {
    read_sweep_study(&source("study.toml", text))
}

#[test]
fn a_study_is_what_its_text_says() {
    let study = read(GOOD).expect("a study");
    assert_eq!(study.base.value, "tower.toml");
    assert_eq!(&GOOD[study.base.span.clone()], "\"tower.toml\"");
    let SweepRows::Sampled {
        sampling, spans, ..
    } = &study.rows
    else {
        panic!("a sampling")
    };
    assert_eq!(sampling.kind, SamplingKind::Sobol);
    assert_eq!(sampling.rows, 1000);
    assert_eq!(sampling.seed, 7);
    let names: Vec<&str> = sampling.vary.iter().map(|one| one.name.as_str()).collect();
    // In the order of the lines, not of the alphabet.
    assert_eq!(
        names,
        [
            "rna.mass",
            "material.youngs_modulus",
            "scale(stations[*].wall)",
            "material.density",
            "rna.center[2]"
        ]
    );
    for (name, span) in names.iter().zip(spans) {
        assert_eq!(GOOD[span.clone()].trim_matches('"'), *name);
    }
    let distributions: Vec<&Distribution> =
        sampling.vary.iter().map(|one| &one.distribution).collect();
    assert_eq!(
        distributions[1],
        &Distribution::Normal {
            mean: 2.1e11,
            deviation: 3e9,
            truncated: Some([2.0e11, 2.2e11])
        }
    );
    assert_eq!(
        distributions[2],
        &Distribution::Normal {
            mean: 1.0,
            deviation: 0.02,
            truncated: None
        }
    );
    assert_eq!(distributions[4], &Distribution::Values(vec![1.9, 2.0]));
    let results = &study.results;
    let torsion = ModeName {
        family: Family::Torsion,
        order: 1,
    };
    assert!(matches!(&results.modes, SweepModes::Named(names) if names[1] == torsion));
    assert_eq!(results.segments, Some(30));
    assert_eq!(results.method, Some(Method::Spectral));
    assert!(!results.rotary_inertia && !results.inputs);
    let reading = study.reading;
    assert_eq!(reading.part, TowerPart::Tower);
    assert_eq!(reading.rotor, RotorLock::Free);
    assert_eq!(reading.hawc2_subset, Some((1, 2)));
    assert!(reading.without_gravity && reading.bmodes_quirks && !reading.without_rna);
    assert_eq!(reading.tower_height_m, Some(87.6));
    assert_eq!(reading.tower_base_m, Some(10.0));
}

#[test]
fn correlations_are_those_of_the_text() {
    let study = read(GOOD).expect("a study");
    let SweepRows::Sampled {
        sampling,
        correlation_spans,
        ..
    } = &study.rows
    else {
        panic!("a sampling")
    };
    let found: Vec<(&str, &str, f64)> = sampling
        .correlations
        .iter()
        .map(|pair| (&*pair.between[0], &*pair.between[1], pair.coefficient))
        .collect();
    let expected = [
        ("rna.mass", "material.density", 0.5),
        ("material.density", "material.youngs_modulus", -0.2),
    ];
    assert_eq!(found, expected);
    assert_eq!(correlation_spans.len(), 2);
    let inline = GOOD.replacen(
        "seed = 7",
        "correlation = [{ between = [\"rna.mass\", \"material.density\"], score_coefficient = 0.5 }]",
        1,
    );
    let inline = inline.split_once("[[sweep.correlation]]").expect("one").0;
    let study = read(inline).expect("a study");
    assert!(
        matches!(&study.rows, SweepRows::Sampled { sampling, .. } if sampling.correlations.len() == 1)
    );
}

#[test]
fn correlations_that_are_wrong() {
    let first = "between = [\"rna.mass\", \"material.density\"]";
    let table = r#"
        between = ["rna.mas", "material.density"] | 12:1 | `rna.mas` is not among the varied inputs (did you mean `rna.mass`?)
        between = "rna.mass" | 13:11 | between must be a list
        between = ["rna.mass"] | 13:11 | between has 1 name instead of 2
        between = ["rna.mass", 3] | 13:24 | must be a text
         | 12:1 | has no `between`
        "#;
    for [to, place, words] in rows(table) {
        refused(first, to, place, words);
    }
    all_refused(
        r#"
        score_coefficient = 0.5 | score_coeficient = 0.5 | 14:1 | did you mean `score_coefficient`?
        score_coefficient = 0.5 | score_coefficient = 1.5 | 12:1 | it must be from -1 to 1
        score_coefficient = 0.5 | score_coefficient = nan | 14:21 | NaN
        score_coefficient = 0.5 | coefficient = 0.5 | 12:1 | `rna.mass` does not have one; give `score_coefficient`
        score_coefficient = 0.5 | score_coefficient = 0.5\ncoefficient = 0.5 | 15:15 | `coefficient` has no effect together with `score_coefficient`
        { normal = [1.0, 0.02] } | { triangular = [0.95, 1.0, 1.05] } | 9:31 | write { normal = [mean, deviation], truncated = [lowest, highest] }
        "material.density", "material.youngs_modulus" | "material.density", "rna.mass" | 15:1 | is given twice
        "#,
    );
    refused(
        first,
        "between = [\"rna.mass\", \"rna.center[2]\"]",
        "12:1",
        "has a list of values",
    );
    refused(
        first,
        "between = [\"rna.mass\", \"rna.mass\"]",
        "12:1",
        "with itself",
    );
    let single = GOOD.replacen("[[sweep.correlation]]", "[sweep.correlation]", 1);
    let single = single.split_once("[[sweep.correlation]]").expect("two").0;
    refused_text(single, "12:1", "in double brackets, once for each pair");
    let grid = "[sweep]\nbase = \"t.toml\"\nsampling = \"grid\"\n[sweep.vary]\n\
                \"rna.mass\" = { uniform = [1, 2], levels = 5 }\n\
                \"rna.center[2]\" = { uniform = [1, 2], levels = 3 }\n\
                [[sweep.correlation]]\nbetween = [\"rna.mass\", \"rna.center[2]\"]\ncoefficient = 0.5\n";
    refused_text(grid, "7:1", "a grid has every combination of its values");
    let table =
        "[sweep]\nbase = \"t.toml\"\ntable = \"values.csv\"\n[[sweep.correlation]]\nbetween = []\n";
    refused_text(
        table,
        "4:1",
        "`correlation` has no effect together with `table`",
    );
}

#[test]
fn tables_and_grids() {
    let study = read("[sweep]\nbase = \"t.toml\"\ntable = \"values.csv\"\n").expect("a study");
    assert!(matches!(study.rows, SweepRows::Table(path) if path.value == "values.csv"));
    let grid = "[sweep]\nbase = \"t.toml\"\nsampling = \"grid\"\n[sweep.vary]\n\
                \"rna.mass\" = { uniform = [1, 2], levels = 5 }\n\"rna.center[2]\" = { values = [1, 2, 3] }\n";
    let SweepRows::Sampled { sampling, .. } = read(grid).expect("a study").rows else {
        panic!("a sampling")
    };
    assert_eq!((sampling.rows, sampling.vary[0].levels), (15, Some(5)));
}

/// Replaces `from` by `to` and expects the first mistake at line:column with these words in its
/// message and hint.
#[track_caller]
fn refused(from: &str, to: &str, place: &str, words: &str) {
    assert!(GOOD.contains(from), "the test is wrong: {from}");
    refused_text(&GOOD.replacen(from, to, 1), place, words);
}

/// Mistakes one after the other: what is replaced, by what, place, words.
fn all_refused(table: &str) {
    for [from, to, place, words] in rows(table) {
        refused(from, to, place, words);
    }
}

#[track_caller]
fn refused_text(text: &str, place: &str, words: &str) {
    let error = read(text).expect_err("this is no study").to_string();
    let first = error.lines().next().unwrap_or_default();
    let at = format!("study.toml:{place}: ");
    assert!(first.starts_with(&at), "{first}");
    first.says(words);
}

#[test]
fn keys_and_types() {
    all_refused(
        r#"
        base = | bse = | 2:1 | did you mean `base`?
        base = "tower.toml"\n |  | 1:1 | [sweep] has no `base`
        "tower.toml" | "" | 2:8 | the path `base` is missing
        "tower.toml" | 3 | 2:8 | base must be a text
        "sobol" | "soboll" | 3:12 | did you mean `sobol`?
        "sobol" | "monte carlo" | 3:12 | grid, latin-hypercube, random, sobol
        sampling = "sobol"\n |  | 1:1 | has no `sampling`
        segments = 30 | segments = 0 | 20:12 | at least 1
        segments = 30 | segments = 1e9 | 20:12 | at most 2000000
        "spectral" | "spectrl" | 21:10 | did you mean `spectral`?
        inputs = false | inputs = 0 | 23:10 | inputs must be true or false
        part = "tower" | part = "nacelle" | 29:8 | there is no part `nacelle`
        [1, 2] | [1] | 32:10 | subset has 1 value instead of 2
        [sweep.reading] | [sweep.readin] | 24:8 | did you mean `reading`?
        [sweep] | [swep] | 1:2 | did you mean `sweep`?
        "#,
    );
}

#[test]
fn rows_and_seeds() {
    all_refused(
        r#"
        1_000 | 0 | 4:8 | rows is 0, but must be a whole number, at least 1
        1_000 | 1.5 | 4:8 | rows is 1.5
        1_000 | 1e10 | 4:8 | it must be from 1 to 4294967296
        1_000 | "many" | 4:8 | rows must be a number, found a text
        rows = 1_000\n |  | 1:1 | has no `rows`
        seed = 7 | seed = -1 | 5:8 | at least 0
        sampling = "sobol" | table = "t.csv" | 4:8 | `rows` has no effect together with `table`
        seed = 7 | table = "t.csv" | 5:9 | `table` has no effect together with `sampling`
        "#,
    );
}

#[test]
fn distributions() {
    let uniform = "{ uniform = [3.3e5, 3.7e5] }";
    let table = r#"
        3.5e5 | 7:14 | must be a distribution in braces, found a number
        [3.3e5, 3.7e5] | 7:14 | { uniform = [lowest, highest] }
        { unifrm = [1, 2] } | 7:16 | did you mean `uniform`?
        { } | 7:14 | the distribution of `rna.mass` is missing
        { uniform = [1, 2], values = [1] } | 7:43 | `values` has no effect together with `uniform`
        "#;
    for [to, place, words] in rows(table) {
        refused(uniform, to, place, words);
    }
    all_refused(
        r#"
        [3.3e5, 3.7e5] | [3.7e5, 3.3e5] | 7:26 | is not below the upper limit
        [3.3e5, 3.7e5] | [3.3e5] | 7:26 | uniform has 1 value instead of 2
        [3.3e5, 3.7e5] | [3.3e5, "x"] | 7:34 | uniform must be a number, found a text
        [3.3e5, 3.7e5] | [nan, 1] | 7:27 | uniform is NaN
        [2.1e11, 3e9] | [2.1e11, -1] | 8:40 | the standard deviation is -1
        [2.0e11, 2.2e11] | [2, 1] | 8:67 | the lower limit 2 is not below the upper limit 1
        [8500, 100] | [-1, 100] | 10:36 | the mean of a lognormal distribution is -1
        [1.9, 2.0] | [] | 11:30 | the list of values is empty
        "#,
    );
    refused(
        uniform,
        "{ uniform = [1, 2], levels = 3 }",
        "7:43",
        "without sampling = \"grid\"",
    );
    refused(
        uniform,
        "{ uniform = [1, 2], truncated = [1, 2] }",
        "7:46",
        "`truncated` has no effect",
    );
    let from = "\"rna.mass\" =";
    refused(from, "rna.mass =", "7:1", "\"rna.mass\" = { ... }");
}

#[test]
fn modes() {
    let names = "[\"fore-aft 1\", \"torsion 1\"]";
    let table = r#"
        0 | modes is 0
        "fore-aft 1" | modes must be a number or a list of names
        [] | modes has 0 values instead of one or more
        "#;
    for [to, words] in rows(table) {
        refused(names, to, "19:9", words);
    }
    all_refused(
        r#"
        "torsion 1" | "twist 1" | 19:24 | is not the name of a mode
        "torsion 1" | "fore-aft 1" | 19:24 | the mode `fore-aft 1` occurs 2 times
        "#,
    );
}

#[test]
fn other_files() {
    refused_text("", "1:1", "the file is empty");
    let words = "a tower file, not a sweep study";
    refused_text("[tower]\nstations = []\n", "1:1", words);
    refused_text("[sweep\n", "1:7", "invalid TOML");
    let study = description_from_toml(GOOD).expect_err("no tower");
    study[0].says("towermodes sweep FILE");
}

#[test]
fn grids() {
    let grid =
        |vary: &str| format!("[sweep]\nbase = \"t\"\nsampling = \"grid\"\n[sweep.vary]\n{vary}\n");
    let table = r#"
        a = { normal = [1, 2] } | 5:1 | `a` is normal, which cannot be used in a grid
        a = { uniform = [1, 2] } | 5:1 | `a` is uniform without levels
        a = { uniform = [1, 2], levels = 1 } | 5:34 | at least 2
        "#;
    for [vary, place, words] in rows(table) {
        refused_text(&grid(vary), place, words);
    }
    let large =
        "a = { uniform = [1, 2], levels = 100_000 }\nb = { uniform = [1, 2], levels = 100_000 }";
    refused_text(&grid(large), "4:1", "reduce the levels");
    let more = grid("a = { values = [1, 2] }").replace("[sweep.vary]", "rows = 3\n[sweep.vary]");
    refused_text(&more, "4:8", "the grid has 2");
}

#[test]
fn names_are_found_in_the_base() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/nrel-5mw.toml");
    let base = read_tower(path).expect("a tower").input.description;
    let changes = |text: &str| read(text).expect("a study").changes(&base);
    let good = changes(GOOD).expect("names of the tower");
    assert_eq!(good[2].name(), "scale(stations[*].wall)");
    let wrong = GOOD.replace("\"rna.mass\"", "\"rna.mas\"");
    let error = changes(&wrong).expect_err("no such number").to_string();
    error.begins("study.toml:7:1: unknown input name `rna.mas`");
    error.says("did you mean `rna.mass`?");
    let twice = GOOD.replace("\"rna.center[2]\"", "\"set(rna.mass)\"");
    let error = changes(&twice).expect_err("set twice").to_string();
    error.begins("study.toml:11:1: ");
}

/// A reader that forgets a key would accept the file, and the key would have no effect.
#[test]
fn every_key_is_read() {
    const DATE: &str = "1979-05-27";
    for table in sweep_study_schema() {
        for key in table.keys {
            let line = format!("{} = {DATE}", key.name);
            let least = "[sweep]\nbase = \"t\"\ntable = \"v.csv\"\n";
            let sampled = "[sweep]\nbase = \"t\"\nsampling = \"random\"\nrows = 1\n";
            let text = match table.name {
                "the file" => line,
                "[sweep]" if key.name == "base" => format!("[sweep]\n{line}\n"),
                "[sweep]" if ["rows", "seed", "vary"].contains(&key.name) => {
                    sampled.replace("rows = 1\n", "") + &line
                }
                "[sweep]" if key.name == "correlation" => sampled.to_owned() + &line,
                "[[sweep.correlation]]" => format!("{sampled}{}\n{line}\n", table.name),
                "[sweep]" if ["table", "sampling"].contains(&key.name) => {
                    format!("[sweep]\nbase = \"t\"\n{line}\n")
                }
                "[sweep.vary]" => {
                    let beside = match key.name {
                        "truncated" => "normal = [1, 2], ",
                        "levels" => "uniform = [1, 2], ",
                        _ => "",
                    };
                    let kind = if key.name == "levels" {
                        "grid"
                    } else {
                        "random"
                    };
                    let sampled = sampled.replace("random", kind);
                    format!("{sampled}vary.a = {{ {beside}{line} }}\n")
                }
                _ => format!("{least}{}\n{line}\n", table.name.replace("[sweep]", "")),
            };
            let error = read(&text).expect_err("a date is no value");
            let ReadError::Mistakes { mistakes, .. } = error else {
                panic!("{text}")
            };
            let date = text.find(DATE).expect("the value");
            let is_said = mistakes.iter().any(|mistake| mistake.span.start == date);
            assert!(is_said, "{text}: {mistakes:?}");
            assert!(key.kind != ValueKind::Rows);
        }
    }
}

#[test]
fn the_book_names_each_key() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/sweeps.md");
    let page = std::fs::read_to_string(path).expect("the page");
    for table in sweep_study_schema() {
        for key in table.keys {
            let name = match table.name {
                "the file" => format!("[{}]", key.name),
                _ => format!("`{}`", key.name),
            };
            assert!(page.contains(&name), "{} {name}", table.name);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 10_000, ..ProptestConfig::default() })]

    #[test]
    fn damaged_studies_are_read_or_refused(
        mutations in prop::collection::vec(any_mutation(), 1..4),
    ) {
        let mut text = GOOD.to_owned();
        for mutation in &mutations {
            text = mutated(&text, mutation);
        }
        match read(&text) {
            Ok(study) => {
                if let SweepRows::Sampled {
        sampling, spans, ..
    } = &study.rows {
                    prop_assert!(sampling.check().is_ok());
                    prop_assert_eq!(sampling.vary.len(), spans.len());
                    prop_assert!(sampling.vary.iter().all(|one| one.distribution.check().is_ok()));
                }
            }
            Err(ReadError::Mistakes { mistakes, .. }) => {
                prop_assert!(!mistakes.is_empty());
                for mistake in mistakes {
                    prop_assert!(mistake.span.start <= mistake.span.end && mistake.span.end <= text.len());
                    prop_assert!(!mistake.message().is_empty());
                }
            }
            Err(error) => prop_assert!(false, "{error}"),
        }
    }
}
