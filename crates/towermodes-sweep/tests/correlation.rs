//! Correlated numbers: the correlation of the ranks drawn, contradictions, and what stays as it is.

use std::ops::ControlFlow;

use towermodes_files::{
    Correlation, CorrelationError, Distribution, Sampling, SamplingError, SamplingKind, Varied,
};
use towermodes_sweep::{Draw, run};
use towermodes_testing::Says;

use crate::towers::lowest;

/// A number of each distribution, and a list.
fn vary() -> Vec<Varied> {
    let of = |name: &str, distribution| Varied {
        name: name.to_owned(),
        distribution,
        levels: None,
    };
    let uniform = Distribution::Uniform {
        low: 3.3e5,
        high: 3.7e5,
    };
    let normal = Distribution::Normal {
        mean: 2.1e11,
        deviation: 3e9,
        truncated: Some([2.0e11, 2.2e11]),
    };
    let narrow = Distribution::Normal {
        mean: 1.0,
        deviation: 0.02,
        truncated: Some([0.95, 1.05]),
    };
    let lognormal = Distribution::LogNormal {
        mean: 8500.0,
        deviation: 100.0,
        truncated: None,
    };
    vec![
        of("rna.mass", uniform),
        of("material.youngs_modulus", normal),
        of("scale(stations[*].wall)", narrow),
        of("material.density", lognormal),
        of(
            "stations[0].diameter",
            Distribution::Values(vec![5.8, 6.0, 6.2]),
        ),
    ]
}

fn pair(first: &str, second: &str, coefficient: f64) -> Correlation {
    Correlation {
        between: [first.to_owned(), second.to_owned()],
        coefficient,
    }
}

fn sampling(kind: SamplingKind, rows: u64, correlations: Vec<Correlation>) -> Sampling {
    Sampling {
        kind,
        rows,
        seed: 7,
        vary: vary(),
        correlations,
    }
}

fn rows(sampling: &Sampling) -> Vec<[f64; 5]> {
    let draw = Draw::new(sampling).expect("a sampling");
    let row = |row| {
        let mut values = [0.0; 5];
        draw.row(row, &mut values);
        values
    };
    (0..sampling.rows).map(row).collect()
}

/// The correlation of two columns and its standard error, both from the sample: the error is that
/// of the mean of z₁z₂ − r (z₁² + z₂²)/2, of standardized values z.
fn correlation(rows: &[[f64; 5]], [one, other]: [usize; 2]) -> (f64, f64) {
    let count = rows.len() as f64;
    let mean = |of: &dyn Fn(&[f64; 5]) -> f64| rows.iter().map(of).sum::<f64>() / count;
    let [first, second] = [one, other].map(|column| {
        let middle = mean(&|row| row[column]);
        let variance = mean(&|row| (row[column] - middle).powi(2));
        move |row: &[f64; 5]| (row[column] - middle) / variance.sqrt()
    });
    let r = mean(&|row| first(row) * second(row));
    let influence = |row: &[f64; 5]| {
        let (a, b) = (first(row), second(row));
        a * b - 0.5 * r * (a * a + b * b)
    };
    (r, (mean(&|row| influence(row).powi(2)) / count).sqrt())
}

const KINDS: [SamplingKind; 3] = [
    SamplingKind::LatinHypercube,
    SamplingKind::Random,
    SamplingKind::Sobol,
];

/// The rows with each value replaced by its rank.
fn ranks(rows: &[[f64; 5]]) -> Vec<[f64; 5]> {
    let mut ranks = rows.to_vec();
    for column in 0..5 {
        let mut order: Vec<usize> = (0..rows.len()).collect();
        order.sort_by(|a, b| rows[*a][column].total_cmp(&rows[*b][column]));
        for (rank, row) in order.into_iter().enumerate() {
            ranks[row][column] = rank as f64;
        }
    }
    ranks
}

