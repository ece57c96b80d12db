//! Space frames: counts, invariances, limits under a tower, mechanisms, names of local modes. Their
//! frequencies by an independent program are cases of the verification manual.

use crate::towers::{carried, on_foundation};
use towermodes::frame::*;
use towermodes::internal::frame::FrameBelow;
use towermodes::tower::Tube;
use towermodes::{
    Foundation, Inertia, Material, Method, Options, RigidBody, Station, Tower, TowerDescription,
    solve,
};

/// A tube of steel between two joints.
fn tube(name: &str, joints: [usize; 2]) -> FrameMember {
    of_section(name, joints, 2.0, 0.03)
}

fn of_section(name: &str, joints: [usize; 2], diameter_m: f64, wall_m: f64) -> FrameMember {
    let steel = Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10);
    let section = Tube {
        outer_diameter_m: diameter_m,
        wall_thickness_m: wall_m,
    };
    FrameMember::tube(name, joints, [section, section], steel)
}

/// Joints at these points, tubes between them, the first joints supported, the last one free.
fn frame(points: &[[f64; 3]], tubes: &[[usize; 2]], clamped: &[usize]) -> FrameDescription {
    let joint = |(k, point): (usize, &[f64; 3])| FrameJoint::new((k + 1).to_string(), *point);
    let member = |(k, ends): (usize, &[usize; 2])| tube(&(k + 1).to_string(), *ends);
    FrameDescription {
        joints: points.iter().enumerate().map(joint).collect(),
        members: tubes.iter().enumerate().map(member).collect(),
        supports: clamped
            .iter()
            .map(|joint| FrameSupport::clamped(*joint))
            .collect(),
        ..FrameDescription::default()
    }
}

fn with_joint(mut frame: FrameDescription, joint: usize, kind: JointKind) -> FrameDescription {
    frame.joints[joint].kind = kind;
    frame
}

/// The stiffness and inertia of the soil under a pile.
fn soil(joint: usize) -> FrameSupport {
    let mut support = FrameSupport {
        fixed: [false; 6],
        ..FrameSupport::clamped(joint)
    };
    let stiffness = [
        (0, 0, 5.04e7),
        (0, 1, 3.1e5),
        (1, 1, 5.6e7),
        (2, 2, 2.54e8),
        (0, 4, -1.98e8),
        (1, 3, 2.0e8),
        (3, 3, 1.3e9),
        (4, 4, 1.35e9),
        (5, 5, 7.0e8),
    ];
    for (i, j, value) in stiffness {
        (support.stiffness[i][j], support.stiffness[j][i]) = (value, value);
    }
    let inertia = [
        (0, 0, 4e3),
        (1, 1, 4e3),
        (2, 2, 3e3),
        (0, 4, -9e3),
        (1, 3, 9e3),
    ];
    for (i, j, value) in inertia {
        (support.inertia[i][j], support.inertia[j][i]) = (value, value);
    }
    support
}

fn frequencies(description: &FrameDescription, count: usize) -> Vec<f64> {
    let frame = Frame::new(description.clone()).expect("a frame");
    let options = FrameOptions {
        modes: count,
        ..FrameOptions::default()
    };
    let solution = solve_frame(&frame, &options).expect("a solution");
    solution
        .modes
        .iter()
        .map(|mode| mode.frequency_hz)
        .collect()
}

const VERTICAL: [[f64; 3]; 2] = [[0.0, 0.0, -20.0], [0.0, 0.0, 0.0]];
const HALVES: [[f64; 3]; 3] = [[0.0, 0.0, -20.0], [0.0, 0.0, -10.0], [0.0, 0.0, 0.0]];
const BENT: [[f64; 3]; 4] = [
    [-5.0, 0.0, -20.0],
    [0.0, 1.0, -10.0],
    [0.0, 0.0, 0.0],
    [4.0, 3.0, -20.0],
];
const IN_LINE: [[usize; 2]; 2] = [[0, 1], [1, 2]];

