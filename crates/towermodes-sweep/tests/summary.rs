//! Summaries against the definitions of their numbers.

use std::fs::File;
use std::ops::ControlFlow;
use std::path::PathBuf;

use towermodes_analysis::resonance::CampbellOptions;
use towermodes_files::{Distribution, Sampling, SamplingKind, Varied};
use towermodes_sweep::{
    FailedRows, MarginCheck, MarginSummary, QUANTILES, Results, RowRemarks, Slice, Slices, Sweep,
    SweepSource, run,
};
use towermodes_testing::rotor;

use crate::towers::{Folder, lowest, names};

/// Results of one mode with given frequencies, Hz.
fn results(frequency_hz: &[f64]) -> Results {
    let rows = frequency_hz.len();
    Results {
        first_row: 0,
        modes: names(&["fore-aft 1"]),
        mass_kg: vec![2e5; rows],
        certified: vec![true; rows],
        frequency_hz: frequency_hz.to_vec(),
        error_hz: vec![1e-6; rows],
        failures: FailedRows::default(),
        share: vec![1.0; rows],
        warnings: RowRemarks::default(),
        shared: RowRemarks::default(),
    }
}

/// `numpy.quantile(x, q)`, `x.mean()` and `x.std(ddof=1)` of NumPy 2.4 for
/// `x = numpy.sin(numpy.arange(1, 1001)**2)`.
#[test]
fn statistics_are_those_of_numpy() {
    let values: Vec<f64> = (1..=1000).map(|i| f64::from(i * i).sin()).collect();
    let summary = results(&values).summary(None);
    let found = summary.modes[0].frequency_hz.clone().expect("values");
    let close = |value: f64, expected: f64| {
        assert!((value - expected).abs() < 1e-13, "{value} {expected}");
    };
    assert_eq!((found.count, summary.rows, summary.failed), (1000, 1000, 0));
    close(found.mean, -0.002769965922545222);
    close(found.deviation, 0.7090756366241917);
    close(found.min, -0.9999998497899818);
    close(found.max, 0.999999986398821);
    let expected = [
        -0.9999994231781939,
        -0.9994739545628017,
        -0.9848120656929696,
        -0.005820433466775415,
        0.9851742347145263,
        0.9996329474119138,
        0.999994426048485,
    ];
    for (value, expected) in found.quantiles.into_iter().zip(expected) {
        close(value, expected);
    }
    assert_eq!(QUANTILES, [0.001, 0.01, 0.05, 0.5, 0.95, 0.99, 0.999]);
    let mass = summary.mass_kg.expect("masses");
    assert_eq!(mass.mean, 2e5);
    assert_eq!(mass.deviation, 0.0);
    assert_eq!(mass.quantiles[3], 2e5);
}

#[test]
fn few_values_and_none_have_statistics_too() {
    let one = results(&[0.3]).summary(None).modes[0]
        .frequency_hz
        .clone()
        .expect("a value");
    assert_eq!(one.mean, 0.3);
    assert_eq!(one.deviation, 0.0);
    assert_eq!(one.quantiles, [0.3; 7]);
    let two = results(&[0.3, f64::NAN, 0.5]).summary(None).modes[0]
        .frequency_hz
        .clone();
    let two = two.expect("values");
    let expected = (two.count, two.quantiles[3], two.min, two.max);
    assert_eq!(expected, (2, 0.4, 0.3, 0.5));
    let none = results(&[f64::NAN]).summary(None);
    assert_eq!(none.modes[0].frequency_hz, None);
    assert_eq!(results(&[]).summary(None).rows, 0);
}

