//! The run in memory: rows, threads, names of modes, failures.

use std::ops::ControlFlow;

use towermodes::{Change, Method, Options, Tower, solve};
use towermodes_files::{Distribution, Sampling, SamplingKind, SweepModes, SweepResults, Varied};
use towermodes_sweep::{Base, Columns, Draw, RunError, Sweep, SweepError, run};
use towermodes_testing::{Says, number, rows, with};

use crate::towers::{example, lowest, names, solved, sweep, tower};

/// Each row is the changed tower as `solve` solves it, with all digits.
/// A row starts from the modes of the base, a solve from nothing: they differ by rounding.
fn assert_same_frequency(found_hz: f64, expected_hz: f64) {
    let ratio = found_hz / expected_hz;
    assert!(
        (ratio - 1.0).abs() < 1e-13,
        "{found_hz} Hz, {expected_hz} Hz"
    );
}

#[test]
fn a_row_is_the_changed_tower() {
    let sweep = lowest(&["rna.mass", "scale(stations[*].wall)"], 4);
    let (masses, walls) = ([3.5e5, 3.3e5, 3.7e5], [1.0, 0.97, 1.04]);
    let results = solved(&sweep, &[&masses, &walls], 1);
    assert!(results.failures.is_empty());
    for row in 0..3 {
        let mut description = tower(4e7);
        description.rna.mass_kg = masses[row];
        for station in &mut description.stations {
            station.wall_thickness_m *= walls[row];
        }
        let tower = Tower::new(description).expect("a tower");
        let options = with!(Options, segments = Some(20), modes = 4);
        let solution = solve(&tower, &options).expect("a solution");
        for (index, name) in sweep.modes().iter().enumerate() {
            let mode = solution.mode(name.family, name.order).expect("a mode");
            let found_hz = results.frequency_hz[4 * row + index];
            assert_same_frequency(found_hz, mode.extrapolated_hz);
            let change_hz = results.error_hz[4 * row + index] - mode.error_hz();
            assert!(change_hz.abs() < 1e-12 * found_hz);
        }
        assert_eq!(results.mass_kg[row], tower.mass_kg());
        assert!(results.certified[row]);
    }
}

/// A density in g/cm³ is unusual; the rows that have it are counted, whoever solves them.
#[test]
fn unusual_input_that_the_base_does_not_have_is_a_warning() {
    let sweep = lowest(&["material.density"], 1);
    let densities: Vec<f64> = (0..300).map(|i| [8500.0, 7.85, 8400.0][i % 3]).collect();
    for threads in [1, 3] {
        let warnings = solved(&sweep, &[&densities], threads).warnings;
        assert_eq!(warnings.rows, 100);
        let rows: Vec<u64> = warnings.first.iter().map(|(row, _)| *row).collect();
        assert_eq!(rows, [1, 4, 7, 10, 13]);
        let sentence = &warnings.first[0].1;
        sentence.begins("material.density: ");
        sentence.says("7.85 kg/m3");
    }
    let mut light = tower(4e7);
    light.materials[0].density_kg_per_m3 = 7.85;
    let results = with!(SweepResults, modes = SweepModes::Lowest(1));
    let of_light = self::sweep(Base::from(light), &["rna.mass"], &results);
    assert_eq!(solved(&of_light, &[&[3e5]], 1).warnings.rows, 0);
}

/// 1000 rows of a sample that has failing rows too.
#[test]
fn results_do_not_depend_on_the_number_of_threads() {
    let sweep = lowest(&["rna.mass", "stations[1].wall"], 4);
    let vary = |name: &str, low, high| Varied {
        name: name.to_owned(),
        distribution: Distribution::Uniform { low, high },
        levels: None,
    };
    let draw = Draw::new(&Sampling {
        kind: SamplingKind::Random,
        rows: 1000,
        seed: 3,
        correlations: Vec::new(),
        vary: vec![
            vary("rna.mass", 3e5, 4e5),
            vary("stations[1].wall", -0.001, 0.05),
        ],
    });
    let draw = draw.expect("a sample");
    let by = |threads| {
        let results = run(&sweep, &draw, threads, &mut |_| ControlFlow::Continue(()));
        let results = results.expect("results");
        let bits = |numbers: &[f64]| numbers.iter().map(|n| n.to_bits()).collect::<Vec<u64>>();
        (
            bits(&results.frequency_hz),
            bits(&results.error_hz),
            bits(&results.mass_kg),
            results.failures,
        )
    };
    let alone = by(1);
    assert!((5..50).contains(&alone.3.len()), "{}", alone.3.len());
    for threads in [2, 3, 8, 500] {
        assert!(by(threads) == alone, "{threads} threads");
    }
}