#[test]
fn a_pin_with_nothing_behind_it_has_a_mode_of_0_hz_and_names_its_joint() {
    let pin = JointKind::Pin {
        axis: [0.0, 1.0, 0.0],
        stiffness_n_m_per_rad: 0.0,
    };
    let free = with_joint(frame(&HALVES, &IN_LINE, &[0]), 1, pin);
    let frame = Frame::new(free).expect("a frame");
    let solution = solve_frame(&frame, &FrameOptions::default()).expect("modes");
    let message = solution.mechanism.expect("a mechanism").to_string();
    assert!(
        message.starts_with(
            "the frame is a mechanism: 1 motion has no stiffness; the first moves joint 2 about y"
        ),
        "{message}"
    );
    assert_eq!(solution.modes[0].frequency_hz, 0.0);
    assert!(solution.modes[1].frequency_hz > 4.9);
    let below =
        count_frame_modes(&frame, FrameRecipe::Spectral { degree: 6 }, 4.9).expect("a count");
    assert_eq!(below, 1);
}

#[test]
fn a_frame_that_nothing_holds_has_six_motions_without_stiffness() {
    let found = frequencies(&frame(&HALVES, &IN_LINE, &[]), 8);
    assert!(found[..6].iter().all(|f| *f < 1e-5), "{found:?}");
    let twice = frequencies(&frame(&VERTICAL, &[[0, 1]], &[]), 8);
    assert!((found[6] / twice[6] - 1.0).abs() < 1e-9);
}

#[test]
fn a_frame_that_is_turned_and_mirrored_has_the_same_frequencies() {
    let portal = |turn: &dyn Fn([f64; 3]) -> [f64; 3]| {
        let points = [
            [-4.0, -3.0, -10.0],
            [5.0, -3.0, -10.0],
            [0.0, 4.0, -10.0],
            [0.5, 0.2, 0.0],
            [0.5, 0.2, 1e-3],
            [0.5, 0.2, 6.0],
        ];
        let tubes = [[0, 3], [1, 3], [2, 3], [0, 1], [3, 4], [4, 5]];
        frequencies(&frame(&points.map(turn), &tubes, &[0, 2]), 6)
    };
    let first = portal(&|point| point);
    let (sin, cos) = 0.7_f64.sin_cos();
    let turned = portal(&|[x, y, z]| [cos * x - sin * y, sin * x + cos * y, z]);
    let lying = portal(&|[x, y, z]| [z, x, y]);
    let mirrored = portal(&|[x, y, z]| [-x, y, z]);
    for other in [turned, lying, mirrored] {
        for (a, b) in first.iter().zip(other) {
            assert!((a / b - 1.0).abs() < 1e-11, "{a} and {b}");
        }
    }
}

#[test]
fn a_member_of_a_millimetre_costs_no_digit() {
    let whole = frequencies(&frame(&VERTICAL, &[[0, 1]], &[0]), 4);
    let points = [
        [0.0, 0.0, -20.0],
        [0.0, 0.0, -9.0],
        [0.0, 0.0, -8.999],
        [0.0, 0.0, -8.998],
        [0.0, 0.0, 0.0],
    ];
    let pieces = [[0, 1], [1, 2], [2, 3], [3, 4]];
    let cut = frequencies(&frame(&points, &pieces, &[0]), 4);
    for (a, b) in whole.iter().zip(cut) {
        assert!((a / b - 1.0).abs() < 1e-11, "{a} and {b}");
    }
}

/// A tower of 60 m with a nacelle, on a foundation.
fn tower_on(foundation: Foundation, base_m: f64, gravity_m_per_s2: f64) -> Tower {
    Tower::new(TowerDescription {
        gravity_m_per_s2,
        ..on_foundation(foundation, base_m)
    })
    .expect("a tower")
}

