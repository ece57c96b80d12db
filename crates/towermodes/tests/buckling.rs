//! Towers close to the buckling limit, on both sides of it: the result or the error has the factor.

use crate::towers;

use towermodes::{Method, Options, Solution, SolveError, Tower, Warning, solve};
use towermodes_testing::{Says, changed, with};
use towers::{assert_close, reference_350t};

fn options(method: Method) -> Options {
    with!(Options, method, points = 2)
}

fn under(gravity_m_per_s2: f64, method: Method) -> Result<Solution, SolveError> {
    let tower = Tower::new(changed!(reference_350t(), gravity_m_per_s2));
    solve(&tower.expect("a valid tower"), &options(method))
}

/// The gravity that just buckles the tower as a method has it, m/s².
fn critical_m_per_s2(method: Method) -> f64 {
    let standing = under(9.81, method).expect("it stands");
    9.81 * standing.buckling_load_factor.expect("it carries weights")
}

const METHODS: [Method; 4] = [
    Method::Spectral,
    Method::RmjeExact,
    Method::Lumped,
    Method::Bmodes,
];

#[test]
fn a_tower_that_just_stands_has_its_modes_and_its_factor() {
    for method in METHODS {
        let critical = critical_m_per_s2(method);
        let lowest = |beyond: f64| {
            let solution = under(critical / (1.0 + beyond), method).expect("it stands");
            let factor = solution.buckling_load_factor.expect("it carries weights");
            assert!((factor - 1.0 - beyond).abs() < 1e-9, "{factor} {beyond}");
            let is_told = |w: &Warning| matches!(w, Warning::VergeOfBuckling { .. });
            assert!(solution.warnings.iter().any(is_told));
            // The others do not know of it.
            let third = &solution.modes[2];
            assert!(third.error_hz() < 1e-2 * third.frequency_hz, "{third:?}");
            solution.modes[0].frequency_hz
        };
        // To first order the square of the lowest frequency is in proportion to what is left of the
        // weights that the tower bears.
        let name = method.name();
        assert_close(lowest(1e-5) / lowest(1e-3), 0.1, 1e-2, name);
        assert_close(lowest(1e-6) / lowest(1e-4), 0.1, 1e-2, name);
    }
}

#[test]
fn a_tower_that_just_buckles_is_told_by_how_much() {
    for beyond in [1e-3, 1e-6] {
        let critical = critical_m_per_s2(Method::Spectral);
        let error = under(critical * (1.0 + beyond), Method::Spectral).expect_err("it buckles");
        let SolveError::Buckles { load_factor } = error else {
            panic!("{error}");
        };
        assert!((1.0 - load_factor - beyond).abs() < 1e-2 * beyond);
        let text = error.to_string();
        text.says("close to the buckling limit");
        let shown = if beyond == 1e-6 {
            "0.9999990"
        } else {
            "0.999001"
        };
        text.says(shown);
    }
    // Far beyond, nothing is close.
    let text = under(500.0, Method::Spectral)
        .expect_err("it buckles")
        .to_string();
    text.says("buckles");
    assert!(!text.contains("close to buckling"), "{text}");
}

/// On few segments a tower can buckle that stands as a beam.
#[test]
fn segments_that_buckle_where_the_beam_stands_are_told_apart() {
    let (beam, chain) = (
        critical_m_per_s2(Method::Spectral),
        critical_m_per_s2(Method::Lumped),
    );
    assert!(chain < beam, "{chain} {beam}");
    let between = under(0.5 * (beam + chain), Method::Lumped).expect_err("it buckles");
    let SolveError::BucklesOnSegments {
        segments,
        load_factor,
        of_the_beam,
    } = between
    else {
        panic!("{between}");
    };
    assert!(segments == 100 && load_factor < 1.0 && of_the_beam > 1.0);
    let beyond = under(1.0001 * beam, Method::Lumped);
    assert!(matches!(beyond, Err(SolveError::Buckles { .. })));
}

#[test]
fn what_rounding_decides_is_still_an_answer() {
    for method in METHODS {
        let critical = critical_m_per_s2(method);
        for beyond in [-1e-9, -1e-12, 0.0, 1e-12, 1e-9] {
            match under(critical * (1.0 + beyond), method) {
                Ok(solution) => {
                    let factor = solution.buckling_load_factor.expect("weights");
                    assert!((factor - 1.0).abs() < 1e-8);
                }
                Err(SolveError::Buckles { .. } | SolveError::BucklesOnSegments { .. }) => {}
                Err(error) => panic!("{} {beyond}: {error}", method.name()),
            }
        }
    }
}
