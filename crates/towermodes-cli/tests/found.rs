//! The towers that `design` and `calibrate` write: what changes in the text, and what its solution
//! is.

use crate::program::{json, root};
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::sandbox::Sandbox;

/// Runs a command with a study in a file and writes the tower; returns the result, and the lines of
/// the tower file before and after.
fn found(command: &str, tower: &str, study: &str) -> (Value, Vec<String>, Sandbox) {
    let folder = Sandbox::new(&format!("found-{command}"));
    let path = |name: &str| folder.path().join(name).display().to_string();
    fs::write(path("study.toml"), study).expect("written");
    let words = [command, tower, &path("study.toml"), "--output"];
    let result = json(&[&words[..], &[&path("found.toml"), "--format", "json"]].concat());
    let lines = |path: &Path| {
        let text = fs::read_to_string(path).expect("the tower");
        text.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let (before, after) = (
        lines(&root().join(tower)),
        lines(Path::new(&path("found.toml"))),
    );
    assert_eq!(before.len(), after.len());
    let pairs = before.into_iter().zip(after);
    let changed = pairs.filter(|(before, after)| before != after);
    let changed = changed.map(|(before, after)| {
        let comment = |line: &str| line.split_once('#').map(|(_, text)| text.trim().to_owned());
        assert_eq!(comment(&before), comment(&after));
        before
    });
    (result, changed.collect(), folder)
}

/// The frequency of a mode of the tower that was written.
fn solved_hz(folder: &Sandbox, label: &str) -> f64 {
    let path = folder.path().join("found.toml").display().to_string();
    let solved = json(&["solve", &path, "--format", "json"]);
    let modes = solved["modes"].as_array().expect("modes");
    let mode = modes.iter().find(|mode| mode["label"] == label);
    let hz = mode.map(|mode| &mode["extrapolated_hz"]);
    hz.and_then(Value::as_f64).expect(label)
}

const LABELS: [(&str, &str); 3] = [
    ("fore-aft 1", "1st fore-aft bending"),
    ("fore-aft 2", "2nd fore-aft bending"),
    ("side-side 1", "1st side-side bending"),
];

#[track_caller]
fn assert_frequencies(result: &Value, (list, key): (&str, &str), folder: &Sandbox) {
    let frequencies = result[list].as_array().expect("a list");
    for one in frequencies {
        let mode = one["mode"].as_str().expect("a name");
        let label = LABELS.iter().find(|(name, _)| *name == mode);
        let hz = solved_hz(folder, label.expect("a known mode").1);
        let stated = one[key].as_f64().expect("a number");
        // The numbers in the file have eight digits.
        assert!((hz / stated - 1.0).abs() < 1e-7, "{mode}: {hz} {stated}");
    }
}

#[test]
fn the_calibrated_tower_has_the_fitted_frequencies_and_its_comments() {
    let study = r#"
        [calibrate.unknowns]
        "scale(soil[0].rows[*].x, soil[0].rows[*].y)" = { bounds = [0.1, 10.0] }
        "rna.mass" = { prior = [350e3, 5e3] }
        [[measured]]
        mode = "fore-aft 1"
        frequency = 0.1860
        deviation = 0.0005
        [[measured]]
        mode = "fore-aft 2"
        frequency = 0.905
        deviation = 0.005
    "#;
    let (result, changed, folder) = found("calibrate", "examples/monopile.toml", study);
    assert_frequencies(&result, ("measured", "fitted_hz"), &folder);
    let of_mass = changed
        .iter()
        .filter(|line| line.starts_with("mass = 350e3"));
    assert_eq!(of_mass.count(), 1, "{changed:?}");
    // The others are rows of the soil.
    let others = changed.iter().filter(|line| !line.starts_with("mass"));
    assert!(others.clone().count() > 1, "{changed:?}");
    for line in others {
        assert!(line.trim_start().starts_with('['), "{line}");
    }
}

#[test]
fn the_designed_tower_has_the_frequencies_of_the_result_and_its_comments() {
    let study = r#"
        [design.variables]
        "stations[0].wall" = { between = [0.012, 0.060] }
        [design.frequencies]
        "side-side 1" = { min = 0.31 }
    "#;
    let (result, changed, folder) = found("design", "examples/nrel-5mw.toml", study);
    assert_frequencies(&result, ("frequencies", "after_hz"), &folder);
    assert_eq!(changed.len(), 1, "{changed:?}");
}
