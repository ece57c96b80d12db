//! Turbines whose lists or errors were once wrong: modes of negative energy that counts hide, slow
//! yaw, errors of coarse meshes.

use crate::sources::source;
use std::f64::consts::{PI, TAU};

use towermodes::turbine::{Turbine, TurbineMesh, TurbineModel, TurbineModes, TurbinePart};
use towermodes_files::{InMemory, Input, ReadOptions, read_source};

const EXAMPLE: &str = include_str!("../../../examples/nrel-5mw-turbine.toml");
const PAIR: &str = include_str!("turbines/negative_pair_omitted.toml");
/// Turbines with limits, Hz, and rotor speeds, rpm.
const COARSE: [(&str, f64, [f64; 2]); 2] = [
    (
        include_str!("turbines/turbine_error_4x.toml"),
        2.554,
        [0.0, 0.01],
    ),
    (
        include_str!("turbines/turbine_mesh_error_underclaimed.toml"),
        6.0,
        [0.0, 15.0],
    ),
];

#[track_caller]
fn turbine(text: &str) -> Turbine {
    let source = source("t.toml", text);
    let input = read_source(source, &InMemory::default(), &ReadOptions::default());
    let Ok(Input::Tower(input)) = input else {
        panic!("no tower");
    };
    let turbine = input.whole_turbine().expect("a turbine in the file");
    turbine.expect("a possible turbine")
}

#[track_caller]
fn model(turbine: &Turbine) -> TurbineModel {
    TurbineModel::new(turbine, &turbine.mesh()).expect("a model")
}

fn frequencies_hz(modes: &TurbineModes) -> Vec<f64> {
    let all = modes.modes.iter();
    all.map(|mode| mode.frequency.frequency_hz).collect()
}

/// At 116.85 rpm two modes, one of negative energy, are closer than the steps of a coarse grid over
/// all frequencies. The list below 2 Hz does not depend on how far it goes on.
#[test]
fn a_pair_of_opposite_energies_is_found_below_any_limit() {
    let turbine = turbine(PAIR);
    let mut model = model(&turbine);
    let speed = 116.852_056_191_837_4;
    let mut lists = [2.0, 4.0, 8.0, 16.0].map(|limit_hz| {
        let modes = model.modes(limit_hz, speed).expect("solved");
        assert!(modes.is_complete, "{limit_hz} Hz: {:?}", modes.unproven_hz);
        assert_eq!(model.recount(&modes), Ok(()));
        let below = frequencies_hz(&modes).into_iter();
        below.filter(|hz| *hz < 2.0).collect::<Vec<f64>>()
    });
    let first = std::mem::take(&mut lists[0]);
    assert!(first.len() > 2, "{first:?}");
    for list in &lists[1..] {
        assert_eq!(list.len(), first.len(), "{list:?} {first:?}");
        for (a, b) in list.iter().zip(&first) {
            assert!((a / b - 1.0).abs() < 1e-9, "{list:?} {first:?}");
        }
    }
}

/// A nacelle on a yaw spring k turns as √k, far below all else, at any rotor speed. No spring makes
/// the turbine unstable, and none vanishes.
#[test]
fn slow_yaw_is_a_mode_at_every_speed() {
    let with = |yaw: &str| {
        let text = EXAMPLE.replace(
            "yaw_stiffness = 9.02832e9",
            &format!("yaw_stiffness = {yaw}"),
        );
        assert_ne!(text, EXAMPLE);
        model(&turbine(&text))
    };
    for rpm in [0.0, 6.9, 12.1] {
        let mut of_ten_thousand = f64::NAN;
        for k in [1e4, 100.0, 30.0, 20.0, 1.0_f64] {
            let modes = with(&format!("{k:e}")).modes(1.0, rpm * PI / 30.0);
            let modes = modes.expect("solved");
            assert!(modes.is_complete, "{k} N m/rad, {rpm} rpm");
            assert_eq!((modes.growing, modes.unresisted), (0, 0), "{k}, {rpm}");
            let slowest = &modes.modes[0];
            assert_eq!(slowest.name.part, TurbinePart::YawDrive, "{k}, {rpm}");
            let found = slowest.frequency.frequency_hz;
            if k == 1e4 {
                of_ten_thousand = found;
            }
            // So slow that the rest of the turbine follows without inertia of its own.
            let expected = of_ten_thousand * (k / 1e4).sqrt();
            let difference = found / expected - 1.0;
            assert!(difference.abs() < 1e-3, "{k}, {rpm}: {found} {expected}");
        }
        assert!(of_ten_thousand * TAU > 1e-3);
    }
    // A period of 100 days: no mode, but counted.
    let mut still = with("1e-8");
    for rpm in [0.0, 12.1] {
        let modes = still.modes(1.0, rpm * PI / 30.0).expect("solved");
        assert!(modes.is_complete);
        assert_eq!(modes.unresisted, 1, "{rpm} rpm");
        assert_ne!(modes.modes[0].name.part, TurbinePart::YawDrive);
    }
}

/// Each error against elements of degree 14 on a tower of four elements of degree 14.
#[test]
fn errors_of_blades_of_few_elements_are_covered() {
    for (text, limit_hz, speeds_rpm) in COARSE {
        let turbine = turbine(text);
        let fine = TurbineMesh {
            tower_elements: 4,
            tower_degree: 14,
            blade_degree: 14,
        };
        let mut fine = TurbineModel::new(&turbine, &fine).expect("a model");
        let mut finer = TurbineModel::new(&turbine, &turbine.mesh().finer()).expect("a model");
        let mut model = model(&turbine);
        for rpm in speeds_rpm {
            let mut modes = model.modes(limit_hz, rpm).expect("solved");
            finer.estimate_errors(&mut modes);
            let exact = frequencies_hz(&fine.modes(limit_hz, rpm).expect("solved"));
            for (mode, exact_hz) in modes.modes.iter().zip(exact) {
                let error_hz = (mode.frequency.frequency_hz - exact_hz).abs();
                let claimed_hz = mode.discretization_error_hz.expect("an estimate");
                assert!(
                    error_hz <= 3.0 * claimed_hz + 1e-9 * exact_hz,
                    "{limit_hz} Hz, {rpm} rpm: {exact_hz} Hz, {error_hz:e} {claimed_hz:e}"
                );
            }
        }
    }
}
