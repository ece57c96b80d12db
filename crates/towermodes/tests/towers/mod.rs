//! The manual's library of towers, and what tests do with them.
#![allow(
    dead_code,
    unused_imports,
    reason = "each test file uses its own part of the library"
)]

use towermodes::frame::{
    Frame, FrameDescription, FrameFoundation, FrameJoint, FrameMember, FrameSupport, Transition,
};
use towermodes::{
    Family, Foundation, Material, Options, RigidBody, Rna, Solution, Station, Tower,
    TowerDescription, solve,
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

/// Three legs under a joint and a brace between two of their feet, with a mass on one foot.
pub fn tripod(
    member: impl Fn([usize; 2]) -> FrameMember,
    support: impl Fn(usize) -> FrameSupport,
) -> FrameDescription {
    let points = [
        [-9.0, 0.0, -30.0],
        [6.0, 7.0, -30.0],
        [6.0, -8.0, -32.0],
        [0.0, 0.0, 0.0],
    ];
    let joint = |(k, point): (usize, &[f64; 3])| FrameJoint::new((k + 1).to_string(), *point);
    FrameDescription {
        joints: points.iter().enumerate().map(joint).collect(),
        members: [[0, 3], [3, 1], [2, 3], [0, 1]].map(member).to_vec(),
        supports: [0, 1, 2].map(support).to_vec(),
        masses: vec![(1, RigidBody::point(5e3, [0.0; 3]))],
        ..FrameDescription::default()
    }
}

/// A steel tower up to 60 m with a nacelle, on a foundation at a height, m.
pub fn on_foundation(foundation: Foundation, base_m: f64) -> TowerDescription {
    TowerDescription {
        materials: vec![Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10)],
        stations: vec![
            Station::new(base_m, 2.0, 0.03),
            Station::new(60.0, 1.5, 0.02),
        ],
        rna: Rna {
            center_m: [0.4, 0.0, 1.0],
            ..Rna::point(20e3)
        },
        foundation,
        ..TowerDescription::default()
    }
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