fn modes_of(tower: &Tower, method: Method) -> Vec<(String, f64)> {
    let options = Options {
        method,
        modes: 8,
        ..Options::default()
    };
    let solution = solve(tower, &options).expect("a solution");
    assert!(solution.certificate.complete);
    let modes = solution.modes.iter();
    modes
        .map(|mode| (mode.label(), mode.extrapolated_hz))
        .collect()
}

#[test]
fn a_vertical_member_under_a_tower_is_the_lower_part_of_a_longer_tower() {
    let steel = Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10);
    let cuts = [vec![], vec![-13.0, -12.999]];
    for (gravity_m_per_s2, cuts) in [(0.0, &cuts[0]), (9.81, &cuts[0]), (9.81, &cuts[1])] {
        let mut points = vec![[0.0, 0.0, -20.0]];
        points.extend(cuts.iter().map(|z| [0.0, 0.0, *z]));
        points.push([0.0; 3]);
        let ends: Vec<[usize; 2]> = (1..points.len()).map(|k| [k - 1, k]).collect();
        let mut below = frame(&points, &ends, &[0]);
        below
            .members
            .iter_mut()
            .for_each(|member| member.shears = false);
        let carried = carried(below, &[points.len() - 1], [0.0; 3]);
        let on_member = tower_on(carried, 0.0, gravity_m_per_s2);
        let whole = Tower::new(TowerDescription {
            materials: vec![steel],
            stations: vec![
                Station::new(-20.0, 2.0, 0.03),
                Station::new(0.0, 2.0, 0.03),
                Station::new(60.0, 1.5, 0.02),
            ],
            rna: *on_member.rna(),
            gravity_m_per_s2,
            ..TowerDescription::default()
        });
        let whole = whole.expect("a tower");
        let modes = |method| {
            let (own, expected) = (modes_of(&on_member, method), modes_of(&whole, method));
            own.into_iter().zip(expected)
        };
        for (own, expected) in modes(Method::Spectral) {
            assert_eq!(own.0, expected.0);
            assert!(
                (own.1 / expected.1 - 1.0).abs() < 1e-11,
                "{own:?}, expected {expected:?}"
            );
        }
        for method in [Method::RmjeExact, Method::Bmodes] {
            for (own, expected) in modes(method) {
                let error = (own.1 / expected.1 - 1.0).abs();
                assert!(error < 1e-3, "{method:?}: {own:?}, {expected:?}");
            }
        }
    }
}

#[test]
fn frequencies_do_not_depend_on_the_reference_point_of_a_transition_piece() {
    let legs = [
        [-5.0, -5.0, -10.0],
        [5.0, -5.0, -10.0],
        [0.0, 5.0, -11.0],
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [0.0, 1.0, 0.5],
    ];
    let jacket = frame(&legs, &[[0, 3], [1, 4], [2, 5], [0, 4], [1, 5]], &[0, 1, 2]);
    let pile = frame(&VERTICAL, &[[0, 1]], &[0]);
    for (below, joints) in [(jacket, vec![3, 4, 5]), (pile, vec![1])] {
        let about = |reference_m: f64| {
            let mut frame = below.clone();
            frame.transition = Some(Transition {
                position_m: [0.0, 0.0, reference_m],
                joints: joints.clone(),
                is_held: false,
            });
            let frame = Frame::new(frame).expect("a frame");
            let platform = RigidBody::point(5e4, [0.3, 0.0, 1.0 - reference_m]);
            let foundation = FrameFoundation::new(frame, platform).expect("a foundation");
            let tower = tower_on(Foundation::Frame(Box::new(foundation)), 0.5, 9.81);
            modes_of(&tower, Method::Spectral)
        };
        let at_joints = about(0.0);
        for reference_m in [-9.0, 0.5, 4.0] {
            for (own, expected) in about(reference_m).iter().zip(&at_joints) {
                assert_eq!(own.0, expected.0);
                assert!(
                    (own.1 / expected.1 - 1.0).abs() < 1e-11,
                    "reference at {reference_m} m: {own:?}, expected {expected:?}"
                );
            }
        }
    }
}

