//! What no mooring system can have is refused with a sentence.

use super::decks::{buoys, clump, hywind, rod};
use towermodes::mooring::{
    Attachment, Carrier, Mooring, MooringDescription, MooringError, MooringLine, MooringPoint, Pose,
};
use towermodes_testing::Says;

/// The error of a mooring that a function has spoilt.
fn refused(
    mut mooring: MooringDescription,
    spoil: impl Fn(&mut MooringDescription),
) -> MooringError {
    spoil(&mut mooring);
    let state = Mooring::new(mooring).and_then(|mooring| mooring.at(&Pose::default()));
    state.expect_err("no such mooring exists")
}

#[test]
fn impossible_values_are_refused() {
    let hywind = |spoil: fn(&mut MooringDescription)| refused(hywind(), spoil);
    hywind(|m| m.depth_m = f64::NAN).reads("the depth of the mooring is NaN, not a finite number");
    hywind(|m| m.depth_m = -320.0).reads("the depth of the mooring is -320 m; it must be positive");
    hywind(|m| m.gravity_m_per_s2 = 0.0)
        .reads("gravity of the mooring is 0 m/s2; it must be positive");
    hywind(|m| m.line_types[0].axial_stiffness_n = 0.0)
        .reads("the axial stiffness of line type 1 is 0 N; it must be positive");
    hywind(|m| m.line_types[0].mass_kg_per_m = -77.0)
        .reads("the mass per length of line type 1 is -77 kg/m; it must not be negative");
    hywind(|m| m.line_types[0].seabed_friction = f64::INFINITY)
        .reads("the friction on the seabed of line type 1 is inf, not a finite number");
    hywind(|m| m.lines[2].length_m = 0.0).reads("the length of line 3 is 0 m; it must be positive");
    hywind(|m| m.points[3].position_m[0] = 1e30)
        .reads("the position of point 4 is 1e30 m; its magnitude must be at most 1e20 m");
    hywind(|m| m.points[3].volume_m3 = -1.0)
        .reads("the volume of point 4 is -1 m3; it must not be negative");
}

#[test]
fn parts_that_do_not_fit_together_are_refused() {
    let hywind = |spoil: fn(&mut MooringDescription)| refused(hywind(), spoil);
    hywind(|m| m.lines.clear()).begins("the mooring has no lines");
    hywind(|m| m.lines[1].line_type = 4)
        .reads("line 2 refers to line type 5, but the mooring has 1 of that kind");
    hywind(|m| m.lines[1].points[0] = 9)
        .reads("line 2 refers to point 10, but the mooring has 6 of that kind");
    hywind(|m| m.lines[1].points[0] = 4).begins("both ends of line 2 are point 5;");
    hywind(|m| m.points[5].attachment = Attachment::Body(0))
        .reads("point 6 refers to body 1, but the mooring has 0 of that kind");
    hywind(|m| m.points.push(MooringPoint::new(Attachment::Free, [0.0; 3])))
        .begins("point 7 is free, but no line ends there;");
    hywind(|m| {
        for point in &mut m.points {
            point.attachment = Attachment::Fixed;
        }
    })
    .begins("no line ends at the platform;");
    let body = |m: &mut MooringDescription| m.lines.retain(|line| line.points != [9, 10]);
    refused(buoys(), |m| {
        body(m);
        m.lines.truncate(4);
    })
    .begins("body 2 is free, but no line ends there;");
    refused(rod(), |m| m.rods[0].ends_m[1] = m.rods[0].ends_m[0])
        .begins("the ends of rod 1 are at the same position;");
}

#[test]
fn positions_that_lines_cannot_have_are_refused() {
    refused(hywind(), |m| m.points[1].position_m[2] = -321.0)
        .begins("point 2 is at z = -321 m, under the seabed at z = -320 m;");
    let short = refused(hywind(), |m| m.lines[0].length_m = 500.0);
    short.begins("line 1 is too short: its ends are 884.7");
    short.says("give it a length of at least 589.8");
    refused(clump(), |m| {
        m.points[1].mass_kg = 1e5;
        (m.lines[0].length_m, m.lines[1].length_m) = (440.0, 250.0);
    })
    .begins("point 2 sinks to z = -");
}

#[test]
fn a_body_that_turns_over_is_refused_or_found_upside_down() {
    // Ballast far above the buoyancy: the search begins at the unstable equilibrium.
    let error = refused(capsized(0.0), |_| ());
    assert_eq!(
        error,
        MooringError::Unstable {
            item: towermodes::mooring::MooringItem::Body(0)
        }
    );
    let state = Mooring::new(capsized(0.01))
        .expect("valid")
        .at(&Pose::default());
    let turned = state.expect("an equilibrium").bodies[0].rotation_rad;
    let angle = turned.iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!((angle - std::f64::consts::PI).abs() < 0.1, "{turned:?}");
}

/// A buoy on one tether whose weight acts 3 m above the tether's end, and a line to the platform.
fn capsized(lean: f64) -> MooringDescription {
    let mut mooring = hywind();
    mooring
        .points
        .push(MooringPoint::anchor([0.0, 60.0, -320.0]));
    mooring
        .points
        .push(MooringPoint::new(Attachment::Body(0), [0.0, 0.0, 0.0]));
    mooring.lines.push(MooringLine {
        line_type: 0,
        length_m: 199.0,
        points: [6, 7],
    });
    mooring.bodies.push(towermodes::mooring::MooringBody {
        carrier: Carrier::Free,
        position_m: [0.0, 60.0, -120.0],
        angles_rad: [lean, 0.0, 0.0],
        mass_kg: 1e4,
        center_m: [0.0, 0.0, -3.0],
        inertia_kg_m2: [1e4; 3],
        volume_m3: 60.0,
    });
    mooring
}