#[test]
fn a_row_that_fails_is_a_row_with_its_sentence() {
    let sweep = lowest(&["rna.mass", "stations[2].wall"], 2);
    let masses = [3.5e5, 3.5e5, f64::NAN, f64::INFINITY, 3.5e5];
    let walls = [0.019, -1.0, 0.019, 0.019, 0.019];
    let results = solved(&sweep, &[&masses, &walls], 1);
    let failures: Vec<(u64, &str)> = results.failures.iter().collect();
    let expected = [
        (
            1,
            "stations[2].wall: wall thickness is -1 m; it must be positive",
        ),
        (2, "rna.mass is NaN; it must be finite"),
        (3, "rna.mass is inf; it must be finite"),
    ];
    assert_eq!(failures, expected);
    for (row, mass_kg) in results.mass_kg.iter().enumerate() {
        let failed = (1..4).contains(&row);
        assert_eq!(mass_kg.is_nan(), failed);
        assert_eq!(results.certified[row], !failed);
        assert_eq!(results.frequency_hz[2 * row].is_nan(), failed);
    }
    assert_eq!(results.frequency_hz[0], results.frequency_hz[8]);
}

/// With more inertia about the axis torsion comes below the second bending modes: its column
/// follows it, and the bending frequencies of their columns do not change.
#[test]
fn columns_stay_with_their_modes_where_frequencies_cross() {
    let wanted = names(&["torsion 1", "fore-aft 2"]);
    let results = with!(SweepResults, modes = SweepModes::Named(wanted));
    let sweep = sweep(Base::from(tower(4e7)), &["rna.inertia.zz"], &results);
    let inertias: Vec<f64> = (0..40).map(|i| 2e6 * 1.09_f64.powi(i)).collect();
    let results = solved(&sweep, &[&inertias], 1);
    assert!(results.failures.is_empty());
    let torsion: Vec<f64> = results.frequencies_hz(0).collect();
    let bending: Vec<f64> = results.frequencies_hz(1).collect();
    assert!(torsion[0] > bending[0], "they cross");
    assert!(torsion[39] < bending[39], "they cross");
    for row in 1..40 {
        // f² is about inversely proportional to the inertia, less so where the tower's own matters.
        let ratio = torsion[row - 1] / torsion[row];
        assert!(ratio > 1.0 && ratio < 1.09_f64.sqrt(), "{row}: {ratio}");
        assert!((bending[row] / bending[0] - 1.0).abs() < 1e-12, "{row}");
    }
}

/// A mode that is not among the lowest of a row is looked for among more modes; if it is not there
/// either, its cell is empty and the sentence says so.
#[test]
fn a_mode_that_is_far_above_is_missing_with_a_sentence() {
    let wanted = names(&["fore-aft 1", "torsion 1"]);
    let results = with!(SweepResults, modes = SweepModes::Named(wanted));
    let changes = ["rna.inertia.zz", "material.shear_modulus"];
    let sweep = sweep(Base::from(tower(4e7)), &changes, &results);
    let asked = sweep.options().modes;
    let results = solved(&sweep, &[&[4e7, 1e6, 0.0], &[8.08e10, 8.08e10, 8e14]], 1);
    let torsion: Vec<f64> = results.frequencies_hz(1).collect();
    assert!(torsion[0] < torsion[1] && torsion[2].is_nan());
    let sentence = format!("torsion 1 is not among the lowest {} modes", asked + 16);
    assert_eq!(results.failures.len(), 1);
    assert_eq!(results.failures.get(0), Some((2, sentence.as_str())));
    assert!(results.certified[2] && results.frequency_hz[4] > 0.2);
}

