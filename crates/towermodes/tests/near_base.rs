//! Towers near a base: solved from the modes of the base they have the names and the frequencies
//! that a solve from nothing finds, whatever was solved before.

use towermodes::{Frequencies, Options, Parameter, Solver, Tower, TowerDescription};
use towermodes_random::{Class, Seed};

/// Relative, for frequencies: those of the eigenvalue computation, and extrapolated ones, which
/// multiply the errors of several meshes.
const FREQUENCY: f64 = 1e-13;
const EXTRAPOLATED: f64 = 1e-12;

/// How the rows of all classes were solved.
#[derive(Debug, Default)]
struct Tally {
    rows: usize,
    near: usize,
}

/// The base with every input value changed by a random factor within a relative spread; none if
/// that is no tower.
fn changed(base: &TowerDescription, spread: f64, seed: &mut Seed) -> Option<Tower> {
    let mut description = base.clone();
    for parameter in Parameter::all(base) {
        let factor = 1.0 + seed.between(-spread, spread);
        // Heights are changed together, so that their order stays.
        if !parameter.is_height() {
            parameter.set(&mut description, factor * parameter.value(base));
        }
    }
    Tower::new(description).ok()
}

fn assert_close(near: &Frequencies, alone: &Frequencies, case: &str) {
    assert_eq!(near.certificate.count, alone.certificate.count, "{case}");
    assert_eq!(near.modes.len(), alone.modes.len(), "{case}");
    for (near, alone) in near.modes.iter().zip(&alone.modes) {
        assert_eq!(near.name(), alone.name(), "{case}");
        let label = near.label();
        let differs = |a: f64, b: f64, most: f64| (a - b).abs() > most * b.abs();
        let own = alone.algebraic_error_hz / alone.frequency_hz;
        assert!(
            !differs(near.frequency_hz, alone.frequency_hz, FREQUENCY.max(own)),
            "{case}, {label}: {} Hz, from nothing {} Hz",
            near.frequency_hz,
            alone.frequency_hz
        );
        let most = EXTRAPOLATED.max(30.0 * own);
        assert!(
            !differs(near.extrapolated_hz, alone.extrapolated_hz, most),
            "{case}, {label}: extrapolated {} Hz, from nothing {} Hz",
            near.extrapolated_hz,
            alone.extrapolated_hz
        );
    }
}

/// Solves rows near the bases of a class, from the bases and from nothing.
fn check(class: Class, bases: u64, rows: u64, spread: f64) -> Tally {
    let options = Options {
        modes: 4,
        segments: Some(20),
        ..Options::default()
    };
    let (mut near, mut alone) = (Solver::new(options.clone()), Solver::new(options));
    let mut tally = Tally::default();
    for number in 0..bases {
        let base = class.description(number);
        let Ok(tower) = Tower::new(base.clone()) else {
            continue;
        };
        if near.start_from(&tower).is_err() {
            continue;
        }
        let mut seed = Seed::new(number);
        for row in 0..rows {
            let Some(tower) = changed(&base, spread, &mut seed) else {
                continue;
            };
            let case = format!("{} {number}, row {row}, ± {spread}", class.name());
            match (near.frequencies(&tower), alone.frequencies(&tower)) {
                (Ok(near), Ok(alone)) => {
                    assert_close(near, alone, &case);
                    tally.rows += 1;
                    tally.near += usize::from(near.is_near_base);
                }
                (Err(near), Err(alone)) => assert_eq!(near, alone, "{case}"),
                (near, alone) => panic!("{case}: {near:?}, from nothing {alone:?}"),
            }
        }
    }
    tally
}

#[test]
fn rows_near_a_base_have_the_frequencies_of_solves_from_nothing() {
    let mut all = Tally::default();
    for class in Class::ALL {
        for spread in [0.02, 0.15] {
            let tally = check(class, 3, 6, spread);
            all.rows += tally.rows;
            all.near += tally.near;
        }
        // So far from the base, the guesses of two modes may lead to one eigenvalue: in row 4 of
        // base 2 of the plain towers both guesses of fore-aft bending lead to the first mode.
        check(class, 3, 6, 0.4);
    }
    // Otherwise the base would not be used.
    assert!(all.rows > 300 && 10 * all.near > 6 * all.rows, "{all:?}");
}

/// As many rows as the book states; `-- --ignored rows_of_every_class --nocapture` prints how many
/// of them were solved from nothing.
#[test]
#[ignore = "takes minutes"]
fn rows_of_every_class_near_a_base() {
    for spread in [0.02, 0.05, 0.15, 0.4] {
        for class in Class::ALL {
            let tally = check(class, 50, 40, spread);
            let alone = tally.rows - tally.near;
            eprintln!(
                "± {spread} {}: {} rows, {alone} from nothing",
                class.name(),
                tally.rows
            );
        }
    }
}

#[test]
fn rows_do_not_depend_on_those_before() {
    let options = Options {
        modes: 4,
        segments: Some(20),
        ..Options::default()
    };
    for class in Class::ALL {
        let base = class.description(1);
        let mut seed = Seed::new(7);
        let rows: Vec<Tower> = (0..6)
            .filter_map(|_| changed(&base, 0.1, &mut seed))
            .collect();
        let solved = |order: &mut dyn Iterator<Item = &Tower>| -> Vec<Option<Frequencies>> {
            let mut solver = Solver::new(options.clone());
            let base = Tower::new(base.clone()).expect("a random tower");
            solver.start_from(&base).ok();
            order
                .map(|tower| solver.frequencies(tower).ok().cloned())
                .collect()
        };
        let forwards = solved(&mut rows.iter());
        let mut backwards = solved(&mut rows.iter().rev());
        backwards.reverse();
        assert_eq!(forwards, backwards, "{}", class.name());
    }
}
