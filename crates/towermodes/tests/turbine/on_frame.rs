//! Turbines whose tower stands on a frame: counts against dense matrices, and the limits in which
//! the frame is a longer tower, a clamp, or carries a rigid body.

use nalgebra::{Matrix3, RowDVector, Vector3};
use towermodes::frame::*;
use towermodes::tower::Tube;
use towermodes::turbine::{Turbine, TurbineDescription, TurbineMesh, TurbineModel};
use towermodes::{Foundation, Inertia, Material, RigidBody, Station, TowerDescription};

use towermodes_testing::Says;

use super::dense::{Dense, GAUSS, Numbers, Real, TOWER_ELEMENTS, body_inertia, hermite, random};
use super::{FINE, assert_is_rigid_at_rest, frequencies, tilted};

const DENSITY: f64 = 7850.0;
const YOUNG: f64 = 2.1e11;
const SHEAR: f64 = 8.08e10;

fn steel() -> Material {
    Material::from_shear_modulus(DENSITY, YOUNG, SHEAR)
}

/// A frame of tubes without shear deformation, with the first joints clamped and the last ones on
/// the transition piece, which is a body itself.
fn foundation(
    joints_m: &[[f64; 3]],
    tubes: &[([usize; 2], [f64; 2])],
    (clamped, carrying): (usize, usize),
    position_m: [f64; 3],
) -> FrameFoundation {
    let joint = |(k, at): (usize, &[f64; 3])| FrameJoint::new(k.to_string(), *at);
    let tube =
        |(k, (joints, [outer_diameter_m, wall_thickness_m])): (usize, &([usize; 2], [f64; 2]))| {
            let section = Tube {
                outer_diameter_m: *outer_diameter_m,
                wall_thickness_m: *wall_thickness_m,
            };
            let mut member = FrameMember::tube(k.to_string(), *joints, [section; 2], steel());
            member.shears = false;
            member
        };
    let description = FrameDescription {
        joints: joints_m.iter().enumerate().map(joint).collect(),
        members: tubes.iter().enumerate().map(tube).collect(),
        supports: (0..clamped).map(FrameSupport::clamped).collect(),
        transition: Some(Transition {
            position_m,
            joints: (joints_m.len() - carrying..joints_m.len()).collect(),
            is_held: false,
        }),
        ..FrameDescription::default()
    };
    let frame = Frame::new(description).expect("a frame");
    FrameFoundation::new(frame, RigidBody::default()).expect("a foundation")
}

/// Three legs, bent and crossed, below a transition piece out of their middle.
const JOINTS_M: [[f64; 3]; 7] = [
    [-9.0, -7.0, -32.0],
    [10.0, -6.0, -31.0],
    [0.5, 11.0, -33.0],
    [-4.0, -3.5, -14.0],
    [4.5, -3.0, -2.0],
    [-3.0, -2.0, -2.5],
    [0.0, 4.0, -2.0],
];
const TUBES: [([usize; 2], [f64; 2]); 8] = [
    ([0, 3], [1.4, 0.04]),
    ([3, 5], [1.3, 0.03]),
    ([1, 4], [1.5, 0.03]),
    ([2, 6], [1.4, 0.035]),
    ([3, 4], [0.7, 0.012]),
    ([1, 5], [0.6, 0.015]),
    ([2, 5], [0.8, 0.02]),
    ([6, 3], [0.5, 0.01]),
];

fn tripod() -> FrameFoundation {
    foundation(&JOINTS_M, &TUBES, (3, 3), [0.0, 0.0, -3.0])
}

fn on(below: FrameFoundation, tower: TowerDescription) -> TowerDescription {
    TowerDescription {
        foundation: Foundation::Frame(Box::new(below)),
        ..tower
    }
}

