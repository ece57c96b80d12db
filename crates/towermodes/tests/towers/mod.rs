//! The manual's library of towers, and what tests do with them.
#![allow(
    dead_code,
    unused_imports,
    reason = "each test file uses its own part of the library"
)]

use towermodes::frame::{Frame, FrameDescription, FrameFoundation, Transition};
use towermodes::{
    Family, Foundation, Options, RigidBody, Solution, Tower, TowerDescription, solve,
};
pub use towermodes_verify::towers::*;

/// Solves a description or panics with what is wrong.
pub fn solved(description: &TowerDescription, options: &Options) -> Solution {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    solve(&tower, options).expect("a solvable tower")
}

/// A frame as a foundation, with a transition piece without mass at this point, on which these
/// joints are.
pub fn carried(mut frame: FrameDescription, joints: &[usize], position_m: [f64; 3]) -> Foundation {
    frame.transition = Some(Transition {
        position_m,
        joints: joints.to_vec(),
        is_held: false,
    });
    let frame = Frame::new(frame).expect("a frame");
    let foundation = FrameFoundation::new(frame, RigidBody::default()).expect("a foundation");
    Foundation::Frame(Box::new(foundation))
}

/// The frequencies of a family, rising, Hz.
pub fn frequencies(solution: &Solution, family: Family) -> Vec<f64> {
    let of_family = solution.modes.iter().filter(|m| m.family == family);
    of_family.map(|m| m.frequency_hz).collect()
}

/// The extrapolated frequencies of a family, rising, Hz.
pub fn extrapolated(solution: &Solution, family: Family) -> Vec<f64> {
    let of_family = solution.modes.iter().filter(|m| m.family == family);
    of_family.map(|m| m.extrapolated_hz).collect()
}

/// The frequencies of all modes, rising, Hz.
pub fn all_frequencies(solution: &Solution) -> Vec<f64> {
    solution.modes.iter().map(|m| m.frequency_hz).collect()
}

/// Asserts that two lists of frequencies have one length and no relative difference over the
/// tolerance, naming the case.
#[track_caller]
pub fn assert_same(got: &[f64], expected: &[f64], tolerance: f64, case: &str) {
    assert_eq!(got.len(), expected.len(), "{case}");
    for (place, (got, expected)) in got.iter().zip(expected).enumerate() {
        assert_close(
            *got,
            *expected,
            tolerance,
            &format!("{case}, mode {}", place + 1),
        );
    }
}

/// Asserts |got/expected − 1| ≤ tolerance, naming the case.
#[track_caller]
pub fn assert_close(got: f64, expected: f64, tolerance: f64, case: &str) {
    let difference = got / expected - 1.0;
    assert!(
        difference.abs() <= tolerance,
        "{case}: got {got:.12}, expected {expected:.12}, relative difference {difference:.2e} > {tolerance:.0e}"
    );
}
