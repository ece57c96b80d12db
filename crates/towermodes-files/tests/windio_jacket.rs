//! Jackets of windIO files.

use std::f64::consts::PI;

use towermodes::frame::FrameFoundation;
use towermodes::{Foundation, Options, Tower, solve};
use towermodes_files::{ReadError, ReadOptions, Source, TowerInput, read_windio};
use towermodes_testing::Says;

pub(crate) const FILE: &str = "\
windIO_version: '2.0'
name: jacket
components:
  tower:
    reference_axis: &axis
      z: {grid: [0.0, 1.0], values: [20.0, 87.6]}
    outer_shape:
      outer_diameter: {grid: [0.0, 1.0], values: [6.0, 3.87]}
    structure:
      outfitting_factor: 1.0
      layers:
        - name: wall
          material: steel
          thickness: {grid: [0.0, 1.0], values: [0.027, 0.019]}
  jacket:
    material: steel
    transition_piece_mass: 100e3
    n_bays: 2
    n_legs: 4
    r_foot: 8.0
    r_head: 5.0
    height: 50.0
    leg_diameter: 1.4
    leg_thickness: 0.05
    brace_diameters: [0.8, 0.7]
    brace_thicknesses: [0.02, 0.018]
    bay_spacing: [0.1, 0.5, 0.95]
    x_mb: true
materials:
  - {name: steel, rho: 7850.0, E: 210.0e9, nu: 0.3}
environment:
  water_depth: 30.0
";

fn read(text: String, clamped: bool) -> Result<TowerInput, ReadError> {
    let options = ReadOptions {
        clamped,
        ..ReadOptions::default()
    };
    read_windio(source(text), &options)
}

fn source(text: String) -> Source {
    let name = "turbine.yaml".to_owned();
    Source { name, text }
}

fn input(text: &str) -> TowerInput {
    read(text.to_owned(), false).unwrap_or_else(|error| panic!("{error}"))
}

fn frame(input: &TowerInput) -> &FrameFoundation {
    match &input.description.foundation {
        Foundation::Frame(frame) => frame,
        other => panic!("no jacket: {other:?}"),
    }
}

fn frequencies(input: TowerInput) -> Vec<f64> {
    let tower = Tower::new(input.description).expect("a tower");
    let solution = solve(&tower, &Options::default()).expect("modes");
    let modes = solution.modes.iter();
    modes.map(|mode| mode.frequency_hz).collect()
}

#[test]
fn its_members_have_the_mass_of_their_lengths() {
    let input = input(FILE);
    let described = frame(&input).frame.description();
    // Legs of four joints and a crossing in each face of each bay.
    assert_eq!(described.joints.len(), 4 * 5 + 4 * 2);
    assert_eq!(described.members.len(), 4 * 4 + 2 * 4 * 4 + 4);
    let tube = |d: f64, t: f64| 7850.0 * PI * t * (d - t);
    let radius = |s: f64| 8.0 - 3.0 * s;
    let chord = |s: f64| radius(s) * 2.0_f64.sqrt();
    let leg = (50.0_f64.powi(2) + 3.0_f64.powi(2)).sqrt();
    let diagonal = |a: f64, b: f64| {
        // In the face between two legs: the chords differ, the heights and the slope too.
        let across = 0.5 * (chord(a) + chord(b));
        let inward = (radius(a) - radius(b)) * 0.5_f64.sqrt();
        (across.powi(2) + inward.powi(2) + (50.0 * (b - a)).powi(2)).sqrt()
    };
    let expected = 4.0 * leg * tube(1.4, 0.05)
        + 8.0 * diagonal(0.1, 0.5) * tube(0.8, 0.02)
        + 8.0 * diagonal(0.5, 0.95) * tube(0.7, 0.018)
        + 4.0 * chord(0.1) * tube(0.8, 0.02);
    let found = frame(&input).frame.mass_kg();
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    assert_eq!(frame(&input).platform.mass_kg, 100e3);
}

