//! Weights, buoyancy and lines of a floating tower: what they leave, and where they are in balance.

use towermodes::mooring::{LineType, MooringDescription, MooringError, MooringLine, MooringPoint};
use towermodes::{
    Buoyancy, EquilibriumError, EquilibriumPose, FloatingPlatform, MooringLines, Options, Place,
    PointMass, Problem, ReferredMatrix, Rna, StaticBalance, Tower, TowerDescription, Warning,
    solve,
};
use towermodes_testing::Close;

use super::platform_of;
use crate::towers::floater;

const GRAVITY: f64 = 9.81;

/// A tower on a spar with its rotor-nacelle assembly 2 m downwind of the axis and a mass on the
/// tower, held by a matrix.
fn spar() -> TowerDescription {
    let mut description = TowerDescription {
        rna: Rna {
            center_m: [2.0, 0.0, 1.5],
            ..Rna::point(3e5)
        },
        point_masses: vec![PointMass {
            mass_kg: 4e4,
            height_m: 50.0,
            ..PointMass::default()
        }],
        gravity_m_per_s2: GRAVITY,
        ..floater()
    };
    platform_of(&mut description).buoyancy = Some(Buoyancy {
        force_n: 8.1e7,
        center_m: [0.0, 0.0],
    });
    description
}

fn with(change: impl FnOnce(&mut FloatingPlatform)) -> TowerDescription {
    let mut description = spar();
    change(platform_of(&mut description));
    description
}

/// Three lines from the spar to the seabed, the first turned from the x axis.
fn lines(turned_deg: f64, depth_m: f64, fairlead_m: f64) -> Box<MooringLines> {
    let mut spar = MooringDescription {
        depth_m,
        gravity_m_per_s2: GRAVITY,
        line_types: vec![LineType::new(0.09, 77.7066, 384.243e6)],
        ..MooringDescription::default()
    };
    for angle_deg in [0.0_f64, 120.0, 240.0] {
        let (sin, cos) = (angle_deg + turned_deg).to_radians().sin_cos();
        let at = |radius: f64, z: f64| [radius * cos, radius * sin, z];
        let anchor = spar.points.len();
        spar.points.push(MooringPoint::anchor(at(853.87, -depth_m)));
        spar.points
            .push(MooringPoint::fairlead(at(5.2, fairlead_m)));
        spar.lines.push(MooringLine {
            line_type: 0,
            length_m: 902.2,
            points: [anchor, anchor + 1],
        });
    }
    Box::new(MooringLines {
        description: spar,
        still_water_m: 0.0,
    })
}

fn moored(turned_deg: f64) -> TowerDescription {
    with(|platform| {
        platform.mooring = ReferredMatrix::default();
        platform.mooring_lines = Some(lines(turned_deg, 320.0, -70.0));
    })
}

fn balance(description: &TowerDescription) -> StaticBalance {
    let tower = Tower::new(description.clone()).expect("a floating tower");
    tower.static_balance().expect("its buoyancy is known")
}

fn pose(description: &TowerDescription) -> EquilibriumPose {
    balance(description).equilibrium.expect("an equilibrium")
}

fn frequencies_hz(description: &TowerDescription) -> Vec<f64> {
    let tower = Tower::new(description.clone()).expect("a floating tower");
    let solution = solve(&tower, &Options::default()).expect("modes");
    solution.modes.iter().map(|m| m.frequency_hz).collect()
}

#[track_caller]
fn assert_same(found_hz: &[f64], expected_hz: &[f64], tolerance: f64) {
    for (found, expected) in found_hz.iter().zip(expected_hz) {
        assert!(
            (found / expected - 1.0).abs() < tolerance,
            "{found_hz:?} {expected_hz:?}"
        );
    }
}

