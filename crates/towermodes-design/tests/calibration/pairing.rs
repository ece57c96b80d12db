//! Measurements without a name find their mode by frequency and shape, and doubt is said.

use super::{Problem, fitted, frequencies, measured, remarks, tower, unknown};
use towermodes_design::calibration::{Ambiguity, Measured, MeasuredShape};
use towermodes_testing::{Says, assert_matches};

fn unnamed(frequency_hz: f64, deviation_hz: f64) -> Measured {
    Measured {
        mode: None,
        ..measured("fore-aft 1", frequency_hz, deviation_hz)
    }
}

#[test]
fn a_frequency_finds_its_mode_and_the_fit_is_that_of_the_named_one() {
    let base = tower();
    let problem = |second: Measured| Problem {
        measured: vec![measured("fore-aft 1", 0.26, 0.001), second],
        unknowns: vec![unknown(&base, "foundation.rocking")],
        base: base.clone(),
    };
    let hz = frequencies(&base, &["fore-aft 2"])[0];
    let found = fitted(&problem(unnamed(hz, 0.005))).expect("a fit");
    let named = fitted(&problem(measured("fore-aft 2", hz, 0.005))).expect("a fit");
    assert_eq!(found.measured[1].mode.to_string(), "fore-aft 2");
    assert_eq!(found.measured[1].ambiguity, None);
    assert_eq!(found.unknowns, named.unknowns);
}

#[test]
fn two_modes_within_the_uncertainty_are_said() {
    let base = tower();
    let [fore_aft, side_side] = frequencies(&base, &["fore-aft 1", "side-side 1"])[..] else {
        unreachable!("two")
    };
    assert!((fore_aft - side_side).abs() < 0.005);
    let problem = Problem {
        measured: vec![unnamed(fore_aft, 0.01)],
        unknowns: vec![unknown(&base, "foundation.rocking")],
        base,
    };
    let result = fitted(&problem).expect("a fit");
    let other = match result.measured[0].ambiguity {
        Some(Ambiguity::Frequency { other, .. }) => other.to_string(),
        other => panic!("{other:?}"),
    };
    assert_eq!(other, "side-side 1");
    let said = remarks(&result).join("\n");
    let expected = "measurement 1 is taken for fore-aft 1, but may be side-side 1";
    said.says(expected);
}

/// The direction of the sensors decides between two modes of nearly one frequency.
#[test]
fn a_shape_finds_its_mode() {
    let base = tower();
    let heights_m = vec![30.0, 60.0, 87.6];
    for (direction, name) in [(0, "fore-aft 1"), (1, "side-side 1")] {
        let row = |z: &f64| {
            let mut row = [0.0; 2];
            row[direction] = -(z / 87.6).powi(2);
            row
        };
        let one = Measured {
            shape: Some(MeasuredShape {
                displacements: heights_m.iter().map(row).collect(),
                heights_m: heights_m.clone(),
            }),
            ..unnamed(0.262, 0.01)
        };
        let problem = Problem {
            measured: vec![one],
            unknowns: vec![unknown(&base, "foundation.rocking")],
            base: base.clone(),
        };
        let result = fitted(&problem).expect("a fit");
        assert_eq!(result.measured[0].mode.to_string(), name);
        assert_eq!(result.measured[0].ambiguity, None, "{name}");
    }
}

/// A sensor between both directions sees the first mode of each plane in the same way.
#[test]
fn a_shape_that_does_not_decide_is_said() {
    let base = tower();
    let one = Measured {
        shape: Some(MeasuredShape {
            heights_m: vec![87.6],
            displacements: vec![[1.0, 1.0]],
        }),
        ..unnamed(0.262, 0.01)
    };
    let problem = Problem {
        measured: vec![one],
        unknowns: vec![unknown(&base, "foundation.rocking")],
        base,
    };
    let result = fitted(&problem).expect("a fit");
    let ambiguity = result.measured[0].ambiguity;
    assert_matches!(ambiguity, Some(Ambiguity::Shape { .. }));
    remarks(&result).join("\n").says("(MAC 0.5");
}
