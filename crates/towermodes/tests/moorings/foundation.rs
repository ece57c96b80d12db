//! The lines of a floating platform: their stiffness follows them, and mistakes have a place.

use towermodes::mooring::{
    LineType, MooringDescription, MooringError, MooringItem, MooringLine, MooringPoint,
};
use towermodes::{
    FloatingPlatform, MooringLines, Options, Place, Problem, ReferredMatrix, Tower,
    TowerDescription, solve,
};

use super::platform_of;
use crate::towers::floater;

/// Three lines from fairleads at a depth to the seabed.
fn lines(length_m: f64) -> MooringLines {
    let mut spar = MooringDescription {
        depth_m: 320.0,
        line_types: vec![LineType::new(0.09, 77.7066, 384.243e6)],
        ..MooringDescription::default()
    };
    for angle_deg in [0.0_f64, 120.0, 240.0] {
        let (sin, cos) = angle_deg.to_radians().sin_cos();
        let at = |radius: f64, z: f64| [radius * cos, radius * sin, z];
        let anchor = spar.points.len();
        spar.points.push(MooringPoint::anchor(at(853.87, -320.0)));
        spar.points.push(MooringPoint::fairlead(at(5.2, -70.0)));
        spar.lines.push(MooringLine {
            line_type: 0,
            length_m,
            points: [anchor, anchor + 1],
        });
    }
    MooringLines {
        description: spar,
        still_water_m: 1.5,
    }
}

fn with(change: impl FnOnce(&mut FloatingPlatform)) -> TowerDescription {
    let mut description = floater();
    change(platform_of(&mut description));
    description
}

fn frequencies_hz(description: TowerDescription) -> Vec<f64> {
    let tower = Tower::new(description).expect("a floating tower");
    let solution = solve(&tower, &Options::default()).expect("modes");
    solution.modes.iter().map(|m| m.frequency_hz).collect()
}

/// The matrix of the lines about still water, given as a matrix, is the same foundation. The only
/// difference is the rounding of sums.
#[test]
fn lines_are_the_matrix_that_they_have() {
    let load = lines(902.2).at_rest().expect("lines that reach");
    let given = frequencies_hz(with(|p| {
        p.mooring = ReferredMatrix {
            matrix: load.stiffness,
            height_m: 1.5,
        };
    }));
    let own = frequencies_hz(with(|p| {
        p.mooring = ReferredMatrix::default();
        p.mooring_lines = Some(Box::new(lines(902.2)));
    }));
    for (given, own) in given.iter().zip(&own) {
        assert!((given / own - 1.0).abs() < 1e-12, "{given} {own}");
    }
    // Shorter lines are tauter.
    let taut = frequencies_hz(with(|p| {
        p.mooring = ReferredMatrix::default();
        p.mooring_lines = Some(Box::new(lines(890.0)));
    }));
    assert!(taut[0] > 1.2 * own[0], "{} {}", taut[0], own[0]);
}

#[test]
fn a_line_that_cannot_reach_has_a_place() {
    let description = with(|p| p.mooring_lines = Some(Box::new(lines(300.0))));
    let error = Tower::new(description).expect_err("a line of 300 m cannot reach 890 m");
    let item = MooringItem::Line(0);
    assert_eq!(error.place, Place::Mooring { item });
    let is_short = matches!(
        error.problem,
        Problem::Mooring(MooringError::TooShort { line: 0, .. })
    );
    assert!(is_short, "{error}");
}
