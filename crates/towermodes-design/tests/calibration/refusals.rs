//! Every problem that cannot be solved is refused with its numbers and a remedy.

use super::{Problem, fitted, frequencies, measured, tower, unknown, with_prior};
use towermodes::{Change, Foundation, Options, Solver, TowerDescription};
use towermodes_design::calibration::{
    CalibrationError, Measured, MeasuredShape, Unknown, calibrate,
};
use towermodes_testing::{Says, changed, number, rows, with};

#[track_caller]
fn refused(base: TowerDescription, unknowns: Vec<Unknown>, measured: Vec<Measured>, words: &str) {
    let problem = Problem {
        base,
        unknowns,
        measured,
    };
    fitted(&problem).expect_err("refused").says(words);
}

fn first() -> Measured {
    measured("fore-aft 1", 0.26, 0.001)
}

#[test]
fn too_few_measurements_are_refused_with_the_remedy() {
    let base = tower();
    let both = |base: &TowerDescription| {
        vec![
            unknown(base, "foundation.rocking"),
            unknown(base, "foundation.lateral"),
        ]
    };
    refused(
        base.clone(),
        both(&base),
        vec![first()],
        "2 unknowns cannot be found from 1 measurement and 0 priors; measure more modes, fit fewer unknowns, or give an unknown a prior, such as `foundation.lateral`",
    );
    let priors = vec![with_prior(&base, "foundation.rocking", 1e11, 1e10)];
    refused(base.clone(), priors, vec![], "from 0 measurements");
    refused(base.clone(), vec![], vec![first()], "no unknowns are given");
    let one = vec![
        with_prior(&base, "foundation.rocking", 1e11, 1e10),
        unknown(&base, "foundation.lateral"),
    ];
    let problem = Problem {
        base,
        unknowns: one,
        measured: vec![first()],
    };
    assert!(fitted(&problem).is_ok());
}

#[test]
fn impossible_numbers_are_refused() {
    let base = tower();
    let rocking = || vec![unknown(&base, "foundation.rocking")];
    let with = |frequency, deviation| vec![measured("fore-aft 1", frequency, deviation)];
    let words = "the frequency of measurement 1 is -0.3; it must be positive";
    refused(base.clone(), rocking(), with(-0.3, 0.01), words);
    let words = "the standard deviation of measurement 1 is 0";
    refused(base.clone(), rocking(), with(0.3, 0.0), words);
    refused(base.clone(), rocking(), with(f64::NAN, 0.1), "NaN");
    let twice_the_mode = vec![first(), measured("side-side 1", 0.26, 0.001), first()];
    let words = "measurements 1 and 3 are both of fore-aft 1; give one frequency";
    refused(base.clone(), rocking(), twice_the_mode, words);
    let bounded = |bounds| {
        vec![changed!(
            unknown(&base, "foundation.rocking"),
            bounds = Some(bounds)
        )]
    };
    let words = "the lower must be below the upper";
    refused(base.clone(), bounded([2e11, 1e11]), vec![first()], words);
    let prior = |mean, deviation| vec![with_prior(&base, "foundation.rocking", mean, deviation)];
    let words = "standard deviation 0";
    refused(base.clone(), prior(1e11, 0.0), vec![first()], words);
    let outside = vec![Unknown {
        bounds: Some([1e9, 1e10]),
        ..with_prior(&base, "foundation.rocking", 1e11, 1e10)
    }];
    let words = "is outside the bounds";
    refused(base.clone(), outside, vec![first()], words);
    let twice = vec![
        with_prior(&base, "scale(stations[*].wall)", 1.0, 0.1),
        with_prior(&base, "stations[0].wall", 0.03, 0.01),
    ];
    let words = "`stations[0].wall` changes stations[0].wall, which another unknown";
    refused(base.clone(), twice, vec![first()], words);
}

