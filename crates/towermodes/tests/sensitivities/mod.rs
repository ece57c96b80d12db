//! Derivatives of frequencies: reference digits, scaling laws, differences of solved frequencies.

mod cases;
mod laws;
mod leaving;
mod oracle;

use crate::towers;

use towermodes::{
    Change, Foundation, Inertia, Method, ModeFrequency, Options, Rna, Sensitivities, Solver, Tower,
    TowerDescription,
};
use towermodes_random::Class;
use towermodes_testing::{numbers, parts, rows, tube, with};
use towers::{assert_close, reference_350t};

fn sensitivities_of(
    description: &TowerDescription,
    names: &[&str],
    options: &Options,
) -> Sensitivities {
    let changes = Change::parse_all(names.iter().copied(), description).expect("names of numbers");
    Solver::new(options.clone())
        .sensitivities(description, &changes)
        .expect("derivatives")
}

/// The derivative of a mode, by its place, with respect to a change, by its place.
#[track_caller]
fn derivative(result: &Sensitivities, change: usize, mode: usize) -> f64 {
    let derivative = result.changes[change].modes[mode];
    derivative.expect("it has a derivative").hz_per_unit
}

fn methods() -> impl Iterator<Item = Method> {
    [Method::RmjeExact, Method::CardanicExact, Method::Spectral].into_iter()
}

/// Central differences of an independent hp beam code (Rayleigh beam, exact taper), extrapolated
/// from three steps: the digits on which these agree.
#[test]
fn a_clamped_cone_has_the_derivatives_of_another_program() {
    let description = TowerDescription {
        rna: Rna::point(350e3),
        ..tube(&[(0.0, 6.0, 0.027), (87.6, 3.87, 0.019)])
    };
    // First, second and third bending pair, and the axial mode at 7.114 Hz.
    let table = r#"
        material.youngs_modulus | 7.147750e-13 7.250657e-12 1.693844e-11 2.165955e-11
        material.density | -1.917602e-6 -1.6902887e-4 -6.319138e-5 -5.252741e-4
        stations[0].diameter | 5.681837e-2 3.5028315e-1 2.9951339e-1 9.062232e-1
        stations[1].diameter | 2.455309e-2 2.6612853e-1 3.1964486e-1 9.400033e-1
        stations[0].wall | 3.968112 7.112175 64.32926 7.024705
        stations[1].wall | 1.298445 -6.346520 66.78398 -7.795936
        stations[1].height | -5.325755e-3 -6.838652e-2 -4.673744e-2 -2.0505343e-1
        rna.mass | -3.822949e-7 -2.454076e-7 -8.628417e-6 -2.390717e-7
    "#;
    let expected = rows(table).map(|[name, digits]| (name, numbers::<4>(digits)));
    let expected: Vec<_> = expected.collect();
    let names: Vec<&str> = expected.iter().map(|(name, _)| *name).collect();
    for method in methods() {
        let result = sensitivities_of(&description, &names, &with!(Options, method));
        for (change, (name, digits)) in expected.iter().enumerate() {
            for (mode, digit) in [0, 2, 4, 5].into_iter().zip(digits) {
                // The walls of the first pair: all methods agree with each other and with
                // differences of solved frequencies to nine digits, and differ from these.
                let is_wall_of_first = name.ends_with("wall") && mode == 0;
                let tolerance = if is_wall_of_first { 1e-5 } else { 1e-6 };
                let case = format!("{}, {name}, mode {mode}", method.name());
                assert_close(derivative(&result, change, mode), *digit, tolerance, &case);
            }
        }
    }
}

fn on_springs() -> TowerDescription {
    TowerDescription {
        rna: Rna {
            mass_kg: 350e3,
            center_m: [-0.41, 0.0, 1.97],
            inertia_kg_m2: Inertia {
                xx: 4.37e7,
                yy: 2.353e7,
                zz: 2.542e7,
                xz: 1.169e6,
                ..Inertia::default()
            },
        },
        foundation: Foundation::Springs(parts::springs(2e9, 1e11, 0.0, 1e10, 1e11)),
        gravity_m_per_s2: 9.81,
        ..reference_350t()
    }
}

#[test]
fn a_tower_on_springs_has_the_derivatives_of_another_program() {
    let table = r#"
        rna.mass | -3.4021e-7 -3.4917e-7 NaN -1.565e-8 -4.190e-8
        rna.center[2] | -4.4607e-3 -4.5385e-3 NaN 1.4137e-3 -1.43066e-2
        rna.inertia.xx | -1.172e-10 0 -1.000e-11 -1.2912e-8 0
        rna.inertia.yy | 0 -1.183e-10 0 0 -2.1672e-8
        foundation.rocking | 1.30314e-13 1.33481e-13 NaN 5.2359e-13 7.9728e-13
        gravity.acceleration | -6.6809e-4 -6.7299e-4 NaN -6.153e-4 -8.039e-4
        stations[0].diameter | 4.61355e-2 4.67290e-2 1.38674e-1 1.16264e-1 1.48153e-1
        stations[1].wall | 1.197206 1.164497 18.67962 19.13677 15.63038
    "#;
    let expected = rows(table).map(|[name, digits]| (name, numbers::<5>(digits)));
    let expected: Vec<_> = expected.collect();
    let names: Vec<&str> = expected.iter().map(|(name, _)| *name).collect();
    let description = on_springs();
    for method in methods() {
        let result = sensitivities_of(&description, &names, &with!(Options, method));
        for (change, (name, digits)) in expected.iter().enumerate() {
            for (mode, digit) in digits.iter().enumerate() {
                let got = derivative(&result, change, mode);
                let case = format!("{}, {name}, mode {mode}", method.name());
                match *digit {
                    0.0 => assert_eq!(got, 0.0, "{case}"),
                    digit if digit.is_nan() => {}
                    digit => assert_close(got, digit, 2e-4, &case),
                }
            }
        }
    }
}

