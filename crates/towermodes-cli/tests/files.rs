//! Files of other programs, written and mended: what changes, what stays, what is refused.

use crate::program::{Folder, blade, done, json, root, run};
use std::fs;

use serde_json::Value;
use towermodes_testing::{Close, Says, arguments};

impl Folder {
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
        let expected = before.matches("\r\n").count();
        assert_eq!(after.matches("\r\n").count(), expected);
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

/// OpenFAST refuses coefficients whose sum is farther than 0.0015 from 1; a deck that has them can
/// be judged and mended.
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

/// ElastoDyn's towers have no torsion, stretch, rotary inertia or machine: what is left comes back
/// to a millionth.
#[test]
fn a_tower_file_has_the_frequencies_of_its_tower() {
    let folder = Folder::new("tower-file");
    let path = folder.path("Tower.dat");
    done(&arguments(&format!(
        "elastodyn tower examples/nrel-5mw.toml --output {path}"
    )));
    let bare = ["--no-rna", "--no-rotary-inertia", "--modes", "4"];
    let original = frequencies("examples/nrel-5mw.toml", &bare);
    let read = frequencies(&path, &["--modes", "4"]);
    assert_same(&read, &original, 1e-6);
}

#[test]
fn wanted_damping_is_that_of_the_tower_with_its_machine() {
    let text = done(&arguments(
        "elastodyn tower examples/nrel-5mw.toml --damping 1.0",
    ));
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
    written.within(alone_hz / 0.321463, 1e-3);
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
    let path = blade(&folder);
    let solved = json(&["solve", &path, "--format", "json"]);
    let modes = solved["modes"].as_array().expect("modes");
    assert_eq!(modes.len(), 20);
    assert_eq!(modes[0]["family"], "lag");
    // Round sections: ω² in lag is lower than in flap by Ω².
    let hz = |i: usize| modes[i]["frequency_hz"].as_f64().expect("a number");
    let difference = hz(1).powi(2) - hz(0).powi(2);
    assert!((difference - 0.01).abs() < 1e-9, "{difference}");
    done(&["solve", &path]).says("6 rpm");
    assert_eq!(
        done(&["solve", &path, "--format", "csv"]).lines().count(),
        21
    );
    let drawn = done(&["solve", &path, "--plot"]);
    drawn.says_all("1st flap & 1st lag & 87.6 m ┤");
    done(&["solve", &path, "--format", "bmodes"]).says("rotating blade frequencies & mode shapes");
    for arguments in [
        vec!["solve", &path, "--method", "spectral"],
        vec!["solve", &path, "--segments", "10"],
        vec!["compare", &path],
        vec!["plot", &path],
        vec!["solve", &path, "--plot", "--format", "bmodes"],
        vec!["convert", &path, "--to", "toml"],
    ] {
        assert_eq!(run(&arguments).status.code(), Some(2), "{arguments:?}");
    }
}

/// Modes of another tower are none of a deck's: one that is shorter, and one that is softer.
#[test]
fn modes_of_another_tower_are_refused() {
    let folder = Folder::with_deck("other", |text| text);
    let (deck, before) = (folder.path("ElastoDyn.dat"), folder.text("Tower.dat"));
    for (other, words) in [
        ("examples/guyed.toml", "its height is 40.000 m"),
        ("examples/nrel-5mw.toml", "its mass differs by"),
    ] {
        for command in ["patch", "validate"] {
            let output = run(&["elastodyn", command, &deck, "--from", other]);
            assert_eq!(output.status.code(), Some(1), "{command} {other}");
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            said.says(words);
        }
    }
    assert_eq!(folder.text("Tower.dat"), before);
    // Its own file, at another height: the machine is missing there, the tower is the same.
    let own = folder.path("Tower.dat");
    let raised = ["--tower-height", "98", "--tower-base", "20"];
    let mut arguments = vec!["elastodyn", "patch", &deck, "--from", &own];
    arguments.extend(raised);
    done(&arguments);
}

#[test]
fn every_backup_is_kept() {
    let folder = Folder::with_deck("backups", |text| text);
    let (deck, first) = (folder.path("ElastoDyn.dat"), folder.text("Tower.dat"));
    done(&["elastodyn", "patch", &deck, "--backup"]);
    let second = folder
        .text("Tower.dat")
        .replace("1.0   AdjTwMa", "0.9   AdjTwMa");
    fs::write(folder.0.join("Tower.dat"), &second).expect("written");
    done(&["elastodyn", "patch", &deck, "--backup"]);
    assert_eq!(folder.text("Tower.dat.bak"), first);
    assert_eq!(folder.text("Tower.dat.bak2"), second);
    let left = fs::read_dir(&folder.0)
        .expect("the folder")
        .filter_map(Result::ok);
    let names = left.map(|entry| entry.file_name().to_string_lossy().into_owned());
    assert!(names.into_iter().all(|name| !name.ends_with(".tmp")));
}

/// Degrees and umlauts of older programs: one byte each, and so they stay.
#[test]
fn a_deck_in_latin1_is_read_and_keeps_its_bytes() {
    let folder = Folder::with_deck("latin1", |text| text);
    let path = folder.0.join("Tower.dat");
    let text = folder
        .text("Tower.dat")
        .replacen("Number of input", "f#r Number of input", 1);
    let bytes: Vec<u8> = text
        .bytes()
        .map(|b| if b == b'#' { 0xfc } else { b })
        .collect();
    fs::write(&path, bytes).expect("written");
    let deck = folder.path("ElastoDyn.dat");
    done(&["elastodyn", "patch", &deck]);
    let after = fs::read(&path).expect("read");
    assert_eq!(after.iter().filter(|byte| **byte == 0xfc).count(), 1);
    done(&["elastodyn", "validate", &deck]);
}

#[test]
fn options_that_mean_nothing_to_a_file_are_refused() {
    let toml = "examples/nrel-5mw.toml";
    for (file, option, value) in [
        (toml, "--tower-height", "50"),
        (toml, "--tower-base", "3"),
        (toml, "--subset", "1,2"),
        (toml, "--part", "tower"),
        ("examples/nrel-5mw.yaml", "--tower-base", "3"),
        (
            "examples/small-turbine/ElastoDyn.dat",
            "--tower-height",
            "50",
        ),
    ] {
        let output = run(&["solve", file, option, value]);
        assert_eq!(output.status.code(), Some(2), "{file} {option}");
        String::from_utf8_lossy(&output.stderr).says(option);
    }
    let found = run(&["solve", toml, "--bmodes-quirks"]).status.code();
    assert_eq!(found, Some(2));
    let openfast = ["elastodyn", "tower", toml, "--openfast", "99"];
    assert_eq!(run(&openfast).status.code(), Some(2));
}

/// OpenFAST lists concentrated masses since 4.2; FAST 8 is older, whatever its number.
#[test]
fn masses_are_listed_for_those_who_read_lists() {
    let listed = |version: &str| {
        let arguments = [
            "elastodyn",
            "tower",
            "examples/monopile.toml",
            "--openfast",
            version,
        ];
        done(&arguments).contains("NTwCMass")
    };
    assert!(listed("4.2") && listed("5.0") && listed("v4.10"));
    assert!(!listed("4.1") && !listed("3") && !listed("8.16"));
}

/// A tower of which the other file has a hundredth is not the same tower.
#[test]
fn a_stub_does_not_agree_with_its_tower() {
    let folder = Folder::new("stub");
    let text = |stations: &str| {
        format!(
            "[material]\ndensity = 7850.0\nyoungs_modulus = 2.1e11\npoissons_ratio = 0.3\n[tower]\nstations = {stations}\n"
        )
    };
    let (whole, stub) = (folder.path("whole.toml"), folder.path("stub.toml"));
    fs::write(&whole, text("[[0, 6.0, 0.035], [100, 4.0, 0.02]]")).expect("written");
    fs::write(&stub, text("[[0, 6.0, 0.035], [1, 5.98, 0.03485]]")).expect("written");
    let checked = run(&["check", &whole, &stub]);
    assert_eq!(checked.status.code(), Some(1));
    done(&["check", &whole, &whole]);
}

/// R is the radius with the draft: the flexible tower may be all of it, whatever the height of its
/// base.
#[test]
fn deflections_are_divided_by_the_length_of_the_deck() {
    let folder = Folder::new("draft");
    done(&[
        "convert",
        "examples/floating.toml",
        "--to",
        "bmodes",
        "--output",
        &folder.path("f.bmi"),
    ]);
    let out = done(&["solve", &folder.path("f.bmi"), "--format", "bmodes"]);
    // ∫ slope d(span) is what the deflection rises by, where the span is measured in R.
    let mut rows: Vec<[f64; 2]> = Vec::new();
    let mode = out.split("Mode No.").find(|mode| {
        let numbers = |line: &str| -> Vec<f64> {
            line.split_whitespace()
                .filter_map(|n| n.parse().ok())
                .collect()
        };
        rows = mode
            .lines()
            .map(numbers)
            .filter(|n| n.len() == 6)
            .map(|n| [n[3], n[4]])
            .collect();
        rows.first().is_some_and(|first| first[1].abs() > 1e-3)
    });
    assert!(mode.is_some());
    let step = 1.0 / (rows.len() - 1) as f64;
    let rise: f64 = rows
        .windows(2)
        .map(|pair| 0.5 * step * (pair[0][1] + pair[1][1]))
        .sum();
    let risen = rows[rows.len() - 1][0] - rows[0][0];
    assert!((rise / risen - 1.0).abs() < 2e-3, "{rise} {risen}");
}

/// A tube whose lower part is free to turn in a pin: two elements between a held joint and the
/// interface.
fn two_tubes(reactions: &str, pin: &str) -> String {
    format!(
        "------- SubDyn -------\ntwo tubes\n------- FEA -------\n3 FEMMod - model\n1 NDiv - parts\n0 Nmodes - modes\n\
         ---- STRUCTURE JOINTS ----\n3 NJoints\nJointID JointXss JointYss JointZss JointType JointDirX JointDirY JointDirZ JointStiff\n(-) (m)\n\
         1 0 0 -20 1 0 0 0 0\n2 0 0 -10 {pin} 0\n3 0 0 0 1 0 0 0 0\n\
         ---- BASE REACTION JOINTS ----\n1 NReact\nRJointID\n(-)\n{reactions}\n\
         ---- INTERFACE JOINTS ----\n1 NInterf\nIJointID\n(-)\n3 1 1 1 1 1 1\n\
         ---------- MEMBERS ----------\n2 NMembers\nMemberID MJointID1 MJointID2 MPropSetID1 MPropSetID2 MType\n(-)\n\
         1 1 2 1 1 1c\n2 2 3 1 1 1c\n\
         ---- CIRCULAR BEAM CROSS-SECTION PROPERTIES ----\n1 NPropSets\nPropSetID YoungE ShearG MatDens XsecD XsecT\n(-)\n\
         1 2.1e11 8.08e10 7850 2 0.03\n---- OUTPUT ----\nEND\n"
    )
}

/// A held tube of two elements with a held interface has six modes: all of them are the result, and
/// eight that are asked for are refused.
#[test]
fn a_small_frame_has_the_modes_that_there_are() {
    let folder = Folder::new("small-frame");
    folder.write("SubDyn.dat", &two_tubes("1 1 1 1 1 1 1", "1 0 0 0"));
    let file = folder.path("SubDyn.dat");
    let solve = ["solve", &file, "--method", "subdyn", "--clamped"];
    let result = json(&[&solve[..], &["--format", "json"]].concat());
    assert_eq!(result["modes"].as_array().expect("modes").len(), 6);
    let refused = run(&[&solve[..], &["--modes", "8"]].concat());
    assert_eq!(refused.status.code(), Some(2));
    String::from_utf8_lossy(&refused.stderr).says("8 modes are requested; the frame has 6");
}

/// The spring carries a joint without mass, so only the six modes of the other joint are finite.
#[test]
fn a_joint_without_mass_leaves_the_modes_that_there_are() {
    let folder = Folder::new("without-mass");
    let spring = "---- SPRING ELEMENT PROPERTIES ----\n1 NSpringPropSets\nPropSetID k11\n(-)\n\
                  1 1e8 0 0 0 0 0 1e8 0 0 0 0 1e8 0 0 0 1e9 0 0 1e9 0 1e9\n---- OUTPUT";
    let text = two_tubes("1 1 1 1 1 1 1", "1 0 0 0");
    let text = text
        .replace("2 2 3 1 1 1c", "2 2 3 1 1 5")
        .replace("---- OUTPUT", spring);
    folder.write("SubDyn.dat", &text);
    let file = folder.path("SubDyn.dat");
    let solve = ["solve", &file, "--method", "subdyn"];
    let solved = run(&[&solve[..], &["--format", "json"]].concat());
    String::from_utf8_lossy(&solved.stderr)
        .says("note: the frame has only 6 modes that can be resolved: the others have no mass");
    let result: Value = serde_json::from_slice(&solved.stdout).expect("JSON");
    assert_eq!(result["modes"].as_array().expect("modes").len(), 6);
    let refused = run(&[&solve[..], &["--modes", "8"]].concat());
    assert_eq!(refused.status.code(), Some(2));
    String::from_utf8_lossy(&refused.stderr)
        .says("8 modes are requested, but the frame has only 6 that can be resolved");
}

/// The pin makes a mechanism while the interface is free.
#[test]
fn a_mechanism_under_a_free_interface_has_a_warning() {
    let folder = Folder::new("mechanism");
    folder.write("SubDyn.dat", &two_tubes("1 1 1 1 1 1 1", "3 0 1 0"));
    let file = folder.path("SubDyn.dat");
    let solved = run(&["solve", &file, "--format", "json"]);
    let said = String::from_utf8_lossy(&solved.stderr);
    said.says("warning: the frame is a mechanism: 1 motion has no stiffness");
    said.says("; --clamped fixes the interface joints");
    let result: Value = serde_json::from_slice(&solved.stdout).expect("JSON");
    assert_eq!(result["modes"][0]["frequency_hz"], 0.0);
    let held = run(&["solve", &file, "--clamped"]);
    assert!(!String::from_utf8_lossy(&held.stderr).contains("is a mechanism"));
}
