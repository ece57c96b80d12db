//! Cases: pairs, steps, kinks, zeros, errors of derivatives.

use super::{on_springs, sensitivities_of};
use towermodes::{Change, Method, NoDerivative, Options, Solver, Station, TowerDescription};
use towermodes_random::Class;
use towermodes_testing::with;
use towermodes_verify::towers::{monopile, reference_350t};

#[test]
fn a_number_that_splits_a_pair_gives_it_no_derivative() {
    for method in super::methods() {
        let options = with!(Options, method);
        let names = ["rna.inertia.xy", "rna.inertia.xx", "rna.mass"];
        let result = sensitivities_of(&reference_350t(), &names, &options);
        let [coupling, one_plane, both] = [0, 1, 2].map(|change| &result.changes[change].modes);
        assert_eq!(result.modes[0].label(), "1st fore-aft bending");
        assert_eq!(result.modes[1].label(), "1st side-side bending");
        assert_eq!(coupling[0], Err(NoDerivative::Repeated));
        assert_eq!(coupling[1], Err(NoDerivative::Repeated));
        // Rotation about x is side-side bending alone.
        assert_eq!(one_plane[0].expect("a derivative").hz_per_unit, 0.0);
        assert!(one_plane[1].expect("a derivative").hz_per_unit < 0.0);
        let [a, b] = [0, 1].map(|mode| both[mode].expect("a derivative").hz_per_unit);
        assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    }
}

/// The soil begins with a spring at the foot of the pile, so less of it acts if it begins higher,
/// and no more if it begins lower.
#[test]
fn soil_that_begins_at_the_foot_has_a_kink_there() {
    let description = monopile();
    let result = sensitivities_of(
        &description,
        &[
            "soil[0].rows[0].height",
            "soil[0].rows[2].height",
            "water.bed",
        ],
        &Options::default(),
    );
    let modes = &result.changes[0].modes[..4];
    let holds = modes.iter().all(|m| *m == Err(NoDerivative::OneSided));
    assert!(holds, "{modes:?}");
    // Two fronts at one height part without a solve, as solves say.
    let spectral = with!(Options, method = Method::Spectral);
    let names = ["soil[0].rows[2].height", "water.bed"];
    let expected = sensitivities_of(&description, &names, &spectral);
    for change in 0..2 {
        for mode in 0..6 {
            let got = result.changes[change + 1].modes[mode].expect("a derivative");
            let wanted = expected.changes[change].modes[mode].expect("a derivative");
            let scale = result.modes[mode].frequency_hz / 100.0;
            let difference = (got.hz_per_unit - wanted.hz_per_unit).abs() / scale;
            assert!(difference < 1e-4, "{change} {mode}: {difference:.1e}");
            let error = got.error_hz_per_unit + wanted.error_hz_per_unit;
            let holds = difference * scale <= error;
            assert!(holds, "{change} {mode}: {difference:.1e}");
        }
    }
}

#[test]
fn a_step_moves_as_one_and_its_rows_alone_cannot() {
    let mut description = reference_350t();
    description.stations = vec![
        Station::new(0.0, 6.0, 0.03),
        Station::new(40.0, 5.0, 0.03),
        Station::new(40.0, 5.0, 0.024),
        Station::new(87.6, 4.0, 0.02),
    ];
    let names = [
        "stations[1].height",
        "add(stations[1].height,stations[2].height)",
    ];
    let result = sensitivities_of(&description, &names, &Options::default());
    assert_eq!(result.changes[0].modes[0], Err(NoDerivative::OneSided));
    assert!(result.changes[1].modes[0].is_ok());
}

#[test]
fn numbers_that_are_zero_have_derivatives() {
    let names = ["rna.center[1]", "rna.inertia.yz", "gravity.acceleration"];
    let mut description = on_springs();
    description.gravity_m_per_s2 = 0.0;
    let result = sensitivities_of(&description, &names[..2], &Options::default());
    for change in &result.changes {
        assert!(change.modes.iter().all(Result::is_ok), "{change:?}");
        // A machine off the plane of symmetry on either side is the same tower.
        let first = change.modes[0].expect("a derivative").hz_per_unit;
        assert!(first.abs() < 1e-12, "{first}");
    }
}

/// The unit of a number is not a step: 2e-3 N m added to a stiffness of 1e11 N m is lost in
/// rounding.
#[test]
fn what_is_added_to_a_number_has_the_derivative_of_the_number() {
    for name in ["foundation.rocking", "rna.mass", "material.youngs_modulus"] {
        let names = [name.to_owned(), format!("add({name})")];
        let names = names.each_ref().map(String::as_str);
        for method in super::methods() {
            let result = sensitivities_of(&on_springs(), &names, &with!(Options, method));
            for mode in 0..2 {
                let [of_number, added] = [0, 1].map(|i| super::derivative(&result, i, mode));
                let case = format!("{}, {name}, mode {mode}", method.name());
                super::assert_close(added, of_number, 1e-7, &case);
            }
        }
    }
}