#[test]
fn modes_and_sensors_that_do_not_exist_are_refused() {
    let base = tower();
    let rocking = || vec![unknown(&base, "foundation.rocking")];
    let of = |mode| vec![measured(mode, 0.3, 0.01)];
    let words = "measurement 1 is of the mode surge, which is not among the";
    refused(base.clone(), rocking(), of("surge"), words);
    let words = "the lowest are side-side 1, fore-aft 1, ";
    refused(base.clone(), rocking(), of("fore-aft 99"), words);
    let shape = |heights_m: Vec<f64>, displacements| {
        vec![Measured {
            mode: None,
            shape: Some(MeasuredShape {
                heights_m,
                displacements,
            }),
            ..first()
        }]
    };
    refused(
        base.clone(),
        rocking(),
        shape(vec![99.0], vec![[1.0, 0.0]]),
        "has a sensor at 99 m, but the tower extends from 0 to 87.6 m",
    );
    let words = "must have one finite displacement for each height";
    refused(base.clone(), rocking(), shape(vec![50.0], vec![]), words);
    refused(
        base.clone(),
        rocking(),
        shape(vec![50.0], vec![[0.0; 2]]),
        "not all zero",
    );
}

#[test]
fn values_without_a_start_are_refused_with_the_remedy() {
    let mut base = tower();
    let walls = vec![unknown(&base, "stations[*].wall")];
    let words = "the tower has values from 0.019 to 0.027; fit scale(…) or add(…)";
    refused(base.clone(), walls, vec![first()], words);
    if let Foundation::Springs(springs) = &mut base.foundation {
        springs.rocking_n_m = f64::INFINITY;
    }
    let rocking = vec![unknown(&base, "foundation.rocking")];
    let words = "`foundation.rocking` has no value to start from: the tower has inf";
    refused(base.clone(), rocking, vec![first()], words);
    let problem = Problem {
        unknowns: vec![with_prior(&base, "foundation.rocking", 1e11, 5e10)],
        measured: vec![first()],
        base,
    };
    assert!(fitted(&problem).is_ok());
}

/// The clamped tower has 0.28 Hz, and no mass of the RNA less than none.
#[test]
fn a_frequency_that_cannot_be_reached_is_refused_with_the_nearest() {
    let base = tower();
    let rocking = vec![unknown(&base, "foundation.rocking")];
    let far = vec![measured("fore-aft 1", 5.0, 0.001)];
    refused(
        base.clone(),
        rocking,
        far,
        "no value of the fitted inputs gives the measured frequency of fore-aft 1, 5 Hz; the nearest frequency is 0.2",
    );
    let bounded = Unknown {
        bounds: Some([1e10, 1e12]),
        ..unknown(&base, "foundation.rocking")
    };
    let far = vec![measured("fore-aft 1", 5.0, 0.001)];
    let problem = Problem {
        unknowns: vec![bounded],
        measured: far,
        base,
    };
    let error = fitted(&problem).expect_err("refused");
    let highest = frequencies(
        &with_value(&problem.base, "foundation.rocking", 1e12),
        &["fore-aft 1"],
    )[0];
    let CalibrationError::OutsideBounds { nearest_hz, .. } = error else {
        panic!("{error}");
    };
    assert!((nearest_hz / highest - 1.0).abs() < 1e-9, "{nearest_hz}");
    assert_eq!(error.measurement(), Some(0));
    let said = error.to_string();
    said.says("give the measured frequency of fore-aft 1, 5 Hz; the nearest frequency is 0.2");
    said.says("limited by the upper bound 1e12 of foundation.rocking");
}

fn with_value(base: &TowerDescription, name: &str, value: f64) -> TowerDescription {
    let mut tower = base.clone();
    let change = Change::parse(name, base).expect("a change");
    change.apply(&mut tower, value);
    tower
}