#[test]
fn water_and_growth_on_a_member_are_those_of_a_tower() {
    let mut below = frame(&VERTICAL, &[[0, 1]], &[0]);
    below.members[0].shears = false;
    let bare = carried(below.clone(), &[1], [0.0; 3]);
    below.members[0].coats = vec![FrameCoat {
        range: [0.25, 0.75],
        kind: CoatKind::AddedMass {
            density_kg_per_m3: 1025.0,
            radius_m: [1.0; 2],
            across: [1.0; 2],
            along: [0.0; 2],
        },
    }];
    let coated = carried(below.clone(), &[1], [0.0; 3]);
    below.members[0].coats.clear();
    // The same as many small bodies: the middle of each of 100 parts.
    let mass_kg = 1025.0 * std::f64::consts::PI * 10.0 / 100.0;
    let mut inertia = [[0.0; 6]; 6];
    (inertia[0][0], inertia[1][1]) = (mass_kg, mass_kg);
    below.riders = (0..100)
        .map(|k| FrameRider {
            member: 0,
            fraction: 0.25 + 0.5 * (f64::from(k) + 0.5) / 100.0,
            inertia,
        })
        .collect();
    let ridden = carried(below, &[1], [0.0; 3]);
    let first = |foundation| modes_of(&tower_on(foundation, 0.0, 0.0), Method::Spectral);
    let (bare, coated, ridden) = (first(bare), first(coated), first(ridden));
    for ((bare, coated), ridden) in bare.iter().zip(&coated).zip(&ridden).take(6) {
        assert!(coated.1 < bare.1 * (1.0 + 1e-12));
        let (by_coat, by_riders) = (bare.1 - coated.1, bare.1 - ridden.1);
        assert!(
            (by_coat - by_riders).abs() < 1e-4 * by_coat + 1e-10 * bare.1,
            "{by_coat} {by_riders}"
        );
    }
}

/// Water that carries the whole weight of a member leaves no force in it, so gravity changes no
/// frequency; half of it has half the effect, to first order.
#[test]
fn a_member_that_water_carries_is_not_softened_by_its_weight() {
    let density = 1025.0;
    let hz = |gravity_m_per_s2: f64, carried: f64| {
        let mut description = frame(&VERTICAL, &[[0, 1]], &[0]);
        let mass_kg = Frame::new(description.clone()).expect("a frame").mass_kg();
        let radius_m = (carried * mass_kg / 20.0 / (density * std::f64::consts::PI)).sqrt();
        // With this coefficient the mass of the water does not depend on what it carries.
        let across = if carried > 0.0 { 1.0 / carried } else { 1.0 };
        description.members[0].coats = vec![FrameCoat {
            range: [0.0, 1.0],
            kind: CoatKind::AddedMass {
                density_kg_per_m3: density,
                radius_m: [radius_m; 2],
                across: [across; 2],
                along: [0.0; 2],
            },
        }];
        let frame = Frame::new(description).expect("a frame");
        let options = FrameOptions {
            modes: 2,
            gravity_m_per_s2,
            ..FrameOptions::default()
        };
        solve_frame(&frame, &options).expect("a solution").modes[0].frequency_hz
    };
    let (still, half, whole) = (hz(0.0, 1.0), hz(9.81, 0.5), hz(9.81, 1.0));
    assert!((whole / still - 1.0).abs() < 1e-12, "{whole}, {still}");
    // Of the weight in air, as of half of it with twice the gravity.
    let twice = hz(19.62, 0.5);
    assert!((half / hz(4.905, 1e-12) - 1.0).abs() < 1e-10);
    assert!(twice < half && half < still, "{twice}, {half}, {still}");
}

