//! Modes of turning turbines: names and shares of energy of an independent program, shapes that
//! keep to kinematics, lists that counts check.

use super::{FINE, SECTION, blade, model, rad_per_s, straight, tilted, tower};
use towermodes::turbine::Complex;
use towermodes::turbine::{
    BladeMotion, Harmonic, Turbine, TurbineDescription, TurbineMesh, TurbineMode, TurbineModel,
    TurbineModes, TurbinePart,
};
use towermodes::{Blade, Solver};
use towermodes_testing::changed;

fn modes(machine: TurbineDescription, rpm: f64) -> TurbineModes {
    model(machine).modes(4.0, rpm).expect("modes")
}

fn free(mut machine: TurbineDescription) -> TurbineDescription {
    machine.generator.is_locked = false;
    machine
}

fn names(modes: &TurbineModes) -> Vec<String> {
    modes
        .modes
        .iter()
        .map(|mode| mode.name.to_string())
        .collect()
}

/// The dominant parts that the other program gives with its frequencies; of yaw and tilt at rest,
/// which it gives as such, the lower becomes the backward whirl.
#[test]
fn names_are_those_of_the_dominant_energy() {
    let at_rest = [
        "1st tower side-side",
        "1st tower fore-aft",
        "1st drivetrain torsion",
        "1st flapwise backward whirl",
        "1st flapwise forward whirl",
        "1st flapwise collective",
    ];
    let still = modes(straight(), 0.0);
    assert_eq!(names(&still)[..6], at_rest);
    let labels: Vec<String> = still.modes.iter().map(TurbineMode::label).collect();
    assert_eq!(labels[3], "1st flapwise backward whirl (yaw)");
    assert_eq!(labels[4], "1st flapwise forward whirl (tilt)");
    let turning = [
        "1st tower fore-aft",
        "1st tower side-side",
        "1st flapwise backward whirl",
        "1st drivetrain torsion",
        "1st flapwise collective",
        "1st edgewise backward whirl",
        "1st flapwise forward whirl",
        "1st edgewise forward whirl",
        "2nd tower side-side",
        "2nd tower fore-aft",
        "2nd flapwise backward whirl",
    ];
    assert_eq!(names(&modes(straight(), 18.0)), turning);
}

fn share(mode: &TurbineMode, part: TurbinePart) -> f64 {
    let parts = mode.energy.parts().into_iter();
    let own = parts.filter(|(other, _)| *other == part);
    own.map(|(_, share)| share).sum()
}

/// The other program gives whole percents.
#[test]
fn shares_are_those_of_the_other_program() {
    let flap_backward = TurbinePart::Blades(BladeMotion::Flap, Harmonic::Backward);
    let edge_collective = TurbinePart::Blades(BladeMotion::Edge, Harmonic::Collective);
    let turning = modes(straight(), 18.0);
    for (mode, part, percent) in [
        (&turning.modes[0], flap_backward, 11.0),
        (&turning.modes[10], flap_backward, 51.0),
        (
            &modes(straight(), 0.0).modes[10],
            TurbinePart::TowerTorsion,
            43.0,
        ),
        (
            &modes(free(straight()), 0.0).modes[7],
            TurbinePart::Shaft,
            71.0,
        ),
        (
            &modes(free(straight()), 0.0).modes[7],
            edge_collective,
            29.0,
        ),
    ] {
        let own = 100.0 * share(mode, part);
        assert!((own - percent).abs() <= 0.6, "{}: {own} {part}", mode.name);
    }
}

#[test]
fn shares_sum_to_one_and_name_their_modes() {
    for mode in modes(tilted(), 12.0).modes {
        let parts = mode.energy.parts();
        let sum: f64 = parts.iter().map(|(_, share)| share).sum();
        assert!((sum - 1.0).abs() < 1e-12, "{}: {sum}", mode.name);
        assert!(parts.iter().all(|(_, share)| *share >= 0.0));
        assert_eq!(share(&mode, mode.name.part), mode.share, "{}", mode.name);
        let (second, of_second) = mode.second.expect("a second part");
        assert_eq!(share(&mode, second), of_second, "{}", mode.name);
        assert!(second != mode.name.part && of_second <= 0.5);
    }
}

/// Each name is that of one mode at a speed, and a longer list does not change it; at 0.01 and 1
/// rpm the names are those at rest.
#[test]
fn names_are_given_once_and_do_not_depend_on_the_list() {
    for machine in [straight(), tilted(), free(straight())] {
        let mut model = model(machine);
        let mut names_at = |limit_hz, rpm| names(&model.modes(limit_hz, rpm).expect("modes"));
        let at_rest = names_at(4.0, 0.0);
        for rpm in [0.01, 1.0] {
            assert_eq!(names_at(4.0, rpm), at_rest, "{rpm} rpm");
        }
        for rpm in [0.0, 3.0, 12.0, 16.0] {
            let all = names_at(4.0, rpm);
            let mut once = all.clone();
            once.sort();
            once.dedup();
            assert_eq!(once.len(), all.len(), "{all:?}");
            let some = names_at(1.5, rpm);
            assert_eq!(some, all[..some.len()], "{rpm} rpm");
        }
    }
}