#[test]
fn a_tower_on_a_symmetric_jacket_has_equal_pairs() {
    for legs in ["n_legs: 3", "n_legs: 4"] {
        let found = frequencies(input(&FILE.replace("n_legs: 4", legs)));
        let clamped = read(FILE.to_owned(), true).expect("the tower");
        let rigid = frequencies(clamped);
        for pair in [0, 2] {
            let difference = (found[pair + 1] / found[pair] - 1.0).abs();
            assert!(difference < 1e-8, "{legs}: {difference:e}");
        }
        assert!(
            found[0] < 0.95 * rigid[0],
            "{legs}: {} {}",
            found[0],
            rigid[0]
        );
    }
}

/// Joints on legs through which no brace goes change nothing, and a stiff jacket is a clamp.
#[test]
fn a_stiff_jacket_clamps_the_tower() {
    let stiff = FILE
        .replace(
            "material: steel\n    transition",
            "material: stiff\n    transition",
        )
        .replace(
            "environment:",
            "  - {name: stiff, rho: 1.0, E: 210.0e15, nu: 0.3}\nenvironment:",
        );
    let found = frequencies(input(&stiff));
    let clamped = frequencies(read(FILE.to_owned(), true).expect("the tower"));
    for (found, clamped) in found.iter().zip(&clamped).take(4) {
        assert!((found / clamped - 1.0).abs() < 1e-5, "{found} {clamped}");
    }
}

/// A change of the file, and the message.
const REFUSED: [(&str, &str, &str); 11] = [
    ("leg_diameter: 1.4", "leg_diamter: 1.4", "`leg_diameter`"),
    ("n_legs: 4", "n_legs: 2", "3 to 100"),
    ("n_bays: 2", "n_bays: 2.5", "whole number"),
    ("r_foot: 8.0", "r_foot: 0.0", "positive"),
    ("height: 50.0", "height: .nan", "height"),
    ("[0.8, 0.7]", "[0.8]", "n_bays"),
    ("[0.02, 0.018]", "[0.5, 0.018]", "half the diameter"),
    ("[0.1, 0.5, 0.95]", "[0.5, 0.1, 0.95]", "rise"),
    ("[0.1, 0.5, 0.95]", "[0.1, 0.5, 1.95]", "rise"),
    ("x_mb: true", "x_mb: maybe", "true or false"),
    (
        "material: steel\n    tr",
        "material: iron\n    tr",
        "`iron`",
    ),
];

#[test]
fn mistakes_are_refused_in_words() {
    for (from, to, words) in REFUSED {
        assert!(FILE.contains(from), "{from}");
        let error = read(FILE.replace(from, to), false).expect_err(to);
        error.says(words);
        error.says("turbine.yaml");
    }
}

#[test]
fn what_is_assumed_is_noted() {
    for (from, to, words) in [
        ("    bay_spacing: [0.1, 0.5, 0.95]\n", "", "no bay_spacing"),
        (
            "water_depth: 30.0",
            "water_depth: 40.0",
            "not on the seabed",
        ),
        (
            "x_mb: true",
            "x_mb: true\n    gravity_foundation_mass: 1e5",
            "gravity foundation",
        ),
        ("name: jacket", "name: jacket", "in air"),
    ] {
        let notes = input(&FILE.replace(from, to)).notes;
        let found = notes.iter().any(|note| note.to_string().contains(words));
        assert!(found, "{words}: {notes:?}");
    }
    let clamped = read(FILE.to_owned(), true).expect("the tower").notes;
    let left_out = clamped.iter().map(ToString::to_string);
    assert!(
        left_out
            .into_iter()
            .any(|note| note.contains("the jacket is left out"))
    );
}

#[test]
fn a_clamp_by_request_is_known() {
    let clamped = read(FILE.to_owned(), true).expect("the tower");
    let tower = Tower::new(clamped.description).expect("a tower");
    let missing = tower.missing_parts().expect("the jacket");
    missing.says("clamped at the tower base by request");
}