/// The error of a derivative against the spectral method, which has no mesh.
/// With shear, gravity adds an unknown to each joint; without gravity the derivative is that of the
/// limit from above.
#[test]
fn gravity_of_a_weightless_tower_that_shears() {
    let shear = Class::ALL.into_iter().find(|class| class.name() == "shear");
    let shear = shear.expect("towers that shear");
    let mut compared = 0;
    for number in 0..12 {
        let mut description = shear.description(number);
        description.gravity_m_per_s2 = 0.0;
        let of = |method: Method| {
            let options = with!(Options, method, modes = 4);
            sensitivities_of(&description, &["gravity.acceleration"], &options)
        };
        let [own, beam] = [Method::RmjeExact, Method::Spectral].map(of);
        for (place, mode) in own.modes.iter().enumerate() {
            let same = beam.modes.iter().position(|m| m.label() == mode.label());
            let Some(same) = same else { continue };
            let derivatives = [own.changes[0].modes[place], beam.changes[0].modes[same]];
            let [Ok(own), Ok(beam)] = derivatives else {
                continue;
            };
            let difference = own.hz_per_unit - beam.hz_per_unit;
            let case = format!("{number} {}: {difference:.1e}", mode.label());
            let holds = difference.abs() <= 2e-5 * beam.hz_per_unit.abs() + 1e-10;
            assert!(holds, "{case}");
            compared += 1;
        }
    }
    assert!(compared > 24, "{compared} compared");
}

#[test]
fn the_error_of_a_derivative_holds_and_is_near() {
    let (mut held, mut missed, mut ratios) = (0, Vec::new(), Vec::new());
    for class in Class::ALL {
        for number in 40..43 {
            let description: TowerDescription = class.description(number);
            let all = Change::every(&description);
            let step = 1 + all.len() / 6;
            let changes: Vec<_> = all.into_iter().step_by(step).collect();
            let of = |method| {
                let options = with!(Options, method, modes = 5);
                Solver::new(options).sensitivities(&description, &changes)
            };
            let (Ok(a), Ok(b)) = (of(Method::RmjeExact), of(Method::Spectral)) else {
                continue;
            };
            for (x, y) in a.changes.iter().zip(&b.changes) {
                for (place, mode) in a.modes.iter().enumerate() {
                    let Some(same) = b.modes.iter().position(|m| m.label() == mode.label()) else {
                        continue;
                    };
                    let (Ok(own), Ok(exact)) = (&x.modes[place], &y.modes[same]) else {
                        continue;
                    };
                    let error = (own.hz_per_unit - exact.hz_per_unit).abs();
                    let estimate = own.error_hz_per_unit + exact.error_hz_per_unit;
                    let case = || {
                        format!(
                            "{} {number} {} {}",
                            class.name(),
                            x.change.name(),
                            mode.label()
                        )
                    };
                    // The spectral method has errors too.
                    match error <= 3.0 * estimate {
                        true => held += 1,
                        false => missed.push(format!("{}: {error:.1e} {estimate:.1e}", case())),
                    }
                    if exact.error_hz_per_unit < 0.1 * error {
                        ratios.push(own.error_hz_per_unit / error);
                    }
                }
            }
        }
    }
    ratios.sort_by(f64::total_cmp);
    let median = ratios[ratios.len() / 2];
    let holds = 1000 * missed.len() <= held;
    assert!(holds, "{} of {held}: {missed:#?}", missed.len());
    // Most derivatives are better than meshes can tell.
    assert!((1.0..1000.0).contains(&median), "{median}");
}

/// With so few segments that none can be merged the derivative is extrapolated from finer meshes,
/// as the frequency is.
#[test]
fn few_segments_have_the_derivative_of_the_beam() {
    let names = ["scale(soil[0].rows[*].x)", "rna.mass", "stations[0].wall"];
    let of = |method: Method, segments: Option<usize>| {
        let options = with!(Options, method, segments, modes = 4);
        sensitivities_of(&monopile(), &names, &options)
    };
    let (few, beam) = (of(Method::RmjeExact, Some(20)), of(Method::Spectral, None));
    let mut compared = 0;
    for (few_change, beam_change) in few.changes.iter().zip(&beam.changes) {
        for (mode, expected) in beam.modes.iter().zip(&beam_change.modes) {
            let label = mode.label();
            let place = few.modes.iter().position(|other| other.label() == label);
            let got = few_change.modes[place.expect("the same modes")];
            let (got, expected) = (got.expect("one").hz_per_unit, expected.expect("one"));
            let value = few_change.value / mode.frequency_hz;
            let difference = (got - expected.hz_per_unit).abs() * value;
            let name = few_change.change.name();
            assert!(difference < 5e-5, "{name}, {label}: {difference:.1e}");
            compared += 1;
        }
    }
    assert_eq!(compared, 12);
}
