//! Files of other programs, written and mended: what changes, what stays, what is refused.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn run(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_towermodes"));
    command.current_dir(root()).args(arguments);
    command.output().expect("the program runs")
}

#[track_caller]
fn done(arguments: &[&str]) -> String {
    let output = run(arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {said}");
    String::from_utf8(output.stdout).expect("text")
}

#[track_caller]
fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&done(arguments)).expect("JSON")
}

/// A folder that is gone when the test is.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("towermodes-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    /// The example deck, its tower file changed.
    fn with_deck(name: &str, change: impl Fn(String) -> String) -> Self {
        let folder = Self::new(name);
        for file in ["ElastoDyn.dat", "Blade.dat", "Tower.dat"] {
            let text = fs::read_to_string(root().join("examples/small-turbine").join(file));
            let text = text.expect("the example");
            let text = if file == "Tower.dat" {
                change(text)
            } else {
                text
            };
            fs::write(folder.0.join(file), text).expect("written");
        }
        folder
    }

    fn path(&self, file: &str) -> String {
        self.0.join(file).display().to_string()
    }

    fn text(&self, file: &str) -> String {
        fs::read_to_string(self.0.join(file)).expect("a file")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_patched_deck_passes_and_only_its_coefficients_changed() {
    for (name, windows) in [("unix", false), ("windows", true)] {
        let folder = Folder::with_deck(name, |text| match windows {
            true => text.replace('\n', "\r\n"),
            false => text,
        });
        let (deck, before) = (folder.path("ElastoDyn.dat"), folder.text("Tower.dat"));
        let judged = run(&["elastodyn", "validate", &deck, "--format", "json"]);
        assert_eq!(judged.status.code(), Some(1));
        let judged: Value = serde_json::from_slice(&judged.stdout).expect("JSON");
        assert_eq!(judged["verdict"], "fail");
        done(&["elastodyn", "patch", &deck, "--backup"]);
        assert_eq!(folder.text("Tower.dat.bak"), before);
        let after = folder.text("Tower.dat");
        assert_eq!(
            after.matches("\r\n").count(),
            before.matches("\r\n").count()
        );
        let others = |text: &str| -> Vec<String> {
            let lines = text.split('\n').filter(|line| !line.contains("Sh("));
            lines.map(str::to_owned).collect()
        };
        assert_eq!(others(&after), others(&before));
        let judged = json(&["elastodyn", "validate", &deck, "--format", "json"]);
        assert_eq!(judged["verdict"], "pass");
        for shape in judged["shapes"].as_array().expect("shapes") {
            assert!((shape["sum"].as_f64().expect("a sum") - 1.0).abs() < 1e-13);
            assert!((shape["rms_ratio"].as_f64().expect("a ratio") - 1.0).abs() < 1e-3);
        }
    }
}

#[test]
fn what_only_looks_changes_nothing() {
    let folder = Folder::with_deck("dry", |text| text);
    let (deck, before) = (folder.path("ElastoDyn.dat"), folder.text("Tower.dat"));
    for option in ["--dry-run", "--diff"] {
        done(&["elastodyn", "patch", &deck, option]);
    }
    assert_eq!(folder.text("Tower.dat"), before);
    assert!(!folder.0.join("Tower.dat.bak").exists());
}

/// OpenFAST refuses coefficients whose sum is farther than 0.0015 from 1; a deck that has them can be judged and mended.
#[test]
fn a_sum_that_openfast_refuses_fails_and_is_mended() {
    let folder = Folder::with_deck("sum", |text| {
        let old = text.lines().find(|line| line.contains("TwFAM1Sh(2)"));
        let old = old.expect("a coefficient").to_owned();
        text.replace(&old, "1.9   TwFAM1Sh(2) - wrong")
    });
    let deck = folder.path("ElastoDyn.dat");
    let judged = run(&["elastodyn", "validate", &deck]);
    assert_eq!(judged.status.code(), Some(1));
    done(&["elastodyn", "patch", &deck]);
    done(&["elastodyn", "validate", &deck]);
}

fn frequencies(file: &str, more: &[&str]) -> Vec<f64> {
    let mut arguments = vec!["solve", file, "--method", "spectral", "--format", "json"];
    arguments.extend(more);
    let modes = json(&arguments);
    let modes = modes["modes"].as_array().expect("modes").iter();
    modes
        .map(|mode| mode["frequency_hz"].as_f64().expect("a number"))
        .collect()
}

#[track_caller]
fn assert_same(a: &[f64], b: &[f64], tolerance: f64) {
    assert_eq!(a.len(), b.len());
    for (a, b) in a.iter().zip(b) {
        assert!((a / b - 1.0).abs() < tolerance, "{a} and {b}");
    }
}

#[test]
fn converted_towers_swing_as_they_did() {
    let folder = Folder::new("convert");
    let tower = "examples/nrel-5mw.toml";
    let original = frequencies(tower, &[]);
    let to = |format: &str, file: &str| {
        let path = folder.path(file);
        done(&["convert", tower, "--to", format, "--output", &path]);
        path
    };
    assert_same(&frequencies(&to("toml", "t.toml"), &[]), &original, 1e-12);
    assert_same(&frequencies(&to("windio", "t.yaml"), &[]), &original, 1e-9);
    // BModes is linear between many rows, and asks for 20 modes.
    let deck = to("bmodes", "t.bmi");
    assert!(folder.0.join("t_sections.dat").exists());
    assert_same(&frequencies(&deck, &["--modes", "8"]), &original, 1e-5);
}

/// ElastoDyn's towers have no torsion, stretch, rotary inertia or machine: what is left comes back to a millionth.
#[test]
fn a_tower_file_has_the_frequencies_of_its_tower() {
    let folder = Folder::new("tower-file");
    let path = folder.path("Tower.dat");
    done(&[
        "elastodyn",
        "tower",
        "examples/nrel-5mw.toml",
        "--output",
        &path,
    ]);
    let bare = ["--no-rna", "--no-rotary-inertia", "--modes", "4"];
    let original = frequencies("examples/nrel-5mw.toml", &bare);
    let read = frequencies(&path, &["--modes", "4"]);
    assert_same(&read, &original, 1e-6);
}

#[test]
fn wanted_damping_is_that_of_the_tower_with_its_machine() {
    let text = done(&[
        "elastodyn",
        "tower",
        "examples/nrel-5mw.toml",
        "--damping",
        "1.0",
    ]);
    let line = text
        .lines()
        .find(|line| line.contains("TwrFADmp(1)"))
        .expect("damping");
    let written: f64 = line
        .split_whitespace()
        .next()
        .expect("a value")
        .parse()
        .expect("a number");
    // ElastoDyn's own frequency of the tower alone over that with the machine, 0.32146 Hz.
    let said = run(&["elastodyn", "tower", "examples/nrel-5mw.toml"]);
    let said = String::from_utf8_lossy(&said.stderr).into_owned();
    let row = said
        .lines()
        .find(|line| line.contains("1st fore-aft"))
        .expect("a row");
    let alone_hz: f64 = row
        .split_whitespace()
        .nth(8)
        .expect("a column")
        .parse()
        .expect("a number");
    assert!(
        (written - alone_hz / 0.321463).abs() < 1e-3,
        "{written} {alone_hz}"
    );
}

#[test]
fn companions_are_never_overwritten() {
    let folder = Folder::new("companion");
    for file in ["nrel-5mw.bmi", "nrel-5mw_sections.dat"] {
        fs::copy(root().join("examples").join(file), folder.0.join(file)).expect("copied");
    }
    let (deck, sections) = (
        folder.path("nrel-5mw.bmi"),
        folder.path("nrel-5mw_sections.dat"),
    );
    for arguments in [
        vec!["solve", &deck, "--output", &sections],
        vec!["convert", &deck, "--to", "toml", "--output", &sections],
        vec!["convert", &deck, "--to", "bmodes", "--output", &deck],
    ] {
        let before = folder.text("nrel-5mw_sections.dat");
        assert_eq!(run(&arguments).status.code(), Some(2), "{arguments:?}");
        assert_eq!(folder.text("nrel-5mw_sections.dat"), before);
    }
}

/// A blade of its own: a beam of two sections that turns.
#[test]
fn a_rotating_blade_is_solved_in_every_format() {
    let folder = Folder::new("blade");
    let deck = done(&[
        "convert",
        "examples/nrel-5mw-table.toml",
        "--to",
        "bmodes",
        "--output",
        &folder.path("b.bmi"),
    ]);
    assert!(deck.is_empty());
    let text = folder.text("b.bmi");
    let text = text.replacen(
        "2                      beam_type",
        "1                      beam_type",
        1,
    );
    let text = text.replacen(
        "0.0                    rot_rpm",
        "6.0                    rot_rpm",
        1,
    );
    fs::write(folder.0.join("b.bmi"), text).expect("written");
    let path = folder.path("b.bmi");
    let blade = json(&["solve", &path, "--format", "json"]);
    let modes = blade["modes"].as_array().expect("modes");
    assert_eq!(modes.len(), 20);
    assert_eq!(modes[0]["family"], "lag");
    // Round sections: ω² in lag is lower than in flap by Ω².
    let hz = |i: usize| modes[i]["frequency_hz"].as_f64().expect("a number");
    let difference = hz(1).powi(2) - hz(0).powi(2);
    assert!((difference - 0.01).abs() < 1e-9, "{difference}");
    assert!(done(&["solve", &path]).contains("6 rpm"));
    assert_eq!(
        done(&["solve", &path, "--format", "csv"]).lines().count(),
        21
    );
    let out = done(&["solve", &path, "--format", "bmodes"]);
    assert!(out.contains("rotating blade frequencies & mode shapes"));
    for arguments in [
        vec!["solve", &path, "--method", "spectral"],
        vec!["solve", &path, "--segments", "10"],
        vec!["compare", &path],
        vec!["convert", &path, "--to", "toml"],
    ] {
        assert_eq!(run(&arguments).status.code(), Some(2), "{arguments:?}");
    }
}