/// By hand: forces, moments about the axis, and heave and tilt by springs alone. The matrices of
/// this spar couple heave with nothing and pitch with surge only, where there is no force.
#[test]
fn balance_and_equilibrium_follow_by_hand() {
    let description = spar();
    let tower = Tower::new(description.clone()).expect("a tower");
    let balance = balance(&description);
    balance.platform_weight_n.close_to(7.5e6 * GRAVITY, 1e-12);
    balance
        .tower_weight_n
        .close_to(tower.mass_kg() * GRAVITY, 1e-12);
    balance.rna_weight_n.close_to(3e5 * GRAVITY, 1e-12);
    let left_n = 8.1e7 - (7.8e6 + tower.mass_kg()) * GRAVITY;
    balance.residual_force_n[2].close_to(left_n, 1e-9);
    balance
        .residual_share()
        .close_to(left_n / balance.weight_n(), 1e-12);
    // The assembly tilts the spar downwind: about +y.
    let tilting_n_m = 3e5 * GRAVITY * 2.0;
    balance.residual_moment_n_m[1].close_to(tilting_n_m, 1e-9);
    assert_eq!(balance.lines_n, 0.0);

    let pose = balance.equilibrium.expect("an equilibrium");
    let platform = description.foundation.platform().expect("a platform");
    let (water, mooring) = (&platform.hydrostatic.matrix, &platform.mooring.matrix);
    pose.heave_m
        .close_to(left_n / (water[2][2] + mooring[2][2]), 1e-12);
    // Heights of masses above the point of the matrices, which is still water.
    assert_eq!(
        (platform.hydrostatic.height_m, platform.mooring.height_m),
        (0.0, 0.0)
    );
    let moment_kg_m: f64 = tower
        .pieces()
        .iter()
        .map(|piece| {
            // Simpson's rule with many points is exact to the digits compared.
            let (n, length_m) = (2000, piece.length_m());
            let at = |i: usize| {
                let z = piece.base_m + length_m * i as f64 / n as f64;
                piece.section_at(z).masses.mass_kg_per_m * z
            };
            let inner: f64 = (1..n)
                .map(|i| at(i) * if i % 2 == 1 { 4.0 } else { 2.0 })
                .sum();
            (at(0) + inner + at(n)) * length_m / (3 * n) as f64
        })
        .sum();
    let top_kg_m = 3e5 * (tower.top_m() + 1.5);
    let weights = GRAVITY * (7.5e6 * -90.0 + moment_kg_m + 4e4 * 50.0 + top_kg_m);
    let own = water[4][4] + mooring[4][4] - weights;
    let coupling = mooring[0][4] + water[0][4];
    let tilt = tilting_n_m / (own - coupling * coupling / mooring[0][0]);
    pose.pitch_deg.close_to(tilt.to_degrees(), 1e-9);
    let surge = -coupling * tilt / mooring[0][0];
    pose.surge_m.close_to(surge, 1e-9);
}

/// At the equilibrium nothing is left: a platform that is balanced at its reference position has
/// the same modes with its lines at the equilibrium.
#[test]
fn a_balanced_tower_has_the_same_modes_at_its_equilibrium() {
    let mut description = moored(17.0);
    let first = balance(&description);
    let [_, _, force_n] = first.residual_force_n;
    let [about_x, about_y, _] = first.residual_moment_n_m;
    let buoyancy_n = first.buoyancy_n - force_n;
    platform_of(&mut description).buoyancy = Some(Buoyancy {
        force_n: buoyancy_n,
        center_m: [about_y / buoyancy_n, -about_x / buoyancy_n],
    });
    let left = balance(&description);
    assert!(
        left.residual_force_n.iter().all(|force| force.abs() < 1e-5),
        "{left:?}"
    );
    let at_reference = frequencies_hz(&description);
    platform_of(&mut description).at_equilibrium = true;
    assert!(balance(&description).linearized_at_equilibrium);
    assert_same(&frequencies_hz(&description), &at_reference, 1e-11);
}

/// A spar that is too light rises by its excess over the stiffness of water and lines. A sea that
/// is as much deeper, with the fairleads where they were, holds it by the same lines.
#[test]
fn lines_at_the_equilibrium_are_those_of_a_deeper_sea() {
    let mut light = moored(0.0);
    light.rna.center_m = [0.0, 0.0, 1.5];
    let platform = platform_of(&mut light);
    platform.at_equilibrium = true;
    platform.buoyancy = Some(Buoyancy {
        force_n: 8.13e7,
        center_m: [0.0; 2],
    });
    let rise_m = pose(&light).heave_m;
    assert!(rise_m.abs() > 0.5, "{rise_m}");
    let mut deeper = light.clone();
    let platform = platform_of(&mut deeper);
    platform.at_equilibrium = false;
    let mut in_deeper = lines(0.0, 320.0 + rise_m, -70.0);
    for point in &mut in_deeper.description.points {
        if point.position_m[2] < -100.0 {
            point.position_m[2] = -320.0 - rise_m;
        }
    }
    platform.mooring_lines = Some(in_deeper);
    assert_same(&frequencies_hz(&light), &frequencies_hz(&deeper), 1e-11);
    // The lines alone balance what the water does not.
    let buoyancy = platform_of(&mut deeper)
        .buoyancy
        .as_mut()
        .expect("it is given");
    buoyancy.force_n -= 3.3e5 * rise_m;
    let left_n = balance(&deeper).residual_force_n[2];
    assert!(left_n.abs() < 1e-3, "{left_n}");
}

/// Turned lines and masses turn the equilibrium.
#[test]
fn the_equilibrium_turns_with_the_tower() {
    let straight = pose(&moored(0.0));
    let mut turned = moored(90.0);
    turned.rna.center_m = [0.0, 2.0, 1.5];
    let turned = pose(&turned);
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "{straight:?} {turned:?}");
    assert!(straight.pitch_deg > 0.1, "{straight:?}");
    close(turned.sway_m, straight.surge_m);
    close(turned.surge_m, -straight.sway_m);
    close(turned.heave_m, straight.heave_m);
    close(turned.roll_deg, -straight.pitch_deg);
    close(turned.pitch_deg, straight.roll_deg);
    close(turned.yaw_deg, straight.yaw_deg);
}