/// Stiffness and mass of a member of Hermite cubics in bending and other cubics along and about its
/// axis, for the motions of both ends and four coordinates inside.
fn member(ends_m: [[f64; 3]; 2], [diameter_m, wall_m]: [f64; 2]) -> [Real; 2] {
    let [from, to] = ends_m.map(Vector3::from);
    let length = (to - from).norm();
    let along = (to - from) / length;
    let across = along.cross(&Vector3::new(0.3, 0.9, -0.2)).normalize();
    let axes = [across, along.cross(&across), along];
    let inside = diameter_m - 2.0 * wall_m;
    let area = std::f64::consts::FRAC_PI_4 * (diameter_m.powi(2) - inside.powi(2));
    let second = std::f64::consts::PI / 64.0 * (diameter_m.powi(4) - inside.powi(4));
    let (mut stiffness, mut mass) = (Real::zeros(16, 16), Real::zeros(16, 16));
    let row = |component: usize, axis: Vector3<f64>, factor: f64| {
        let mut row = RowDVector::<f64>::zeros(16);
        (0..3).for_each(|i| row[component + i] = factor * axis[i]);
        row
    };
    for (s, weight) in GAUSS {
        let dm = weight * length;
        let add = |matrix: &mut Real, density: f64, row: &RowDVector<f64>| {
            *matrix += dm * density * row.transpose() * row;
        };
        for (axis, other, sign) in [(axes[0], axes[1], 1.0), (axes[1], axes[0], -1.0)] {
            // The slope of a deflection along one axis is the rotation about the other.
            let of = |values: [f64; 4]| {
                row(0, axis, values[0])
                    + row(3, other, sign * values[1])
                    + row(6, axis, values[2])
                    + row(9, other, sign * values[3])
            };
            let [deflection, slope, curvature] = hermite(s, length).map(of);
            add(&mut stiffness, YOUNG * second, &curvature);
            add(&mut mass, DENSITY * area, &deflection);
            add(&mut mass, DENSITY * second, &slope);
        }
        let (bubble, change) = (
            [s * (1.0 - s), s * (1.0 - s) * (1.0 - 2.0 * s)],
            [1.0 - 2.0 * s, 1.0 - 6.0 * s + 6.0 * s * s],
        );
        for (first, inner, rigidity, density) in [
            (0, 12, YOUNG * area, DENSITY * area),
            (3, 14, SHEAR * 2.0 * second, DENSITY * 2.0 * second),
        ] {
            let mut value = row(first, along, 1.0 - s) + row(first + 6, along, s);
            let mut strain = row(first, along, -1.0) + row(first + 6, along, 1.0);
            for k in 0..2 {
                value[inner + k] = bubble[k];
                strain[inner + k] = change[k];
            }
            add(&mut stiffness, rigidity / (length * length), &strain);
            add(&mut mass, density, &value);
        }
    }
    [stiffness, mass]
}

/// The tripod by nodes: the motion of the tower's foot, of the joint that is free, and of the
/// insides of the members.
fn dense_tripod(platform: &RigidBody) -> [Real; 2] {
    let size = 12 + 4 * TUBES.len();
    let foot = Vector3::zeros();
    let carried = |at: Vector3<f64>| {
        let mut motion = Real::zeros(6, size);
        motion
            .view_mut((0, 0), (6, 6))
            .copy_from(&Real::identity(6, 6));
        let lever: Matrix3<f64> = -(at - foot).cross_matrix();
        motion.view_mut((0, 3), (3, 3)).copy_from(&lever);
        motion
    };
    let of_joint = |joint: usize| match joint {
        0..3 => Real::zeros(6, size),
        3 => {
            let mut motion = Real::zeros(6, size);
            motion
                .view_mut((0, 6), (6, 6))
                .copy_from(&Real::identity(6, 6));
            motion
        }
        _ => carried(Vector3::from(JOINTS_M[joint])),
    };
    let mut sums = [Real::zeros(size, size), Real::zeros(size, size)];
    for (index, (joints, section)) in TUBES.iter().enumerate() {
        let mut map = Real::zeros(16, size);
        for (side, joint) in joints.iter().enumerate() {
            map.rows_mut(6 * side, 6).copy_from(&of_joint(*joint));
        }
        (0..4).for_each(|k| map[(12 + k, 12 + 4 * index + k)] = 1.0);
        let own = member(joints.map(|joint| JOINTS_M[joint]), *section);
        for (sum, own) in sums.iter_mut().zip(own) {
            *sum += map.transpose() * own * &map;
        }
    }
    let body = body_inertia(
        platform.mass_kg,
        platform.center_m,
        platform.inertia_kg_m2.tensor(),
    );
    let map = carried(Vector3::new(0.0, 0.0, -3.0));
    sums[1] += map.transpose() * body * &map;
    sums
}

/// Random frequencies up to 12 Hz and speeds in both directions, up to those where the stiffness is
/// indefinite: no count is wrong.
#[test]
fn counts_on_a_frame_are_those_of_dense_matrices() {
    let mesh = TurbineMesh {
        tower_elements: TOWER_ELEMENTS,
        tower_degree: 3,
        blade_degree: 3,
    };
    let mut below = tripod();
    below.platform = RigidBody {
        mass_kg: 5e4,
        center_m: [0.4, -0.7, 1.1],
        inertia_kg_m2: Inertia::from([3e5, 4e5, 6e5, 2e4, -3e4, 1e4]),
    };
    let mut indefinite = 0;
    for seed in 1..=10 {
        let (tower, machine) = random(seed);
        let dense = Dense::on(dense_tripod(&below.platform), &tower, &machine);
        let turbine = Turbine::new(on(below.clone(), tower), machine).expect("a turbine");
        let mut model = TurbineModel::new(&turbine, &mesh).expect("a model");
        let mut n = Numbers(2000 + seed);
        for _ in 0..100 {
            let (w, rpm) = (n.between(0.01, 75.0), n.between(-134.0, 134.0));
            let counted = model.count(w / std::f64::consts::TAU, rpm);
            let expected = dense.count(w, super::rad_per_s(rpm));
            assert_eq!(counted, expected, "turbine {seed}: {w} rad/s, {rpm} rpm");
            indefinite += usize::from(model.negative_stiffness(rpm) > 0);
        }
    }
    assert!((100..900).contains(&indefinite), "{indefinite}");
}

