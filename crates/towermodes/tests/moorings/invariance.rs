//! Results do not depend on the axes, on the reference point, or on evaluations before.

use super::decks::{at_rest, buoys, clump, coupled, delta, oc4_semi, rod};
use towermodes::mooring::{
    Attachment, Carrier, Mooring, MooringDescription, MooringWorkspace, Pose,
};
use towermodes::space::SpatialMatrix;
use towermodes_testing::Close;

type Motion = [[f64; 6]; 6];

/// Everything turned about z and moved horizontally.
fn carried(mooring: &MooringDescription, angle: f64, by: [f64; 2]) -> MooringDescription {
    let (sin, cos) = angle.sin_cos();
    let turn = |[x, y, z]: [f64; 3]| [cos * x - sin * y, sin * x + cos * y, z];
    let carry = |at: [f64; 3]| {
        let [x, y, z] = turn(at);
        [x + by[0], y + by[1], z]
    };
    let mut moved = mooring.clone();
    moved.reference_m = carry(mooring.reference_m);
    for point in &mut moved.points {
        match point.attachment {
            Attachment::Body(_) | Attachment::Rod(..) => {}
            Attachment::Fixed | Attachment::Platform | Attachment::Free => {
                point.position_m = carry(point.position_m);
            }
        }
    }
    for body in &mut moved.bodies {
        body.position_m = carry(body.position_m);
        // The axes of the body turn too: its points and centre stay where they are in it.
        body.angles_rad[2] += angle;
    }
    for rod in &mut moved.rods {
        rod.ends_m = rod.ends_m.map(carry);
    }
    moved
}

fn turn_of(angle: f64) -> Motion {
    let (sin, cos) = angle.sin_cos();
    let mut turn = [[0.0; 6]; 6];
    for block in [0, 3] {
        turn[block][block] = cos;
        turn[block][block + 1] = -sin;
        turn[block + 1][block] = sin;
        turn[block + 1][block + 1] = cos;
        turn[block + 2][block + 2] = 1.0;
    }
    turn
}

/// A K Aᵀ.
fn congruent(a: &Motion, k: &SpatialMatrix) -> SpatialMatrix {
    let sum = |i: usize, j: usize| {
        let pairs = (0..6).flat_map(|m| (0..6).map(move |n| (m, n)));
        pairs.map(|(m, n)| a[i][m] * k[m][n] * a[j][n]).sum()
    };
    std::array::from_fn(|i| std::array::from_fn(|j| sum(i, j)))
}

#[track_caller]
fn assert_equal(found: &SpatialMatrix, expected: &SpatialMatrix, tolerance: f64) {
    for i in 0..6 {
        for j in 0..6 {
            let scale = (expected[i][i] * expected[j][j]).abs().sqrt();
            found[i][j].within(expected[i][j], tolerance * scale);
        }
    }
}

#[test]
fn a_turned_mooring_has_the_turned_stiffness() {
    for mooring in [oc4_semi(), clump(), delta(), coupled(), rod(), buoys()] {
        let rest = at_rest(&mooring);
        for (angle, by) in [(0.7, [0.0, 0.0]), (-2.1, [120.0, -45.0])] {
            let moved = at_rest(&carried(&mooring, angle, by));
            let turn = turn_of(angle);
            assert_equal(
                &moved.load.stiffness,
                &congruent(&turn, &rest.load.stiffness),
                1e-9,
            );
            for (i, row) in turn.iter().enumerate() {
                let turned: f64 = row.iter().zip(rest.load.force).map(|(a, f)| a * f).sum();
                let scale = rest.load.force[2 + 3 * (i / 3)].abs().max(1e6);
                moved.load.force[i].within(turned, 1e-9 * scale);
            }
            for (moved, rest) in moved.lines.iter().zip(&rest.lines) {
                moved.tensions_n[1].close_to(rest.tensions_n[1], 1e-9);
            }
        }
    }
}

/// K about another point is Tᵀ K T, and the static moment moves with the force, of which the
/// stiffness has the symmetric part.
#[test]
fn the_stiffness_about_another_point_is_carried_there() {
    let mut above = oc4_semi();
    above.reference_m = [4.0, -3.0, 25.0];
    let (rest, above) = (at_rest(&oc4_semi()), at_rest(&above));
    let [x, y, z] = [4.0, -3.0, 25.0];
    // Rows: the motion of the origin by that of the other point, −[r].
    let mut carry = [[0.0; 6]; 6];
    for (i, row) in carry.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    let lever = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    for i in 0..3 {
        for j in 0..3 {
            carry[3 + j][i] = lever[i][j];
        }
    }
    let mut expected = congruent(&carry, &rest.load.stiffness);
    // The force F at the origin turns with the body about the other point: (1) with the arm −r.
    let force = [rest.load.force[0], rest.load.force[1], rest.load.force[2]];
    let arm = [-x, -y, -z];
    let along: f64 = (0..3).map(|i| force[i] * arm[i]).sum();
    for i in 0..3 {
        for j in 0..3 {
            let diagonal = if i == j { along } else { 0.0 };
            expected[3 + i][3 + j] += diagonal - 0.5 * (force[i] * arm[j] + arm[i] * force[j]);
        }
    }
    assert_equal(&above.load.stiffness, &expected, 1e-12);
}

#[test]
fn the_order_of_points_and_lines_does_not_matter() {
    let mut mooring = delta();
    let last = mooring.points.len() - 1;
    mooring.points.reverse();
    mooring.lines.reverse();
    for line in &mut mooring.lines {
        line.points = line.points.map(|point| last - point);
    }
    let (found, expected) = (at_rest(&mooring), at_rest(&delta()));
    assert_equal(&found.load.stiffness, &expected.load.stiffness, 1e-11);
}

/// An evaluation is a function of the pose: the same bits, and without any allocation.
#[test]
fn evaluations_do_not_depend_on_those_before_and_allocate_nothing() {
    let mooring = Mooring::new(buoys()).expect("a valid mooring");
    let poses = [
        Pose::default(),
        Pose::new([5.0, 1.0, 0.3], [0.1, 0.0, -0.1]),
    ];
    let mut workspace = MooringWorkspace::default();
    let first = poses.map(|pose| mooring.load(&pose, &mut workspace).expect("an equilibrium"));
    let again = allocation_counter::measure(|| {
        for (pose, first) in poses.iter().zip(&first).rev() {
            let load = mooring.load(pose, &mut workspace).expect("an equilibrium");
            assert_eq!(load, *first);
        }
    });
    assert_eq!(again.count_total, 0);
}

/// A body of the ground holds its lines as anchors do.
#[test]
fn a_fixed_body_is_an_anchor() {
    let mut held = buoys();
    for body in &mut held.bodies {
        body.carrier = Carrier::Fixed;
    }
    let mut anchors = held.clone();
    for point in &mut anchors.points {
        if let Attachment::Body(body) = point.attachment {
            let at = held.bodies[body].position_m;
            point.attachment = Attachment::Fixed;
            point.position_m = std::array::from_fn(|i| at[i] + point.position_m[i]);
        }
    }
    assert_eq!(at_rest(&held).load, at_rest(&anchors).load);
}