#[test]
fn a_very_stiff_jacket_is_a_clamp() {
    let legs = [
        [-5.0, -5.0, -10.0],
        [5.0, -5.0, -10.0],
        [0.0, 5.0, -10.0],
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    let mut jacket = frame(&legs, &[[0, 3], [1, 4], [2, 5], [0, 4], [1, 5]], &[0, 1, 2]);
    for member in &mut jacket.members {
        let MemberKind::Beam { material, .. } = &mut member.kind else {
            continue;
        };
        material.youngs_modulus_pa *= 1e6;
        material.shear_modulus_pa *= 1e6;
    }
    let stiff = tower_on(carried(jacket, &[3, 4, 5], [0.0; 3]), 0.0, 0.0);
    let clamped = tower_on(Foundation::Clamped, 0.0, 0.0);
    let own = modes_of(&stiff, Method::Spectral);
    for (own, expected) in own.iter().zip(modes_of(&clamped, Method::Spectral)) {
        assert!(
            (own.1 / expected.1 - 1.0).abs() < 1e-4,
            "{own:?}, expected {expected:?}"
        );
    }
}

#[test]
fn a_frame_reduced_to_its_transition_piece_has_the_counts_of_the_whole() {
    let description = || {
        let mut three = frame(&BENT, &[[0, 1], [1, 2], [3, 1], [2, 3]], &[3]);
        three.supports.push(soil(0));
        three
    };
    let body = RigidBody {
        mass_kg: 4e5,
        center_m: [3.0, -2.0, 20.0],
        inertia_kg_m2: Inertia::from_tensor([[4e7, 0.0, 0.0], [0.0, 3e7, 0.0], [0.0, 0.0, 2e7]]),
    };
    let mut whole = description();
    whole.masses.push((2, body));
    let whole = Frame::new(whole).expect("a frame");
    let Foundation::Frame(foundation) = carried(description(), &[2], [0.0; 3]) else {
        panic!("a frame");
    };
    let nothing = [[0.0; 6]; 6];
    let mut below = FrameBelow::new(&foundation, (0.0, 0.0), &nothing, 8).expect("equations");
    // The centre moves by v + θ × c.
    let [x, y, z] = body.center_m;
    let center = [
        [1.0, 0.0, 0.0, 0.0, z, -y],
        [0.0, 1.0, 0.0, -z, 0.0, x],
        [0.0, 0.0, 1.0, y, -x, 0.0],
    ];
    let own = [0.0, 0.0, 0.0, 4e7, 3e7, 2e7];
    let entry = |i: usize, j: usize| {
        let moved: f64 = center.iter().map(|row| row[i] * row[j]).sum();
        body.mass_kg * moved + if i == j { own[i] } else { 0.0 }
    };
    let inertia: [[f64; 6]; 6] = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
    let degree = FrameRecipe::Spectral { degree: 8 };
    for k in 0..200 {
        let hz = 0.05 * 1.04_f64.powi(k);
        let lambda = (std::f64::consts::TAU * hz).powi(2);
        let reduced = below.seen_from_base(-lambda);
        let sum: [[f64; 6]; 6] = std::array::from_fn(|i| {
            std::array::from_fn(|j| reduced.stiffness[i][j] - lambda * inertia[i][j])
        });
        let (values, _) = towermodes::space::eigenpairs(sum);
        let count = reduced.count + values.iter().filter(|value| **value < 0.0).count();
        let expected = count_frame_modes(&whole, degree, hz).expect("a count");
        assert_eq!(count, expected, "{hz} Hz");
    }
}

/// Members that are too soft are no mechanism: no joint is free.
#[test]
fn a_frame_that_is_too_soft_is_refused() {
    let mut soft = frame(&HALVES, &IN_LINE, &[0]);
    for member in &mut soft.members {
        if let MemberKind::Beam { material, .. } = &mut member.kind {
            *material = Material::from_shear_modulus(7850.0, 0.021, 0.0081);
        }
    }
    let soft = Frame::new(soft).expect("a frame");
    let refused = solve_frame(&soft, &FrameOptions::default()).expect_err("too soft");
    let refused = refused.to_string();
    assert!(
        refused.starts_with("the members of the frame are too soft for their mass"),
        "{refused}"
    );
}

/// Each warning on both sides of its limit; the one frame that is furthest off is named.
#[test]
fn members_that_are_probably_mistakes_are_warned_of() {
    let said = |change: &dyn Fn(&mut FrameDescription)| {
        let mut description = frame(&HALVES, &IN_LINE, &[0]);
        change(&mut description);
        let frame = Frame::new(description).expect("a frame");
        let warnings = frame.warnings().into_iter();
        warnings
            .map(|warning| warning.to_string())
            .collect::<Vec<_>>()
    };
    let tubes = |outer_diameter_m: f64, wall_thickness_m: f64| {
        move |frame: &mut FrameDescription| {
            for (k, name) in ["1", "2"].into_iter().enumerate() {
                let ends = frame.members[k].joints;
                frame.members[k] = of_section(name, ends, outer_diameter_m, wall_thickness_m);
            }
        }
    };
    let moduli = |e: f64, g: f64| {
        move |frame: &mut FrameDescription| {
            if let MemberKind::Beam { material, .. } = &mut frame.members[1].kind {
                *material = Material::from_shear_modulus(7850.0, e, g);
            }
        }
    };
    let density = |density_kg_per_m3: f64| {
        move |frame: &mut FrameDescription| {
            for member in &mut frame.members {
                if let MemberKind::Beam { material, .. } = &mut member.kind {
                    material.density_kg_per_m3 = density_kg_per_m3;
                }
            }
        }
    };
    let quiet: [&dyn Fn(&mut FrameDescription); 10] = [
        &|_| {},
        &tubes(3.0, 0.0101),
        &tubes(3.0, 0.99),
        &tubes(3.0, 1.5),
        &tubes(29.0, 0.1),
        &moduli(1e9, 4e8),
        &density(0.0),
        &density(1.0),
        &density(2400.0),
        &|frame| frame.joints[2].position_m[0] += 190.0,
    ];
    for (k, change) in quiet.into_iter().enumerate() {
        assert_eq!(said(change), [""; 0], "{k}");
    }
    type Odd<'a> = (&'a dyn Fn(&mut FrameDescription), &'a str);
    let odd: [Odd<'_>; 9] = [
        (
            &tubes(3.0, 0.0099),
            "member 1 (and another one): wall 0.0099 m is 1/303.03 of the diameter 3 m; expected 1/3 to 1/300",
        ),
        (
            &tubes(3.0, 1.1),
            "member 1 (and another one): wall 1.1 m is 1/2.72727 of the diameter 3 m",
        ),
        (
            &tubes(31.0, 0.2),
            "member 1 (and another one): outer diameter 31 m is larger than 30 m",
        ),
        (
            &density(7.85),
            "member 1 (and another one): the density is 7.85 kg/m3, less than that of any structural material (steel: 7850)",
        ),
        (
            &moduli(210.0, 81.0),
            "member 2: Young's modulus is 210 Pa; expected 1e9 to 1e17 Pa",
        ),
        (
            &moduli(8.08e10, 2.1e11),
            "member 2: the shear modulus 2.1e11 Pa is larger than Young's modulus 8.08e10 Pa",
        ),
        (
            &|frame| frame.joints[2].position_m[0] += 210.0,
            "member 2 is 2",
        ),
        (
            &|frame| frame.members.push(tube("again", [1, 0])),
            "members 1 and again are between the same two joints",
        ),
        (
            &|frame| {
                frame
                    .joints
                    .iter_mut()
                    .for_each(|joint| joint.position_m[1] = -2e3);
            },
            "joint 1 (and 2 others) is at -2000 m, more than 1 km from the origin",
        ),
    ];
    for (change, expected) in odd {
        let found = said(change);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].starts_with(expected), "{found:?}");
    }
}