#[test]
fn a_sweep_that_cannot_begin_says_why() {
    let base = || Base::from(tower(4e7));
    let changes = |names: &[&str]| {
        let parsed = Change::parse_all(names.iter().copied(), &base().description);
        parsed.expect("changes")
    };
    let with = |modes| with!(SweepResults, modes);
    let refused =
        |base, changes, modes| Sweep::new(base, changes, &with(modes)).expect_err("refused");
    let nothing = refused(base(), Vec::new(), SweepModes::Lowest(4));
    assert_eq!(nothing, SweepError::NothingVaried);
    let twice = changes(&["scale(rna.mass)", "scale(rna.mass)"]);
    let twice = refused(base(), twice, SweepModes::Lowest(4)).to_string();
    assert_eq!(twice, "`scale(rna.mass)` is changed twice; remove one");
    let mass = changes(&["rna.mass"]);
    let none = refused(base(), mass.clone(), SweepModes::Lowest(0));
    assert_eq!(none, SweepError::NoModes);
    let none = refused(base(), mass.clone(), SweepModes::Named(Vec::new()));
    assert_eq!(none, SweepError::NoModes);
    let twice = SweepModes::Named(names(&["torsion 1", "torsion 1"]));
    let twice = refused(base(), mass.clone(), twice);
    assert!(matches!(twice, SweepError::RepeatedMode { .. }));
    let surge = refused(base(), mass.clone(), SweepModes::Named(names(&["surge"])));
    let sentence = surge.to_string();
    let expected = "`surge` is not among the lowest 64 modes of the base tower; these are fore-aft 1, side-side 1, ";
    sentence.begins(expected);
    let mut no_tower = base();
    no_tower.description.stations.clear();
    let refused_base = refused(no_tower, mass.clone(), SweepModes::Lowest(4));
    assert!(matches!(refused_base, SweepError::Base(_)));
    let huge = refused(base(), mass, SweepModes::Lowest(1_000_000));
    assert!(matches!(huge, SweepError::Unsolved(_)), "{huge}");
}

#[test]
fn the_watch_ends_a_sweep_and_sees_all_rows() {
    let sweep = lowest(&["rna.mass"], 2);
    let masses = vec![3.5e5; 3000];
    let columns = Columns::new(vec![&masses]).expect("a column");
    for threads in [1, 2] {
        let stopped = run(&sweep, &columns, threads, &mut |_| ControlFlow::Break(()));
        assert_eq!(stopped, Err(RunError::Stopped));
        let mut last = 0;
        let mut watch = |done| {
            assert!(done >= last);
            last = done;
            ControlFlow::Continue(())
        };
        run(&sweep, &columns, threads, &mut watch).expect("results");
        assert_eq!(last, 3000);
    }
}

#[test]
fn rows_need_a_value_for_each_change() {
    let sweep = lowest(&["rna.mass", "stations[1].wall"], 2);
    let masses = [3.5e5];
    let columns = Columns::new(vec![&masses]).expect("a column");
    let refused = run(&sweep, &columns, 1, &mut |_| ControlFlow::Continue(()));
    let expected = RunError::Width {
        values: 1,
        changes: 2,
    };
    assert_eq!(refused, Err(expected));
    let differ = Columns::new(vec![&masses, &[0.02, 0.03]]).expect_err("lengths");
    let expected =
        "column 1 has 2 rows, but the first column has 1; all columns need the same number";
    assert_eq!(differ.to_string(), expected);
}