/// 1P from 6.9 to 12.1 rpm and 5 %: frequencies from 0.115/1.05 = 0.1095238 to 0.201667/0.95 =
/// 0.2122807 Hz are too near. 0.2122811 Hz is outside, but could be too near with its error of
/// 1e-6 Hz; 0.1095243 Hz is too near, but could be outside.
#[test]
fn violated_margins_are_counted() {
    let rotor = rotor(3, 6.9, 12.1);
    let check = MarginCheck::new(rotor, &CampbellOptions::default());
    let frequencies = [
        0.1,
        0.109,
        0.109_524_3,
        0.15,
        0.21,
        0.2122,
        0.212_281_1,
        0.33,
        0.0,
        f64::NAN,
    ];
    let summary = results(&frequencies).summary(Some(&check));
    let margins = &summary.modes[0].margins;
    let multiples: Vec<usize> = margins.iter().map(|margin| margin.multiple).collect();
    assert_eq!(multiples, [1, 3, 6, 9]);
    let expected = MarginSummary {
        multiple: 1,
        violated: 4,
        violated_within_errors: [3, 5],
        count: 8,
    };
    assert_eq!(margins[0], expected);
    assert_eq!(margins[0].probability(), 0.5);
    assert!((margins[0].standard_error() - (0.25_f64 / 8.0).sqrt()).abs() < 1e-16);
    // 3P from 0.345/1.05 = 0.3286 Hz.
    assert_eq!((margins[1].violated, margins[2].violated), (1, 0));
    assert_eq!(summary.modes[0].largest_error_hz, 1e-6);
}

#[test]
fn the_rotor_of_the_base_is_checked_unless_it_is_varied() {
    let check = lowest(&["rna.mass"], 2).margin_check().expect("a rotor");
    assert_eq!((check.rotor.blades, check.margin), (3, 0.05));
    assert_eq!(lowest(&["scale(rotor.rpm[1])"], 2).margin_check(), None);
}

/// Writes all rows into a file.
fn written(folder: &Folder, sweep: &Sweep, source: &SweepSource) -> PathBuf {
    let path = folder.path("all.csv");
    let file = File::create(&path).expect("a file");
    let slice = Slice::all(sweep, source);
    slice
        .write(file, 2, &mut |_| ControlFlow::Continue(()))
        .expect("a slice");
    path
}

/// The standard error is that of independent rows.
#[test]
fn only_random_rows_are_independent() {
    for kind in SamplingKind::ALL {
        let source = SweepSource::sampled(Sampling {
            kind,
            rows: 2,
            seed: 1,
            correlations: Vec::new(),
            vary: vec![Varied {
                name: "rna.mass".to_owned(),
                distribution: Distribution::Values(vec![3e5, 4e5]),
                levels: None,
            }],
        });
        let source = source.expect("a sample");
        let (sweep, folder) = (lowest(&["rna.mass"], 1), Folder::new());
        let path = written(&folder, &sweep, &source);
        let slices = Slices::open(&sweep, &source, &[path]).expect("a slice");
        let summary = slices.summary(None).expect("a summary");
        assert_eq!(summary.rows_are_independent, kind == SamplingKind::Random);
    }
}

#[test]
fn slices_have_the_summary_of_the_results_in_memory() {
    let sweep = lowest(&["rna.mass", "stations[1].wall"], 3);
    let vary = |name: &str, low, high| Varied {
        name: name.to_owned(),
        distribution: Distribution::Uniform { low, high },
        levels: None,
    };
    let source = SweepSource::sampled(Sampling {
        kind: SamplingKind::LatinHypercube,
        rows: 300,
        seed: 1,
        correlations: Vec::new(),
        vary: vec![
            vary("rna.mass", 3e5, 4e5),
            vary("stations[1].wall", -0.001, 0.03),
        ],
    });
    let source = source.expect("a sample");
    let folder = Folder::new();
    let path = written(&folder, &sweep, &source);
    let check = sweep.margin_check();
    let slices = Slices::open(&sweep, &source, &[path]).expect("a slice");
    let of_slices = slices.summary(check.as_ref()).expect("a summary");
    let SweepSource::Sampled { draw, .. } = &source else {
        unreachable!("a sample")
    };
    let holds = !of_slices.rows_are_independent;
    assert!(holds, "a Latin hypercube is more even");
    let in_memory = run(&sweep, draw, 1, &mut |_| ControlFlow::Continue(()));
    let in_memory = in_memory.expect("results");
    assert_eq!(of_slices, in_memory.summary(check.as_ref()));
    assert!(of_slices.failed > 0 && of_slices.failures.len() == 1);
    assert_eq!(of_slices.failures[0].count, of_slices.failed);
}