#[test]
fn a_mechanism_under_a_tower_is_refused_with_its_joint() {
    let pin = JointKind::Pin {
        axis: [0.0, 1.0, 0.0],
        stiffness_n_m_per_rad: 0.0,
    };
    let pinned = with_joint(frame(&HALVES, &IN_LINE, &[0]), 1, pin);
    let mut rotating = frame(&HALVES, &IN_LINE, &[0]);
    rotating.supports[0].fixed[3] = false;
    let mut loose = frame(&HALVES, &IN_LINE, &[0]);
    loose.supports[0].fixed = [false; 6];
    let cases = [
        (
            pinned,
            "the frame is a mechanism: 1 motion has no stiffness; the first moves joint 2 about y",
        ),
        (
            rotating,
            "the frame is a mechanism: 1 motion has no stiffness; the first moves joint 1 about x",
        ),
        (loose, "the frame is not supported"),
    ];
    for (description, expected) in cases {
        for (gravity_m_per_s2, method) in [
            (0.0, Method::Spectral),
            (9.81, Method::Spectral),
            (9.81, Method::RmjeExact),
        ] {
            let foundation = carried(description.clone(), &[2], [0.0; 3]);
            let tower = tower_on(foundation, 0.0, gravity_m_per_s2);
            let options = Options {
                method,
                ..Options::default()
            };
            let refused = solve(&tower, &options)
                .expect_err("a mechanism")
                .to_string();
            assert!(refused.starts_with(expected), "{refused}");
        }
    }
}

