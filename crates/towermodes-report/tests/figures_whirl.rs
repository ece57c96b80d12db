//! Pictures of a turning turbine: readable at every speed, and blades that move with their hub.

use std::f64::consts::TAU;

use towermodes::turbine::{Turbine, TurbineMesh, TurbineModel, TurbineModes};
use towermodes_report::figures::{AnimatedWhirl, WhirlAnimation, whirl, whirl_animation};
use towermodes_testing::Says;

use super::pictures::{check, input};

/// The example turbine with its modes up to 3 Hz.
fn solved(rpm: f64) -> (Turbine, TurbineModes) {
    let (input, _) = input("nrel-5mw-turbine.toml");
    let turbine = input.whole_turbine().expect("valid").expect("a turbine");
    let mut model = TurbineModel::new(&turbine, &TurbineMesh::default()).expect("a model");
    let modes = model.modes(3.0, rpm).expect("its modes");
    (turbine, modes)
}

#[test]
fn stills_are_readable_and_name_every_mode() {
    for rpm in [0.0, 12.1] {
        let (turbine, modes) = solved(rpm);
        assert!(modes.modes.len() > 8, "{}", modes.modes.len());
        let figure = whirl(&turbine, &modes);
        check(&format!("{rpm} rpm"), &figure);
        for (index, mode) in modes.modes.iter().enumerate() {
            let name = format!("{}. {}", index + 1, mode.label());
            let mut labels = figure.labels().iter();
            assert!(labels.any(|label| label.text == name), "{name}");
        }
        assert_eq!(figure.table.rows.len(), modes.modes.len());
    }
}

#[test]
fn a_list_without_modes_has_a_picture() {
    let (turbine, mut modes) = solved(0.0);
    modes.modes.clear();
    let figure = whirl(&turbine, &modes);
    figure.description.says("none");
    let animation = whirl_animation(&turbine, &modes);
    assert!(animation.modes.is_empty() && animation.span_m.is_empty());
}

/// The root of a blade is fixed to the hub, which moves like the nacelle but for its rotation about
/// the shaft: that does not move the root along the shaft or radially.
#[test]
fn roots_move_with_the_hub() {
    let (turbine, modes) = solved(12.1);
    let animation = whirl_animation(&turbine, &modes);
    assert!(!animation.modes.is_empty());
    for mode in &animation.modes {
        for step in 0..24 {
            let (azimuth, phase) = (TAU * f64::from(step) / 24.0, 0.3 * f64::from(step));
            let (of_blade, of_hub) = (
                root_moved(&animation, mode, azimuth, phase),
                hub_moved(&animation, mode, azimuth, phase),
            );
            // Amplitudes are multiples of 1e-4.
            for (a, b) in of_blade.iter().zip(of_hub) {
                assert!((a - b).abs() < 5e-4, "{}: {a} and {b}", mode.label);
            }
        }
    }
}

fn real_parts(amplitudes: &[f64], phase: f64) -> Vec<f64> {
    let pairs = amplitudes.chunks(2);
    pairs
        .map(|pair| pair[0] * phase.cos() - pair[1] * phase.sin())
        .collect()
}

/// Motion of the first section of a blade along the shaft and radially.
fn root_moved(_: &WhirlAnimation, mode: &AnimatedWhirl, azimuth: f64, phase: f64) -> [f64; 2] {
    let mut moved = [0.0; 2];
    for harmonic in &mode.harmonics {
        let phase = phase - harmonic.waves as f64 * azimuth;
        let parts = real_parts(&harmonic.motion[0], phase);
        moved[0] += parts[0];
        moved[1] += parts[2];
    }
    moved
}

/// The same of the point of the hub there: u + θ × r.
fn hub_moved(of: &WhirlAnimation, mode: &AnimatedWhirl, azimuth: f64, phase: f64) -> [f64; 2] {
    let motion = real_parts(&mode.nacelle, phase);
    let [along, left, up] = of.shaft_axes;
    let (sin, cos) = azimuth.sin_cos();
    let radial = [0, 1, 2].map(|i| cos * up[i] - sin * left[i]);
    let (sin, cos) = of.cone_rad.sin_cos();
    let arm = [0, 1, 2].map(|i| of.span_m[0] * (sin * along[i] + cos * radial[i]));
    let turned = [
        motion[4] * arm[2] - motion[5] * arm[1],
        motion[5] * arm[0] - motion[3] * arm[2],
        motion[3] * arm[1] - motion[4] * arm[0],
    ];
    let total = [0, 1, 2].map(|i| motion[i] + turned[i]);
    [along, radial].map(|axis| (0..3).map(|i| total[i] * axis[i]).sum())
}