#[test]
fn an_unknown_balance_is_no_balance() {
    let without_gravity = TowerDescription {
        gravity_m_per_s2: 0.0,
        ..spar()
    };
    for description in [with(|platform| platform.buoyancy = None), without_gravity] {
        let tower = Tower::new(description).expect("a tower");
        assert_eq!(tower.static_balance(), None);
    }
}

#[test]
fn a_tower_that_is_out_of_balance_is_reported() {
    let tower = Tower::new(with(|platform| {
        platform.buoyancy = Some(Buoyancy {
            force_n: 9e7,
            center_m: [0.0; 2],
        });
    }));
    let tower = tower.expect("a tower");
    let share = tower.static_balance().expect("a balance").residual_share();
    let warned = tower.warnings().iter().find_map(|warning| match warning {
        Warning::OutOfBalance { share, .. } => Some(*share),
        _ => None,
    });
    assert_eq!(warned, Some(share));
}

fn refused(change: impl FnOnce(&mut TowerDescription)) -> EquilibriumError {
    let mut description = moored(0.0);
    platform_of(&mut description).at_equilibrium = true;
    change(&mut description);
    let error = Tower::new(description).expect_err("no equilibrium");
    let key = "at_equilibrium";
    assert_eq!(error.place, Place::Foundation { key });
    match error.problem {
        Problem::Equilibrium(mistake) => mistake,
        other => panic!("{other}"),
    }
}

#[test]
fn a_tower_without_equilibrium_is_refused() {
    let unknown = refused(|tower| platform_of(tower).buoyancy = None);
    assert_eq!(unknown, EquilibriumError::NoBuoyancy);
    let weightless = refused(|tower| tower.gravity_m_per_s2 = 0.0);
    assert_eq!(weightless, EquilibriumError::NoGravity);
    let tilting = refused(|tower| {
        *tower = with(|platform| platform.at_equilibrium = true);
        tower.rna.center_m[0] = 200.0;
    });
    assert!(
        matches!(tilting, EquilibriumError::Tilts { .. }),
        "{tilting}"
    );
    // Without a water plane the lines alone stop it, when they are stretched to their end.
    let rising = refused(|tower| {
        let platform = platform_of(tower);
        platform.hydrostatic.matrix[2][2] = 0.0;
        for rotation in [3, 4] {
            platform.mooring.matrix[rotation][rotation] = 1e13;
        }
        platform.buoyancy = Some(Buoyancy {
            force_n: 3e9,
            center_m: [0.0; 2],
        });
    });
    let breaks = |error: &EquilibriumError| {
        matches!(
            error,
            EquilibriumError::Lines(MooringError::TooShort { .. })
        )
    };
    assert!(breaks(&rising), "{rising}");
    let sinking = refused(|tower| {
        let platform = platform_of(tower);
        for (motion, stiffness) in [(2, 0.0), (3, 1e10), (4, 1e10)] {
            platform.hydrostatic.matrix[motion][motion] = stiffness;
        }
        platform.mooring_lines = None;
    });
    assert!(
        matches!(
            sinking,
            EquilibriumError::NotHeld {
                motion: "heave",
                ..
            }
        ),
        "{sinking}"
    );
    let turning = refused(|tower| tower.rna.center_m[2] = 1e4);
    assert!(
        matches!(turning, EquilibriumError::Unstable { .. }),
        "{turning}"
    );
}

/// Where modes are found, the reference position is stable: the error then says that a stiffness is
/// negative elsewhere, to where the forces move the platform.
#[test]
fn a_stable_tower_is_not_unstable_where_it_is() {
    let mut away = 0;
    for softer in 0..30 {
        for force_n in [2e7, 5e7, 8.1e7] {
            let mut description = moored(0.0);
            let platform = platform_of(&mut description);
            for rotation in [3, 4] {
                platform.hydrostatic.matrix[rotation][rotation] -= 1e8 * f64::from(softer);
            }
            platform.buoyancy = Some(Buoyancy {
                force_n,
                center_m: [0.0; 2],
            });
            let tower = Tower::new(description).expect("a floating tower");
            let is_stable = solve(&tower, &Options::default()).is_ok();
            let balance = tower.static_balance().expect("its buoyancy is known");
            match balance.equilibrium {
                Err(EquilibriumError::Unstable { motion }) => {
                    assert!(
                        !is_stable,
                        "softer by {softer}e8 N m, {force_n} N: {motion}"
                    );
                }
                Err(EquilibriumError::UnstableAway { shift_m, .. }) => {
                    assert!(shift_m > 0.0);
                    away += usize::from(is_stable);
                }
                _ => {}
            }
        }
    }
    assert!(away > 0, "none is stable at the reference position alone");
}