/// A steel tower that does not shear, from its base to 60 m.
fn steel_tower(stations: &[[f64; 3]], foundation: Foundation) -> TowerDescription {
    let station =
        |[height_m, diameter_m, wall_m]: &[f64; 3]| Station::new(*height_m, *diameter_m, *wall_m);
    TowerDescription {
        materials: vec![steel()],
        stations: stations.iter().map(station).collect(),
        foundation,
        gravity_m_per_s2: 9.81,
        ..TowerDescription::default()
    }
}

const ABOVE: [[f64; 3]; 2] = [[0.0, 5.0, 0.04], [60.0, 3.5, 0.03]];

fn model_of(tower: TowerDescription, machine: TurbineDescription) -> TurbineModel {
    let turbine = Turbine::new(tower, machine).expect("a turbine");
    TurbineModel::new(&turbine, &FINE).expect("a model")
}

#[track_caller]
fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?}, {expected:?}");
    for (found, expected) in found.iter().zip(expected) {
        let error = (found / expected - 1.0).abs();
        assert!(
            error < tolerance,
            "{found} Hz, expected {expected} Hz: {error:e}"
        );
    }
}

/// Blades, shaft and yaw drive that do not deform, in a rotor at rest on a tripod, with the weight
/// of all: the tower program with the machine as a rigid body, which has the frame in another tree
/// and another elimination. What the blades yield is 1e-10.
#[test]
fn a_stiff_rotor_at_rest_is_a_rigid_body_on_a_tower_on_a_frame() {
    let description = on(tripod(), steel_tower(&ABOVE, Foundation::Clamped));
    assert_is_rigid_at_rest(&description, 12);
}

/// One member, in one piece or cut, is the lower part of a longer tower, with the weight of all, at
/// rest and at 12 rpm.
#[test]
fn a_vertical_member_under_a_turbine_is_the_lower_part_of_a_longer_tower() {
    let [_, top] = ABOVE;
    let section = [5.0, 0.04];
    let stations = steel_tower(&ABOVE, Foundation::Clamped);
    let whole = TowerDescription {
        stations: [[-30.0, 5.0, 0.04], ABOVE[0], top]
            .map(|[z, d, t]| Station::new(z, d, t))
            .to_vec(),
        ..stations.clone()
    };
    let mut whole = model_of(whole, tilted());
    let tubes = |count: usize| {
        (1..=count)
            .map(|k| ([k - 1, k], section))
            .collect::<Vec<_>>()
    };
    let heights: [&[f64]; 2] = [&[-30.0, 0.0], &[-30.0, -12.0, -11.999, 0.0]];
    for heights in heights {
        let joints: Vec<[f64; 3]> = heights.iter().map(|z| [0.0, 0.0, *z]).collect();
        let below = foundation(&joints, &tubes(joints.len() - 1), (1, 1), [0.0; 3]);
        let mut model = model_of(on(below, stations.clone()), tilted());
        for rpm in [0.0, 12.0] {
            let expected = frequencies(&mut whole, 4.0, rpm);
            assert_close(&frequencies(&mut model, 4.0, rpm), &expected, 1e-9);
        }
    }
}

/// A frame a million times as stiff is a clamp, but for a millionth of its flexibility.
#[test]
fn a_very_stiff_frame_under_a_turbine_is_a_clamp() {
    let mut stiff = tripod();
    let mut description = stiff.frame.description().clone();
    for member in &mut description.members {
        if let MemberKind::Beam { material, .. } = &mut member.kind {
            material.youngs_modulus_pa *= 1e6;
            material.shear_modulus_pa *= 1e6;
        }
    }
    stiff.frame = Frame::new(description).expect("a frame");
    let tower = || steel_tower(&ABOVE, Foundation::Clamped);
    for rpm in [0.0, 12.0] {
        let found = frequencies(
            &mut model_of(on(stiff.clone(), tower()), tilted()),
            3.0,
            rpm,
        );
        let expected = frequencies(&mut model_of(tower(), tilted()), 3.0, rpm);
        assert_close(&found, &expected, 1e-5);
    }
}

/// A transition piece that is rigidly held has no matrix that a turbine could stand on.
#[test]
fn a_transition_piece_that_nothing_lets_move_is_refused() {
    let mut below = tripod();
    let mut description = below.frame.description().clone();
    description.members[2].kind = MemberKind::Rigid { mass_kg_per_m: 0.0 };
    below.frame = Frame::new(description).expect("a frame");
    let tower = on(below, steel_tower(&ABOVE, Foundation::Clamped));
    let turbine = Turbine::new(tower, tilted()).expect("a turbine");
    let error = TurbineModel::new(&turbine, &FINE).expect_err("held");
    error.says("the transition piece with a support, at joint 4");
}
