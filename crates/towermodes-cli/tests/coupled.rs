//! Turbines with rotating rotor, by the program: fast rotors, generators, what is refused.

use crate::program::{root, run, texts};
use std::fs;

use towermodes_testing::{Says, arguments};

const EXAMPLE: &str = "examples/nrel-5mw-turbine.toml";

/// Standard output and standard error.
fn said(arguments: &[&str]) -> [String; 2] {
    texts(&run(arguments))
}

fn json(arguments: &[&str]) -> serde_json::Value {
    let [out, err] = said(&[arguments, &["--format", "json"]].concat());
    serde_json::from_str(&out).unwrap_or_else(|error| panic!("{error}: {err}"))
}

/// The NREL 5 MW turbine reaches the frequencies of its blades at 81.6 rpm, and is not stable at
/// every speed above.
#[test]
fn fast_rotors_are_said_to_be_unstable_or_not_certified() {
    let fast = [
        "campbell", EXAMPLE, "--rpm", "100,115", "--speeds", "5", "--limit", "0.5",
    ];
    let [out, err] = said(&fast);
    out.says("Unstable or not certified at");
    err.says_all("warning: unstable or not certified at & has negative energy from 8");
    let slow = [
        "campbell", EXAMPLE, "--rpm", "6.9,60", "--speeds", "5", "--limit", "0.5",
    ];
    let [out, err] = said(&slow);
    out.says("eigenvalue count proves that no mode below 0.5000 Hz is");
    assert!(!err.contains("negative energy"), "{err}");
}

/// A locked generator holds the rotor against rolling with the nacelle: side-side is slower, and
/// the drivetrain is a mode of 0.6 Hz instead of 1.7 Hz.
#[test]
fn the_generator_is_locked_or_free_as_asked() {
    let first = |state: &str, label: &str| {
        let line = format!("campbell {EXAMPLE} --generator {state} --speeds 2 --limit 2");
        let result = json(&arguments(&line));
        let curves = result["curves"].as_array().expect("curves").clone();
        let curve = curves.into_iter().find(|curve| curve["label"] == label);
        let curve = curve.unwrap_or_else(|| panic!("{label}"));
        curve["points"][0]["frequency_hz"]
            .as_f64()
            .expect("a number")
    };
    let (locked, free) = ("locked", "free");
    assert!((first(locked, "1st tower side-side") - 0.3116).abs() < 1e-4);
    assert!((first(free, "1st tower side-side") - 0.3184).abs() < 1e-4);
    assert!((first(locked, "1st drivetrain torsion") - 0.6314).abs() < 1e-4);
    assert!((first(free, "1st drivetrain torsion") - 1.6851).abs() < 1e-4);
}

#[test]
fn two_blades_are_refused_at_their_line() {
    let text = fs::read_to_string(root().join(EXAMPLE)).expect("the example");
    let text = text.replace("blades = 3", "blades = 2");
    let text = text.replace("[turbine]\n", "[turbine]\nblades = 2\n");
    let path = std::env::temp_dir().join(format!("two-blades-{}.toml", std::process::id()));
    fs::write(&path, text).expect("written");
    let [_, err] = said(&["campbell", path.to_str().expect("text")]);
    fs::remove_file(&path).expect("removed");
    err.says_all("error: a rotor of 2 blades is not supported & blades = 2");
}
