//! The manual's library of towers, and what tests do with them.

use towermodes::frame::*;
use towermodes::tower::Tube;
use towermodes::{
    Foundation, Material, Options, RigidBody, Rna, Solution, Station, Tower, TowerDescription,
    solve,
};
pub use towermodes_verify::towers::*;

/// Solves a description or panics with what is wrong.
pub fn solved(description: &TowerDescription, options: &Options) -> Solution {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    solve(&tower, options).expect("a solvable tower")
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

/// A steel tower on two legs, of which the first has a support of its own, with a brace of a
/// diameter, m, between their feet.
pub fn on_legs(brace_m: f64, support: FrameSupport) -> TowerDescription {
    let steel = Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10);
    let points = [[-6.0, 1.0, -20.0], [6.0, 0.0, -20.0], [0.0, 0.0, 0.0]];
    let joint = |(k, point): (usize, &[f64; 3])| FrameJoint::new(k.to_string(), *point);
    let tube = |joints: [usize; 2], outer_diameter_m| {
        let section = Tube {
            outer_diameter_m,
            wall_thickness_m: 0.02,
        };
        FrameMember::tube(format!("leg {joints:?}"), joints, [section; 2], steel)
    };
    let frame = Frame::new(FrameDescription {
        joints: points.iter().enumerate().map(joint).collect(),
        members: vec![tube([0, 2], 2.0), tube([2, 1], 2.0), tube([0, 1], brace_m)],
        supports: vec![support, FrameSupport::clamped(1)],
        transition: Some(Transition {
            position_m: [0.0; 3],
            joints: vec![2],
            is_held: false,
        }),
        ..FrameDescription::default()
    });
    let foundation = FrameFoundation::new(frame.expect("a frame"), RigidBody::default());
    TowerDescription {
        materials: vec![steel],
        stations: vec![Station::new(0.0, 3.0, 0.03), Station::new(60.0, 2.0, 0.02)],
        rna: Rna::point(60e3),
        foundation: Foundation::Frame(Box::new(foundation.expect("a foundation"))),
        ..TowerDescription::default()
    }
}