/// From the modes at other speeds or from nothing: the same digits.
#[test]
fn digits_do_not_depend_on_where_the_search_begins() {
    let mut model = model(tilted());
    let before = [0.0, 8.0].map(|rpm| model.modes(4.0, rpm).expect("modes"));
    let near = model.modes_from(4.0, 12.0, &before).expect("modes");
    let alone = model.modes(4.0, 12.0).expect("modes");
    assert_eq!(names(&near), names(&alone));
    for (a, b) in near.modes.iter().zip(&alone.modes) {
        let [a_hz, b_hz] = [a, b].map(|mode| mode.frequency.frequency_hz);
        let holds = (a_hz / b_hz - 1.0).abs() < 1e-12;
        assert!(holds, "{}: {a_hz} {b_hz}", a.name);
        assert!((a.mac(b) - 1.0).abs() < 1e-9, "{}", a.name);
        for mode in [a, b] {
            let frequency = &mode.frequency;
            let width = frequency.upper_hz - frequency.lower_hz;
            assert!(width <= 5e-10 * frequency.frequency_hz);
            assert!(frequency.lower_hz <= frequency.frequency_hz);
            assert!(frequency.frequency_hz <= frequency.upper_hz);
        }
    }
}

#[test]
fn modes_at_near_speeds_are_alike_and_modes_at_one_speed_are_not() {
    let mut model = model(straight());
    let [a, b] = [14.0, 14.2].map(|rpm| model.modes(3.5, rpm).expect("modes"));
    for (i, mode) in a.modes.iter().enumerate() {
        assert!((mode.mac(mode) - 1.0).abs() < 1e-12);
        assert!(mode.mac(&b.modes[i]) > 0.99, "{}", mode.name);
        let others = a.modes.iter().enumerate().filter(|(j, _)| *j != i);
        assert!(others.into_iter().all(|(_, other)| mode.mac(other) < 0.1));
    }
}

/// One mode removed by hand, whichever: counts notice it, and where it was.
#[test]
fn a_missed_mode_is_noticed() {
    for machine in [straight(), free(tilted())] {
        let mut model = model(machine);
        let whole = model.modes(4.0, 12.0).expect("modes");
        assert_eq!(model.recount(&whole), Ok(()));
        for index in 0..whole.modes.len() {
            let mut list = whole.clone();
            let removed = list.modes.remove(index).frequency.frequency_hz;
            let missed = model.recount(&list).expect_err("one is missing");
            assert!(missed.from_hz < removed && removed < missed.to_hz);
            assert_eq!((missed.counted, missed.listed), (1, 0));
            let mut list = whole.clone();
            list.modes.insert(index, list.modes[index].clone());
            model.recount(&list).expect_err("one is in the list twice");
        }
    }
}

fn difference(a: [Complex; 3], b: [Complex; 3]) -> f64 {
    let squares = a
        .iter()
        .zip(&b)
        .map(|(a, b)| (a.re - b.re).powi(2) + (a.im - b.im).powi(2));
    squares.sum::<f64>().sqrt()
}

fn times(x: Complex, factor: f64) -> Complex {
    Complex::new(factor * x.re, factor * x.im)
}

/// u + θ × r.
fn moved(motion: &[Complex; 6], r: [f64; 3]) -> [Complex; 3] {
    let theta = &motion[3..];
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        motion[i] + times(theta[j], r[k]) - times(theta[k], r[j])
    })
}

/// The apex moves with the tower top, and the roots of the blades with the apex: kinematics that
/// are written here without multiblade coordinates.
#[test]
fn shapes_keep_to_kinematics() {
    let (tilt, cone) = ((-5_f64).to_radians(), (-3_f64).to_radians());
    // No shaft that twists: the blades turn with the nacelle.
    let mut machine = tilted();
    machine.shaft_n_m_per_rad = f64::INFINITY;
    let shaft = [tilt.cos(), 0.0, tilt.sin()];
    let up = [-tilt.sin(), 0.0, tilt.cos()];
    let left = [0.0, 1.0, 0.0];
    let apex_m = [-4.0 * shaft[0], 0.0, 2.0 - 4.0 * shaft[2]];
    for mode in modes(machine, 12.0).modes {
        let shape = &mode.shape;
        let top = &shape.tower.last().expect("a top").motion;
        let apex = [shape.apex[0], shape.apex[1], shape.apex[2]];
        let holds = difference(moved(top, apex_m), apex) < 1e-12;
        assert!(holds, "{}", mode.name);
        let root = &shape.blades[0];
        assert!((root.radius_m - 2.0).abs() < 1e-12);
        for azimuth in [0.0, 1.0, 2.5] {
            let (sin, cos): (f64, f64) = f64::sin_cos(azimuth);
            let radial: [f64; 3] = std::array::from_fn(|i| cos * up[i] - sin * left[i]);
            let against: [f64; 3] = std::array::from_fn(|i| sin * up[i] + cos * left[i]);
            let span =
                std::array::from_fn(|i| 2.0 * (cone.sin() * shaft[i] + cone.cos() * radial[i]));
            let in_space = moved(&shape.apex, span);
            let felt = [shaft, against, radial].map(|axis| {
                let parts = in_space.iter().zip(axis);
                parts.map(|(x, axis)| times(*x, axis)).sum()
            });
            assert!(difference(felt, root.at(azimuth)) < 1e-12, "{}", mode.name);
        }
        let tip = shape.blades.last().expect("a tip");
        let tips = (0..36).map(|k| tip.at(f64::from(k) / 6.0));
        let tower = shape
            .tower
            .iter()
            .map(|p| [p.motion[0], p.motion[1], p.motion[2]]);
        let sizes = tips
            .chain(tower)
            .map(|point| difference(point, [Complex::default(); 3]));
        let largest = sizes.fold(0.0, f64::max);
        let holds = (0.999..1.001).contains(&largest);
        assert!(holds, "{}: {largest}", mode.name);
    }
}