/// A stiffness, a mass and a factor are positive, a height is not.
#[test]
fn priors_that_a_positive_number_cannot_have_are_refused() {
    let base = tower();
    let prior = |name: &str, mean, deviation| vec![with_prior(&base, name, mean, deviation)];
    let table = r#"
        foundation.rocking | -1e6 | the prior mean of `foundation.rocking` is -1000000, but this input value cannot be negative
        foundation.rocking | 0.0 | but this input value cannot be 0
        scale(stations[*].wall) | -1.0 | cannot be negative
        "#;
    for [name, mean, words] in rows(table) {
        let mean = number(mean);
        refused(base.clone(), prior(name, mean, 0.1), vec![first()], words);
    }
    let height = prior("rna.center[0]", -0.41, 0.1);
    let problem = Problem {
        base: base.clone(),
        unknowns: [height, vec![unknown(&base, "foundation.rocking")]].concat(),
        measured: vec![first()],
    };
    assert!(fitted(&problem).is_ok());
    let bounded = vec![Unknown {
        bounds: Some([-2.0, -1.0]),
        ..unknown(&base, "scale(stations[*].wall)")
    }];
    let text = "the upper bound of `scale(stations[*].wall)` is -1";
    refused(base.clone(), bounded, vec![first()], text);
    for deviation in [1.0, 1e20] {
        refused(
            base.clone(),
            prior("foundation.rocking", 1e11, deviation),
            vec![first()],
            "it must be between 1e-9 and 1e6 times the mean",
        );
    }
}

#[test]
fn standard_deviations_that_no_measurement_has_are_refused() {
    let base = tower();
    for deviation in [1e-300, 1e-11, 1e7] {
        let rocking = vec![unknown(&base, "foundation.rocking")];
        let of = vec![measured("fore-aft 1", 0.26, deviation)];
        let words = "it must be between 1e-9 and 1e6 times the frequency";
        refused(base.clone(), rocking, of, words);
    }
}

/// On the way from one frequency to the other, torsion and side-side 2 exchange their names across
/// a gap of 0.004 Hz. A frequency in the gap or beyond has no tower, and the answer at the gap
/// would be no minimum: the sum of squares jumps there, and deviations mean nothing.
#[test]
fn a_fit_that_ends_where_names_are_exchanged_is_refused() {
    let base = TowerDescription {
        stations: vec![
            towermodes::Station::new(0.0, 6.0, 0.0351),
            towermodes::Station::new(87.6, 3.87, 0.0247),
        ],
        rna: towermodes::Rna {
            mass_kg: 350e3,
            center_m: [-0.41, 0.0, 1.966427],
            inertia_kg_m2: [37_634_182.0, 24_376_664.3, 22_613_929.0, 0.0, 0.0, 0.0].into(),
        },
        foundation: Foundation::Clamped,
        ..tower()
    };
    for hz in [1.97, 1.98] {
        let problem = Problem {
            unknowns: vec![unknown(&base, "rna.inertia.zz")],
            measured: vec![measured("side-side 2", hz, 0.001)],
            base: base.clone(),
        };
        let error = fitted(&problem).expect_err("no tower has this frequency");
        let CalibrationError::Exchanged {
            mode,
            other,
            jump_hz: [here, beyond],
            ..
        } = &error
        else {
            panic!("{hz}: {error}")
        };
        let names = (mode.to_string(), other.to_string());
        assert_eq!(names, ("side-side 2".to_owned(), "torsion 1".to_owned()));
        assert!((here - 1.969).abs() < 1e-3, "{error}");
        assert!((beyond - 1.965).abs() < 1e-3, "{error}");
    }
}

/// A tower on two segments has fewer modes than are searched; the search ends with them.
#[test]
fn a_mode_that_no_segment_is_left_for_is_refused() {
    let base = tower();
    let problem = Problem {
        unknowns: vec![unknown(&base, "foundation.rocking")],
        base,
        measured: vec![measured("fore-aft 30", 90.0, 0.1)],
    };
    let mut solver = Solver::new(with!(Options, segments = Some(2)));
    let error = calibrate(&problem, &mut solver).expect_err("refused");
    let CalibrationError::NoMode { computed, .. } = error else {
        panic!("{error:?}");
    };
    assert!(computed < 60, "{computed} of two segments");
}
