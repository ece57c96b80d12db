//! Fits that begin at a symmetric tower, whose frequencies are stationary.

use towermodes::{Change, Foundation, Rna, TowerDescription};
use towermodes_design::calibration::{Calibration, CalibrationError, Problem};
use towermodes_testing::{Says, changed, stations};

use super::{fitted, frequencies, measured, remarks, tower, unknown, with_prior};

/// A tower that is symmetric about its fore-aft plane, as the example of the NREL 5 MW turbine.
fn symmetric() -> TowerDescription {
    TowerDescription {
        stations: stations(&[(0.0, 6.0, 0.0351), (87.6, 3.87, 0.0247)]),
        rna: Rna {
            mass_kg: 350e3,
            center_m: [-0.41, 0.0, 1.966427],
            inertia_kg_m2: [37634182.0, 24376664.3, 22613929.0, 0.0, 0.0, 0.0].into(),
        },
        foundation: Foundation::Clamped,
        ..tower()
    }
}

/// One number of a symmetric tower that is 0, fitted to one frequency.
fn from_symmetry(
    name: &str,
    bounds: Option<[f64; 2]>,
    mode: &str,
    hz: f64,
) -> Result<Calibration, CalibrationError> {
    let base = symmetric();
    let number = changed!(unknown(&base, name), bounds);
    fitted(&Problem {
        measured: vec![measured(mode, hz, 0.001)],
        unknowns: vec![number],
        base,
    })
}

/// With the center of mass in the plane of symmetry the frequency does not change with its distance
/// to first order. The fit starts beside it, and ends where the tower has the measured frequency.
#[test]
fn a_symmetric_start_does_not_stop_a_fit() {
    for (name, value, bounds) in [
        ("rna.center[1]", 20.0, [0.0, 45.0]),
        ("rna.center[1]", 20.0, [-45.0, 45.0]),
        ("rna.inertia.xy", 2e7, [0.0, 4e7]),
        ("rna.inertia.xy", 2e7, [-4e7, 4e7]),
    ] {
        let mut known = symmetric();
        let change = Change::parse(name, &known).expect("a change");
        change.apply(&mut known, value);
        for mode in ["fore-aft 1", "fore-aft 2"] {
            let [before, hz] = [&symmetric(), &known].map(|tower| frequencies(tower, &[mode])[0]);
            eprintln!("{name} {bounds:?} {mode}: {before} to {hz} Hz");
            let found = match from_symmetry(name, Some(bounds), mode, hz) {
                Ok(found) => found,
                Err(error) => panic!("{error}"),
            };
            let number = &found.unknowns[0];
            eprintln!("{number:?}");
            assert!((number.value / value - 1.0).abs() < 1e-5, "{number:?}");
            assert!(number.has_effect, "{number:?}");
            assert!(number.deviation.is_some(), "{number:?}");
        }
    }
}

/// The symmetric tower has the highest frequency of all: 0.32146 Hz.
#[test]
fn where_the_symmetric_start_is_the_best_tower_the_number_is_not_called_arbitrary() {
    let fit = |bounds, hz| from_symmetry("rna.center[1]", bounds, "fore-aft 1", hz);
    let at_bound = fit(Some([0.0, 45.0]), 0.33).expect("a fit");
    assert!(at_bound.unknowns[0].value.abs() < 1e-3, "{at_bound:?}");
    let said = remarks(&at_bound).join("\n");
    said.says("only with a larger change");
    assert!(!said.contains("arbitrary"), "{said}");
    let both = fit(Some([-45.0, 45.0]), 0.33).expect_err("above the highest");
    both.begins("no value of the fitted inputs");
    let hz = frequencies(&symmetric(), &["fore-aft 1"])[0];
    let at_rest = fit(Some([-45.0, 45.0]), hz).expect_err("no first derivative");
    assert!(
        at_rest.to_string().starts_with(
            "`rna.center[1]` does not change any measured frequency to first order (at rna.center[1] = 0)"
        ),
        "{at_rest}"
    );
    let of_no_size = fit(None, 0.29).expect_err("no step is known");
    of_no_size.ends("; give it bounds or a prior");
}

/// A prior says how large the number may be, as bounds do.
#[test]
fn a_prior_at_the_symmetric_value_gives_way_to_the_measurement() {
    let base = symmetric();
    let problem = Problem {
        measured: vec![measured("fore-aft 1", 0.29, 0.001)],
        unknowns: vec![with_prior(&base, "rna.center[1]", 0.0, 10.0)],
        base,
    };
    let found = fitted(&problem).expect("a fit");
    let number = &found.unknowns[0];
    // Without a prior 19.7 m; the prior pulls to 0 by about (19.7/10)(0.36/10) deviations.
    assert!((19.4..19.8).contains(&number.value), "{number:?}");
}