#[test]
fn local_modes_of_braces_have_names_of_their_own() {
    let labels = |modes: usize| -> Vec<String> {
        let tower = towermodes_random::Lattice::jacket().with_tower();
        let options = Options {
            modes,
            ..Options::default()
        };
        let solution = solve(&tower, &options).expect("a solution");
        solution.modes.iter().map(towermodes::Mode::label).collect()
    };
    let all = labels(16);
    for (label, expected) in all.iter().zip(["1st side-side", "1st fore-aft"]) {
        assert!(label.starts_with(expected), "{all:?}");
    }
    let local: Vec<&String> = all.iter().filter(|l| l.contains("local")).collect();
    for (k, label) in local.iter().enumerate() {
        let ordinal = towermodes::modes::Ordinal(k + 1);
        assert_eq!(
            **label,
            format!("{ordinal} local substructure bending"),
            "{all:?}"
        );
    }
    assert!(local.len() > 3, "{all:?}");
    // A longer list changes no name.
    assert_eq!(labels(9), all[..9]);
}

/// A member has the same modes with elements of the highest degree as with those of degree 16.
#[test]
fn the_highest_degree_has_no_rounding_errors_above_those_of_the_eigenvalues() {
    let frame = Frame::new(frame(&HALVES, &IN_LINE, &[0])).expect("a frame");
    let [low, high] = [16, towermodes::MAX_DEGREE].map(|degree| {
        let options = FrameOptions {
            recipe: Some(FrameRecipe::Spectral { degree }),
            ..FrameOptions::default()
        };
        solve_frame(&frame, &options).unwrap_or_else(|error| panic!("{error}"))
    });
    for (low, high) in low.modes.iter().zip(&high.modes) {
        let change = (low.frequency_hz / high.frequency_hz - 1.0).abs();
        assert!(change < 1e-9, "{} Hz: {change:e}", low.frequency_hz);
    }
    let degree = towermodes::MAX_DEGREE + 1;
    let options = FrameOptions {
        recipe: Some(FrameRecipe::Spectral { degree }),
        ..FrameOptions::default()
    };
    let refused = solve_frame(&frame, &options)
        .expect_err("a degree")
        .to_string();
    assert!(refused.contains("from 2 to 60"), "{refused}");
}