/// The message on a row names numbers as columns do: with indices from 0.
#[test]
fn sentences_name_numbers_as_columns_do() {
    let table = r#"
        scale(stations[1].wall) | -1.0 | stations[1].wall: wall thickness is -0.023 m
        stations[2].wall | 9.0 | stations[2].wall: outer diameter 3.87 m is less than twice
        stations[1].height | 99.0 | stations[2].height: height 87.6 m is below
        material.density | -1.0 | material.density: density is -1 kg
        rna.mass | -1.0 | rna.mass: the mass is -1 kg
        rotor.rpm[0] | -1.0 | rotor.rpm[0]:␣
        "#;
    for [column, value, expected] in rows(table) {
        let value = number(value);
        let results = solved(&lowest(&[column], 2), &[&[value]], 1);
        let (_, sentence) = results.failures.get(0).expect("a row that failed");
        assert!(sentence.starts_with(expected), "{column}: {sentence}");
    }
}

/// Without mass of its own the tower has the modes of its point masses only. The others are not
/// resolvable in double precision: those that are known stay.
#[test]
fn a_row_keeps_its_modes_when_more_cannot_be_computed() {
    let results = SweepResults {
        modes: SweepModes::Named(names(&["fore-aft 1", "torsion 1"])),
        ..SweepResults::default()
    };
    let changes = ["material.density", "rna.inertia.zz"];
    let sweep = sweep(Base::from(tower(4e9)), &changes, &results);
    let results = solved(&sweep, &[&[1e-12], &[1e-6]], 1);
    let (_, sentence) = results.failures.get(0).expect("a row that failed");
    let expected = "torsion 1 is not among the lowest ";
    sentence.begins(expected);
    sentence.says(" modes; more could not be computed: ");
    let mut description = tower(4e9);
    description.materials[0].density_kg_per_m3 = 1e-12;
    description.rna.inertia_kg_m2.zz = 1e-6;
    let tower = Tower::new(description).expect("a tower");
    let options = with!(Options, segments = Some(20), modes = sweep.options().modes);
    let solution = solve(&tower, &options).expect("the modes that the row has");
    assert_same_frequency(results.frequency_hz[0], solution.modes[0].extrapolated_hz);
    assert!(results.certified[0] && results.frequency_hz[1].is_nan());
}

/// Rows of a larger table keep their numbers.
#[test]
fn rows_are_counted_from_the_first_one_of_their_source() {
    let sweep = lowest(&["rna.mass"], 2);
    let columns = Columns::new(vec![&[3e5, -1.0]])
        .expect("a column")
        .from_row(70);
    let results = run(&sweep, &columns, 1, &mut |_| ControlFlow::Continue(()));
    let results = results.expect("results");
    assert_eq!((results.first_row, results.rows()), (70, 2));
    assert_eq!(results.failures.get(0).map(|(row, _)| row), Some(71));
}

#[test]
fn no_rows_give_no_results() {
    let sweep = lowest(&["rna.mass"], 2);
    let results = solved(&sweep, &[&[]], 4);
    assert_eq!((results.rows(), results.failures.len()), (0, 0));
}

/// A BModes deck prescribes its method and elements: a sweep uses them, as `solve` does.
#[test]
fn a_deck_is_solved_as_it_prescribes() {
    let input = example("nrel-5mw.bmi");
    assert_eq!(input.prescribed.method, Some(Method::Bmodes));
    let base = Base::from(&input);
    let sweep = sweep(base.clone(), &["scale(rna.mass)"], &SweepResults::default());
    let results = solved(&sweep, &[&[1.0]], 1);
    let options = Options {
        method: Method::Bmodes,
        borders_m: input.prescribed.borders_m.clone(),
        modes: 4,
        ..Options::default()
    };
    let tower = Tower::new(input.description.clone()).expect("a tower");
    let solution = solve(&tower, &options).expect("a solution");
    for (index, mode) in solution.modes.iter().enumerate() {
        assert_eq!(results.frequency_hz[index], mode.extrapolated_hz);
    }
    let other = SweepResults {
        segments: Some(30),
        method: Some(Method::Rmje),
        ..SweepResults::default()
    };
    let changed = Change::parse_all(["rna.mass"], &base.description).expect("a change");
    let options = Sweep::new(base, changed, &other)
        .expect("a sweep")
        .options()
        .clone();
    assert_eq!((options.method, options.segments), (Method::Rmje, Some(30)));
    assert_eq!(options.borders_m, None);
}