/// A wave against the rotation: the largest deflection goes from blade to blade that way.
#[test]
fn whirl_runs_the_way_that_its_name_says() {
    for mode in modes(straight(), 15.0).modes {
        let TurbinePart::Blades(motion, harmonic) = mode.name.part else {
            continue;
        };
        let direction = match harmonic {
            Harmonic::Forward => 1.0,
            Harmonic::Backward => -1.0,
            _ => continue,
        };
        let component = usize::from(motion == BladeMotion::Edge);
        let tip = mode.shape.blades.last().expect("a tip");
        let phase = |azimuth: f64| {
            let x = tip.at(azimuth)[component];
            x.im.atan2(x.re)
        };
        // Re(a e^(i w t)) with a = e^(−iψ) has its largest value at ψ = w t. Around the rotor the
        // phase turns once.
        let step = std::f64::consts::TAU / 60.0;
        let steps = (0..60).map(|k| {
            let back = phase(f64::from(k) * step) - phase(f64::from(k + 1) * step);
            (back + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI
        });
        let turns = steps.sum::<f64>() / std::f64::consts::TAU;
        assert!((turns - direction).abs() < 1e-9, "{}: {turns}", mode.name);
    }
}

/// The change to a finer mesh tells the error of a coarse one.
#[test]
fn errors_of_the_mesh_are_estimated() {
    let coarse = TurbineMesh {
        tower_elements: 2,
        tower_degree: 4,
        blade_degree: 2,
    };
    let turbine = Turbine::new(tower(), tilted()).expect("a turbine");
    let model = |mesh| TurbineModel::new(&turbine, &mesh).expect("a model");
    let speed = 12.0;
    let mut modes = model(coarse).modes(4.0, speed).expect("modes");
    model(coarse.finer()).estimate_errors(&mut modes);
    let exact = model(FINE).modes(4.0, speed).expect("modes");
    // The last one is another mode on the coarse mesh.
    for (mode, exact) in modes.modes.iter().zip(&exact.modes[..10]) {
        let error_hz = mode.frequency.frequency_hz - exact.frequency.frequency_hz;
        let estimate_hz = mode.discretization_error_hz.expect("an estimate");
        let holds = (0.8..1.01).contains(&(estimate_hz / error_hz));
        assert!(holds, "{}", mode.name);
    }
}

/// Waves that do not move the hub are the modes of a blade on a hub that stands still, as much
/// faster or slower as they turn.
#[test]
fn waves_of_five_blades_that_do_not_move_the_hub() {
    let rpm = 9.0;
    let mut machine = straight();
    machine.blades = 5;
    let mut own = blade(changed!(SECTION, torsion_n_m2 = f64::INFINITY));
    own.rotor_speed_rad_per_s = rad_per_s(rpm);
    own.borders = (0..=40).map(|k| f64::from(k) / 40.0).collect();
    let flap_hz = Solver::default()
        .blade(&Blade::new(own).expect("a blade"), 1, &[])
        .expect("solved")
        .modes[0]
        .frequency_hz;
    let modes = modes(machine, rpm);
    for (name, shift) in [
        ("1st flapwise forward, 2 waves", 2.0),
        ("1st flapwise backward, 2 waves", -2.0),
    ] {
        let mode = modes
            .modes
            .iter()
            .find(|mode| mode.name.to_string() == name);
        let mode = mode.expect(name);
        let expected_hz = flap_hz + shift * rpm / 60.0;
        let holds = (mode.frequency.frequency_hz - expected_hz).abs() < 2e-6;
        assert!(holds, "{name}");
        assert!(
            mode.shape
                .tower
                .iter()
                .all(|p| p.motion == [Complex::default(); 6])
        );
    }
}
