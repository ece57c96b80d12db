//! The stiffness is the derivative of the force, for every mooring of these tests, at the reference
//! pose and far from it.

use super::decks::{
    buoyant, buoys, clump, coupled, delta, hywind, iea_22, oc4_semi, rod, tlp, volturnus,
};
use towermodes::mooring::{Mooring, MooringDescription, MooringWorkspace, Pose};

/// Half the step of the differences, m and rad.
const STEPS: [f64; 2] = [2e-3, 2e-5];
/// Of the largest entry with the same units; the differences have an error of about 1e-9.
const TOLERANCE: f64 = 1e-7;

/// −∂F/∂u by central differences of fourth order.
fn differences(mooring: &Mooring, pose: &Pose) -> [[f64; 6]; 6] {
    let mut workspace = MooringWorkspace::default();
    let mut columns = [[0.0; 6]; 6];
    for (j, column) in columns.iter_mut().enumerate() {
        let step = STEPS[j / 3];
        for (times, weight) in [(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)] {
            let mut motion = [0.0; 6];
            motion[j] = times * step;
            let load = mooring.load(&pose.moved(motion), &mut workspace);
            let force = load.expect("an equilibrium").force;
            for (sum, force) in column.iter_mut().zip(force) {
                *sum -= weight * force / (12.0 * step);
            }
        }
    }
    std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]))
}

#[track_caller]
fn assert_derivative(name: &str, mooring: &MooringDescription, pose: &Pose) {
    let mooring = Mooring::new(mooring.clone()).expect("a valid mooring");
    let load = mooring.at(pose).expect("an equilibrium").load;
    let mut expected = load.stiffness;
    // The moment in fixed axes is no gradient: half its skew matrix is the difference.
    let [_, _, _, x, y, z] = load.force;
    let skew = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    for (i, row) in skew.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            expected[3 + i][3 + j] += 0.5 * entry;
        }
    }
    let found = differences(&mooring, pose);
    for i in 0..6 {
        for j in 0..6 {
            let scale = (load.stiffness[i][i] * load.stiffness[j][j]).abs().sqrt();
            let difference = (found[i][j] - expected[i][j]).abs();
            assert!(
                difference <= TOLERANCE * scale,
                "{name}: {i} {j}: {} {}",
                found[i][j],
                expected[i][j]
            );
        }
    }
}

fn all() -> [(&'static str, MooringDescription); 11] {
    [
        ("hywind", hywind()),
        ("oc4", oc4_semi()),
        ("volturnus", volturnus()),
        ("iea 22", iea_22(200.0, 4.3234e9)),
        ("tlp", tlp()),
        ("clump", clump()),
        ("delta", delta()),
        ("buoys", buoys()),
        ("coupled", coupled()),
        ("rod", rod()),
        ("buoyant", buoyant()),
    ]
}

#[test]
fn the_stiffness_is_the_derivative_of_the_force() {
    for (name, mooring) in all() {
        assert_derivative(name, &mooring, &Pose::default());
    }
}

#[test]
fn the_stiffness_is_the_derivative_of_the_force_far_away() {
    let poses = [
        Pose::new([4.0, -3.0, 1.0], [0.05, -0.08, 0.15]),
        Pose::new([-6.0, 2.0, -0.5], [-0.1, 0.03, -0.2]),
    ];
    for (name, mooring) in all() {
        for pose in &poses {
            // Tendons resist the heave of the second pose, and would be slack.
            if name != "tlp" || pose.displacement_m[2] > 0.0 {
                assert_derivative(name, &mooring, pose);
            }
        }
    }
}

/// Fairleads turn about the reference point.
#[test]
fn the_stiffness_refers_to_the_reference_point() {
    let mut elsewhere = delta();
    elsewhere.reference_m = [3.0, -2.0, -20.0];
    assert_derivative(
        "elsewhere",
        &elsewhere,
        &Pose::new([1.0, 2.0, 0.0], [0.1, 0.1, 0.1]),
    );
}
