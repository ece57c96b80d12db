//! Shapes of frames: points within members against joints there, and against the tower.

use crate::towers::carried;
use towermodes::frame::*;
use towermodes::tower::Tube;
use towermodes::{Foundation, Material, Options, Rna, Station, Tower, TowerDescription, solve};

fn steel() -> Material {
    Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10)
}

fn tube(joints: [usize; 2], diameters_m: [f64; 2]) -> FrameMember {
    let section = |outer_diameter_m: f64| Tube {
        outer_diameter_m,
        wall_thickness_m: 0.02,
    };
    FrameMember::tube("brace", joints, diameters_m.map(section), steel())
}

/// Two bent legs on the ground with a cross between them, whose slender brace vibrates by itself,
/// and a spring; the first two joints are held.
fn portal() -> FrameDescription {
    let points = [
        [-6.0, 1.0, -20.0],
        [6.0, 0.0, -20.0],
        [-4.0, 0.0, 0.0],
        [4.0, 0.5, 0.0],
        [0.0, 5.0, -8.0],
    ];
    let members = [
        tube([0, 2], [2.0, 1.5]),
        tube([3, 1], [1.5, 2.0]),
        tube([2, 3], [1.0, 1.0]),
        tube([1, 2], [0.3, 0.4]),
        tube([4, 2], [0.8, 0.8]),
        tube([3, 4], [0.8, 0.8]),
    ];
    let joints = points.iter().enumerate();
    FrameDescription {
        joints: joints
            .map(|(k, point)| FrameJoint::new((k + 1).to_string(), *point))
            .collect(),
        members: members.to_vec(),
        supports: [0, 1].map(FrameSupport::clamped).to_vec(),
        ..FrameDescription::default()
    }
}

/// The same with joints at a quarter, a half and three quarters of each member.
fn divided(frame: &FrameDescription) -> FrameDescription {
    let mut divided = FrameDescription {
        members: Vec::new(),
        ..frame.clone()
    };
    for member in &frame.members {
        let MemberKind::Beam {
            ends: SectionEnds::Tube([from, to]),
            ..
        } = member.kind
        else {
            continue;
        };
        let [a, b] = member.joints.map(|joint| frame.joints[joint].position_m);
        let diameter_m = |k: usize| {
            let s = k as f64 / 4.0;
            from.outer_diameter_m + s * (to.outer_diameter_m - from.outer_diameter_m)
        };
        let mut near = member.joints[0];
        for k in 1..=4 {
            let far = if k == 4 {
                member.joints[1]
            } else {
                let s = k as f64 / 4.0;
                let at = std::array::from_fn(|i| a[i] + s * (b[i] - a[i]));
                let name = (divided.joints.len() + 1).to_string();
                divided.joints.push(FrameJoint::new(name, at));
                divided.joints.len() - 1
            };
            let part = tube([near, far], [diameter_m(k - 1), diameter_m(k)]);
            divided.members.push(part);
            near = far;
        }
    }
    divided
}

fn modes(description: FrameDescription, recipe: Option<FrameRecipe>) -> Vec<FrameMode> {
    let frame = Frame::new(description).expect("a frame");
    let options = FrameOptions {
        modes: 12,
        recipe,
        ..FrameOptions::default()
    };
    solve_frame(&frame, &options).expect("a solution").modes
}

/// All translations of the joints, then those of the points within the members.
fn points(shape: &FrameShape, joints: usize) -> Vec<[f64; 3]> {
    let of_joints = shape.joints[..joints]
        .iter()
        .map(|[x, y, z, ..]| [*x, *y, *z]);
    of_joints
        .chain(shape.members.iter().flatten().copied())
        .collect()
}

fn largest(points: &[[f64; 3]]) -> f64 {
    let all = points.iter().flatten();
    all.fold(0.0, |most: f64, value| most.max(value.abs()))
}

/// The largest difference, but for the sign, as a part of the largest motion.
fn difference(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let off = |sign: f64| {
        let pairs = a.iter().flatten().zip(b.iter().flatten());
        let off = pairs.map(|(a, b)| (a - sign * b).abs());
        off.fold(0.0, f64::max)
    };
    off(1.0).min(off(-1.0)) / largest(a)
}