/// Whatever the distributions, ranks whose scores have the correlation r have (6/π) asin(r/2)
/// (Pearson 1907). All pairs: those in the list and those that are not. The rows of random sampling
/// are within four standard errors; the others are more even.
#[test]
fn ranks_have_the_correlations_of_the_list() {
    let listed = [([0, 1], 0.9), ([1, 3], -0.6), ([0, 3], -0.7), ([2, 3], 0.4)];
    let names: Vec<String> = vary().into_iter().map(|varied| varied.name).collect();
    // In any order of the two names.
    let correlations = listed.iter().enumerate().map(|(index, ([a, b], c))| {
        let [a, b] = if index % 2 == 0 { [a, b] } else { [b, a] };
        pair(&names[*a], &names[*b], *c)
    });
    let correlations: Vec<Correlation> = correlations.collect();
    for kind in KINDS {
        let rows = ranks(&rows(&sampling(kind, 1 << 16, correlations.clone())));
        // The last number is one of a list; equal values have no order.
        for one in 0..4 {
            for other in one + 1..4 {
                let found = listed.iter().find(|(pair, _)| *pair == [one, other]);
                let of_scores = found.map_or(0.0, |(_, coefficient)| *coefficient);
                let expected = 6.0 / std::f64::consts::PI * (0.5 * of_scores).asin();
                let (r, error) = correlation(&rows, [one, other]);
                assert!(error < 0.0045, "{error}");
                let away = (r - expected).abs() / error;
                assert!(away < 4.0, "{kind:?} {one} {other}: {r} {expected} {error}");
            }
        }
    }
}

/// A correlation leaves the distribution of each number: its mean and its quartiles.
#[test]
fn each_number_keeps_its_distribution() {
    let strong = vec![
        pair("rna.mass", "material.density", 0.8),
        pair("material.density", "scale(stations[*].wall)", -0.5),
    ];
    for kind in KINDS {
        let count = 1 << 14;
        let [with, without] = [strong.clone(), Vec::new()].map(|c| rows(&sampling(kind, count, c)));
        for column in 0..5 {
            let sorted = |rows: &[[f64; 5]]| {
                let mut values: Vec<f64> = rows.iter().map(|row| row[column]).collect();
                values.sort_by(f64::total_cmp);
                values
            };
            let (with, without) = (sorted(&with), sorted(&without));
            // A quantile of n rows has the probability error √(p(1 − p)/n), 0.4 % at most; five of
            // them, twice: both are samples.
            for place in [count / 4, count / 2, 3 * count / 4] {
                let [place, room] = [place, count / 50].map(|n| n as usize);
                let range = without[place - room]..=without[place + room];
                assert!(range.contains(&with[place]), "{kind:?} {column} {place}");
            }
        }
    }
}

/// Rows as the program has always drawn them, without correlations.
#[test]
#[rustfmt::skip]
fn rows_without_correlations_are_as_ever() {
    let golden = [
        (SamplingKind::Sobol, [343885.60509256955, 211216629626.50195, 1.022848873494205, 8421.472318780587, 5.8], [330980.3758984233, 207956246062.18384, 1.0138857462144444, 8460.61673424784, 6.0]),
        (SamplingKind::Random, [360360.9425042346, 214530242555.98026, 0.9867936240351626, 8428.214603306855, 5.8], [345307.4604202131, 210419108092.52542, 1.0373478864369972, 8434.344350931426, 5.8]),
        (SamplingKind::LatinHypercube, [368220.72188500845, 210134307801.78983, 1.0269798345503955, 8373.607650606984, 6.0], [364270.6149208404, 211564065738.68808, 1.0410398391936517, 8438.511360769095, 6.2]),
    ];
    for (kind, first, last) in golden {
        let rows = rows(&sampling(kind, 500, Vec::new()));
        assert_eq!((rows[0], rows[499]), (first, last), "{kind:?}");
    }
}