/// The same derivative by solving towers on both sides, on elements of one degree.
fn by_solving(
    description: &TowerDescription,
    (change, value, h): (&Change, f64, f64),
    options: &Options,
) -> Option<Vec<(String, f64)>> {
    let solve = |value: f64| {
        let mut changed = description.clone();
        change.apply(&mut changed, value);
        let tower = Tower::new(changed).ok()?;
        let mut solver = Solver::new(options.clone());
        let modes = solver.frequencies(&tower).ok()?.modes.clone();
        Some(modes)
    };
    let [a, b, c, d, middle] = [h, -h, 0.5 * h, -0.5 * h, 0.0].map(|step| solve(value + step));
    let (a, b, c, d, middle) = (a?, b?, c?, d?, middle?);
    let of_mode = |mode: usize| {
        let label = a[mode].label();
        let hz = |modes: &[ModeFrequency]| {
            let same = modes.iter().find(|other| other.label() == label);
            // The square of a frequency near zero has a smaller curvature.
            same.map_or(f64::NAN, |same| same.frequency_hz.powi(2))
        };
        let (whole, half) = ((hz(&a) - hz(&b)) / (2.0 * h), (hz(&c) - hz(&d)) / h);
        let middle_hz = hz(&middle).sqrt();
        (
            label.clone(),
            (half + (half - whole) / 3.0) / (2.0 * middle_hz),
        )
    };
    Some((0..a.len()).map(of_mode).collect())
}

/// The largest difference of derivatives from those of solved frequencies that is allowed, where a
/// number changes by as much as it is, relative to the frequency.
const ALLOWED: f64 = 1e-7;

/// The step for differences of solved frequencies, and what a derivative is multiplied by to be
/// comparable: the value, or the height of the tower.
fn step_and_size(change: &Change, value: f64, tower: &Tower) -> (f64, f64) {
    if change.name().contains("height") {
        let lengths = tower.pieces().iter().map(|piece| piece.length_m());
        let shortest_m = lengths.fold(f64::INFINITY, f64::min);
        return (1e-3 * shortest_m, tower.height_m());
    }
    (2e-3 * value.abs(), value.abs())
}

/// Compares the derivatives with respect to one change; returns how many were compared, and how
/// many of these differ by more than is allowed, within the error that they have.
fn compare(
    description: &TowerDescription,
    result: &Sensitivities,
    change: usize,
    options: &Options,
    case: &str,
) -> [usize; 2] {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    let of_change = &result.changes[change];
    let (change, value) = (&of_change.change, of_change.value);
    let (h, size) = step_and_size(change, value, &tower);
    let Some(solved) = (size > 0.0)
        .then(|| by_solving(description, (change, value, h), options))
        .flatten()
    else {
        return [0, 0];
    };
    let mut counts = [0, 0];
    for (mode, derivative) in result.modes.iter().zip(&of_change.modes) {
        let expected = solved.iter().find(|(label, _)| *label == mode.label());
        let (Ok(derivative), Some((_, expected))) = (derivative, expected) else {
            continue;
        };
        let relative = |hz_per_unit: f64| hz_per_unit.abs() * size / mode.frequency_hz;
        let difference = relative(derivative.hz_per_unit - expected);
        let own_error = relative(derivative.error_hz_per_unit);
        let case = format!("{case}, {}, {}", change.name(), mode.label());
        let holds = difference <= ALLOWED.max(own_error);
        assert!(holds, "{case}: {difference:.1e}, error {own_error:.1e}");
        counts[0] += 1;
        counts[1] += usize::from(difference > ALLOWED);
    }
    counts
}

#[test]
fn derivatives_are_those_of_solved_frequencies() {
    let options = Options {
        method: Method::Spectral,
        degree: Some(14),
        modes: 5,
        ..Options::default()
    };
    let (mut compared, mut uncertain) = (0, 0);
    for class in Class::ALL {
        for number in 0..16 {
            let description = class.description(number);
            let all = Change::every(&description);
            let picked = all
                .iter()
                .skip(number as usize % 3)
                .step_by(1 + all.len() / 4);
            let picked: Vec<Change> = picked.cloned().collect();
            let mut solver = Solver::new(options.clone());
            let Ok(result) = solver.sensitivities(&description, &picked) else {
                continue;
            };
            for change in 0..picked.len() {
                let case = format!("{} {number}", class.name());
                let [more, beyond] = compare(&description, &result, change, &options, &case);
                compared += more;
                uncertain += beyond;
            }
        }
    }
    let holds = compared > 3000 && uncertain < 5;
    assert!(holds, "{compared} compared, {uncertain} uncertain");
}