#[test]
fn points_within_members_move_as_joints_at_their_places() {
    let whole = portal();
    let parts = divided(&whole);
    let joints = whole.joints.len();
    let (found, expected) = (modes(whole, None), modes(parts.clone(), None));
    let mut is_local = false;
    for (mode, reference) in found.iter().zip(&expected) {
        let own = points(&mode.shape, joints);
        let [of_joints, within] = [&own[..joints], &own[joints..]].map(largest);
        is_local |= within > 10.0 * of_joints;
        // The joints between are numbered by member, as the points are.
        let theirs = &points(&reference.shape, parts.joints.len())[..parts.joints.len()];
        let off = difference(&own, theirs);
        // Frequencies agree to 1e-10, shapes to its root at least.
        assert!(off < 2e-5, "{} Hz: {off:e}", mode.frequency_hz);
    }
    assert!(is_local, "no brace vibrates by itself");
}

#[test]
fn elements_of_subdyn_move_between_their_nodes_as_cubics() {
    // Four elements: the sampled points are their nodes.
    let whole = portal();
    let parts = divided(&whole);
    let joints = whole.joints.len();
    let recipe = |divisions| Some(FrameRecipe::Subdyn { divisions });
    let found = modes(whole, recipe(4));
    let expected = modes(parts.clone(), recipe(1));
    for (mode, reference) in found.iter().zip(&expected) {
        let own = points(&mode.shape, joints);
        let theirs = &points(&reference.shape, parts.joints.len())[..parts.joints.len()];
        let off = difference(&own, theirs);
        assert!(off < 1e-7, "{} Hz: {off:e}", mode.frequency_hz);
    }
}

#[test]
fn the_frame_moves_with_the_tower_on_it() {
    let on = |foundation| {
        let description = TowerDescription {
            materials: vec![steel()],
            stations: vec![Station::new(0.0, 4.0, 0.03), Station::new(60.0, 3.0, 0.02)],
            rna: Rna::point(1e5),
            foundation,
            ..TowerDescription::default()
        };
        let tower = Tower::new(description).expect("a tower");
        solve(&tower, &Options::default())
            .expect("a solution")
            .modes
    };
    for mode in on(carried(portal(), &[2, 3], [0.0; 3])) {
        let shape = mode.frame.as_ref().expect("a frame");
        let base = &mode.shape[0];
        let ([x, y, z], [rx, ry, rz]) = (base.translation, base.rotation);
        // From the transition piece to the joints: u + θ × r.
        for (joint, [a, b]) in [(2, [-4.0, 0.0]), (3, [4.0, 0.5])] {
            let moved = [x - rz * b, y + rz * a, z + rx * b - ry * a, rx, ry, rz];
            for (found, expected) in shape.joints[joint].iter().zip(moved) {
                let size = 1.0 + x.abs() + y.abs();
                assert!((found - expected).abs() < 1e-9 * size, "{found} {expected}");
            }
        }
    }
    assert!(
        on(Foundation::Clamped)
            .iter()
            .all(|mode| mode.frame.is_none())
    );
}

#[test]
fn masses_by_what_they_are_sum_to_that_of_the_frame() {
    let mut description = portal();
    let coat = |range, kind| FrameCoat { range, kind };
    let solid = |outer_radius_m, inner_radius_m| CoatKind::Solid {
        density_kg_per_m3: [1000.0; 2],
        outer_radius_m,
        inner_radius_m,
    };
    description.members[2].coats = vec![
        coat([0.0, 0.5], solid([0.55; 2], [0.5; 2])),
        coat([0.25, 0.75], solid([0.4; 2], [0.0; 2])),
        coat(
            [0.0, 1.0],
            CoatKind::AddedMass {
                density_kg_per_m3: 1000.0,
                radius_m: [0.5; 2],
                across: [1.0, 2.0],
                along: [0.0; 2],
            },
        ),
    ];
    let frame = Frame::new(description).expect("a frame");
    let masses = frame.masses();
    let length_m = frame.length_m(&frame.description().members[2]);
    let circle = |radius_m: f64| std::f64::consts::PI * radius_m * radius_m;
    let expected = [
        (
            masses.growth_kg,
            500.0 * length_m * (circle(0.55) - circle(0.5)),
        ),
        (masses.filling_kg, 500.0 * length_m * circle(0.4)),
        (masses.added_kg, 1500.0 * length_m * circle(0.5)),
    ];
    for (found, expected) in expected {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
    let sum = masses.members_kg + masses.growth_kg + masses.filling_kg;
    assert!((sum / frame.mass_kg() - 1.0).abs() < 1e-12);
    let bare = Frame::new(portal()).expect("a frame");
    assert!((masses.members_kg / bare.mass_kg() - 1.0).abs() < 1e-12);
}