/// Numbers that are in no correlation keep their values, to the last bit.
#[test]
fn other_numbers_keep_their_values() {
    for kind in KINDS {
        let correlated = vec![pair("rna.mass", "material.density", 0.5)];
        let [with, without] = [correlated, Vec::new()].map(|c| rows(&sampling(kind, 200, c)));
        for (with, without) in with.iter().zip(&without) {
            let expected = [without[1], without[2], without[4]];
            assert_eq!([with[1], with[2], with[4]], expected);
            assert_ne!(with[3], without[3]);
            assert!((with[0] / without[0] - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn values_that_depend_completely() {
    let mut all = vary();
    all[1].distribution = all[0].distribution.clone();
    all[2].distribution = all[0].distribution.clone();
    for kind in KINDS {
        let mut sampling = sampling(kind, 100, Vec::new());
        sampling.vary.clone_from(&all);
        sampling.correlations = vec![
            pair("rna.mass", "material.youngs_modulus", 1.0),
            pair("rna.mass", "scale(stations[*].wall)", -1.0),
            pair("material.youngs_modulus", "scale(stations[*].wall)", -1.0),
        ];
        for row in rows(&sampling) {
            assert!((row[0] - row[1]).abs() < 1e-6, "{row:?}");
            assert!((row[0] + row[2] - 7e5).abs() < 1e-6, "{row:?}");
        }
    }
}

fn refusal(correlations: Vec<Correlation>) -> (usize, CorrelationError) {
    let refused = Draw::new(&sampling(SamplingKind::Random, 10, correlations));
    match refused {
        Err(SamplingError::Correlation { index, error }) => (index, *error),
        other => panic!("{other:?}"),
    }
}

/// The limits in the message are the limits: inside them the correlations are accepted, outside
/// they are not.
#[test]
fn contradicting_correlations_are_refused_with_what_would_be_right() {
    let [e, wall, density] = [
        "material.youngs_modulus",
        "scale(stations[*].wall)",
        "material.density",
    ];
    let three = |of_last: Option<f64>| {
        let mut correlations = vec![pair(e, wall, 0.9), pair(e, density, 0.8)];
        correlations.extend(of_last.map(|coefficient| pair(wall, density, coefficient)));
        correlations
    };
    let (index, error) = refusal(three(Some(0.1)));
    let CorrelationError::Contradiction {
        coefficient,
        limits,
        between,
    } = &error
    else {
        panic!("{error}")
    };
    assert_eq!((index, *coefficient), (2, Some(0.1)));
    assert_eq!(between, &[wall.to_owned(), density.to_owned()]);
    let half = (0.19_f64 * 0.36).sqrt();
    for (found, expected) in limits.iter().zip([0.72 - half, 0.72 + half]) {
        assert!((found - expected).abs() < 1e-12, "{limits:?}");
    }
    for (inside, outside) in [
        (limits[0] + 1e-6, limits[0] - 1e-6),
        (limits[1] - 1e-6, limits[1] + 1e-6),
    ] {
        let drawn = |c| Draw::new(&sampling(SamplingKind::Random, 10, three(Some(c))));
        assert!(drawn(inside).is_ok(), "{inside}");
        assert!(drawn(outside).is_err(), "{outside}");
    }
    // A pair that is missing: 0 is outside as well.
    let (index, error) = refusal(three(None));
    assert_eq!(index, 1);
    let text = error.to_string();
    assert!(
        text.contains(
            "`scale(stations[*].wall)` and `material.density` have no coefficient, which means 0"
        ) && text.contains("add a coefficient of these two inputs, or reduce the others"),
        "{text}"
    );
}

#[test]
fn pairs_that_cannot_be_correlated_are_refused() {
    let text = |correlation| refusal(vec![correlation]).1.to_string();
    let mass = "rna.mass";
    text(pair(mass, "material.density", 1.2)).says("is 1.2; it must be from -1 to 1");
    text(pair(mass, "material.density", f64::NAN)).says("is NaN");
    text(pair(mass, "water.level", 0.2)).says("`water.level` is not among the varied");
    text(pair(mass, mass, 0.2)).says("cannot be correlated with itself");
    text(pair(mass, "stations[0].diameter", 0.2)).says("has a list of values");
    let (index, error) = refusal(vec![
        pair(mass, "material.density", 0.2),
        pair("material.density", mass, 0.2),
    ]);
    assert!(index == 1, "{error}");
    error.says("is given twice");
    let mut grid = sampling(
        SamplingKind::Grid,
        3,
        vec![pair(mass, "material.density", 0.2)],
    );
    grid.vary[0].distribution = Distribution::Values(vec![1.0]);
    let error = Draw::new(&grid).expect_err("a grid").to_string();
    error.says("a grid has every combination of its values");
}

#[test]
fn correlated_results_do_not_depend_on_the_number_of_threads() {
    let sweep = lowest(&["rna.mass", "material.youngs_modulus"], 1);
    for kind in KINDS {
        let mut sampling = sampling(
            kind,
            300,
            vec![pair("rna.mass", "material.youngs_modulus", 0.6)],
        );
        sampling.vary.truncate(2);
        let draw = Draw::new(&sampling).expect("a sampling");
        let by = |threads| {
            let results = run(&sweep, &draw, threads, &mut |_| ControlFlow::Continue(()));
            let results = results.expect("results");
            results
                .frequency_hz
                .iter()
                .map(|hz| hz.to_bits())
                .collect::<Vec<u64>>()
        };
        assert_eq!(by(1), by(3));
    }
}
