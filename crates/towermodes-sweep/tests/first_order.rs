//! Scatter to first order: against closed forms, against random rows for small scatter, and the
//! difference from random rows for large scatter.

use std::ops::ControlFlow;

use towermodes::{Rna, Solver};
use towermodes_files::{
    Correlation, Distribution, Sampling, SamplingKind, SweepModes, SweepResults, Varied,
};
use towermodes_sweep::{Base, Draw, FirstOrderError, NoScatter, Scatter, Statistics, Sweep, run};
use towermodes_testing::{Close, Says, assert_matches, changed};

use crate::towers::{lowest, solved, sweep, tower};

const NAMES: [&str; 3] = [
    "rna.mass",
    "scale(stations[*].wall)",
    // Both: with one of them alone Poisson's ratio soon becomes impossible, and the row fails.
    "scale(material.youngs_modulus, material.shear_modulus)",
];

/// With it the first frequency is at the border of the margin of 3P.
const MASS_KG: f64 = 262e3;

fn varied(name: &str, distribution: Distribution) -> Varied {
    Varied {
        name: name.to_owned(),
        distribution,
        levels: None,
    }
}

fn sampling(rows: u64, vary: Vec<Varied>, correlations: Vec<Correlation>) -> Sampling {
    Sampling {
        kind: SamplingKind::Random,
        rows,
        seed: 3,
        vary,
        correlations,
    }
}

fn pair(first: &str, second: &str, coefficient: f64) -> Correlation {
    Correlation {
        between: [first.to_owned(), second.to_owned()],
        coefficient,
    }
}

fn normal(mean: f64, deviation: f64) -> Distribution {
    Distribution::Normal {
        mean,
        deviation,
        truncated: None,
    }
}

fn lognormal(mean: f64, deviation: f64) -> Distribution {
    Distribution::LogNormal {
        mean,
        deviation,
        truncated: None,
    }
}

/// Normal, uniform and lognormal inputs with a coefficient of variation.
fn of_each_kind(variation: f64) -> Vec<Varied> {
    let half = 3_f64.sqrt() * variation;
    let uniform = Distribution::Uniform {
        low: 1.0 - half,
        high: 1.0 + half,
    };
    let distributions = [
        normal(MASS_KG, MASS_KG * variation),
        uniform,
        lognormal(1.0, variation),
    ];
    let named = NAMES.iter().zip(distributions);
    named
        .map(|(name, distribution)| varied(name, distribution))
        .collect()
}

/// The scatter of the first mode, its statistics in random rows, and the share of the rows that
/// violate the margin of 3P; with the probability that the first order gives.
fn both(sampling: &Sampling, sweep: &Sweep) -> (Scatter, Statistics, [f64; 2]) {
    let check = sweep.margin_check().expect("a rotor");
    assert_eq!(check.multiples[1], 3);
    let first = sweep
        .first_order(sampling, Some(&check), Solver::default())
        .expect("first order");
    let scatter = first.modes[0].scatter.clone().expect("derivatives");
    let draw = Draw::new(sampling).expect("a sampling");
    let rows = run(sweep, &draw, 2, &mut |_| ControlFlow::Continue(())).expect("rows");
    assert!(rows.failures.is_empty());
    let summary = rows.summary(Some(&check));
    let mode = &summary.modes[0];
    let probabilities = [scatter.violated[1], mode.margins[1].probability()];
    (
        scatter,
        mode.frequency_hz.clone().expect("rows"),
        probabilities,
    )
}

/// Half the sum of second derivatives times variances, by second differences of rows with a tenth
/// of a deviation; of the first mode, with independent inputs.
fn second_order_hz(sampling: &Sampling, sweep: &Sweep, variation: f64) -> f64 {
    let means = [MASS_KG, 1.0, 1.0];
    let at = |index: usize, factor: f64| {
        let mut values = means[3 - sampling.vary.len()..].to_vec();
        values[index] *= 1.0 + factor * variation;
        let columns: Vec<&[f64]> = values.iter().map(std::slice::from_ref).collect();
        solved(sweep, &columns, 1).frequency_hz[0]
    };
    let of_one = |index| (at(index, 0.1) + at(index, -0.1) - 2.0 * at(index, 0.0)) / 0.01;
    (0..sampling.vary.len())
        .map(|index| 0.5 * of_one(index))
        .sum()
}

#[test]
fn small_scatter_is_that_of_random_rows_within_their_confidence() {
    const ROWS: u64 = 20_000;
    let sweep = lowest(&NAMES, 2);
    for correlations in [
        Vec::new(),
        vec![
            pair(NAMES[0], NAMES[1], 0.8),
            pair(NAMES[1], NAMES[2], -0.5),
        ],
    ] {
        let (scatter, sample, [probability, share]) =
            both(&sampling(ROWS, of_each_kind(0.005), correlations), &sweep);
        let rows = ROWS as f64;
        let error_hz = sample.deviation / rows.sqrt();
        let mean_hz = scatter.mean_hz + scatter.mean_shift_hz.expect("a shift");
        let holds = (mean_hz - sample.mean).abs() < 4.0 * error_hz;
        assert!(holds, "{scatter:?} {sample:?}");
        // The deviation of the deviation of n normal values is σ/√(2n): 0.5 %.
        let ratio = scatter.deviation_hz / sample.deviation;
        assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
        assert!((scatter.shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        // Not 0 and not 1, where every answer would do.
        assert!((0.01..0.99).contains(&share), "{share}");
        let error = (share * (1.0 - share) / rows).sqrt();
        probability.within(share, 4.0 * error);
    }
}

/// The mean of 20000 rows differs from the first order by far more than chance, and by what the
/// second derivatives say. Wall and stiffness, whose curvatures have the same sign.
#[test]
fn large_scatter_differs_by_the_curvature() {
    const ROWS: u64 = 20_000;
    const VARIATION: f64 = 0.15;
    let vary = of_each_kind(VARIATION).split_off(1);
    let sampling = sampling(ROWS, vary, Vec::new());
    let sweep = lowest(&NAMES[1..], 2);
    let (scatter, sample, _) = both(&sampling, &sweep);
    let error_hz = sample.deviation / (ROWS as f64).sqrt();
    let difference_hz = sample.mean - scatter.mean_hz;
    let holds = difference_hz.abs() > 6.0 * error_hz;
    assert!(holds, "{difference_hz} {error_hz}");
    let second_hz = second_order_hz(&sampling, &sweep, VARIATION);
    difference_hz.within(second_hz, 4.0 * error_hz);
    let shift_hz = scatter.mean_shift_hz.expect("a shift");
    shift_hz.close_to(second_hz, 0.05);
}

/// A clamped tower without anything on it and without gravity has f ∝ √(E/ρ).
fn bare() -> Sweep {
    let description = changed!(tower(0.0), rna = Rna::point(0.0), gravity_m_per_s2 = 0.0);
    let results = SweepResults {
        modes: SweepModes::Lowest(2),
        rotary_inertia: true,
        ..SweepResults::default()
    };
    let names = [
        "scale(material.youngs_modulus, material.shear_modulus)",
        "scale(material.density)",
    ];
    sweep(Base::from(description), &names, &results)
}

/// Correlated lognormal factors e and r on stiffness and density: with f = f₀ √(e/r) all terms have
/// closed forms.
#[test]
fn a_product_of_powers_has_the_closed_form() {
    let bare = bare();
    let names: Vec<&str> = bare.changes().iter().map(|change| change.name()).collect();
    let (e, r, coefficient) = (0.02, 0.008, 0.9);
    let vary = vec![
        varied(names[0], lognormal(1.1, 1.1 * e)),
        varied(names[1], lognormal(0.9, 0.9 * r)),
    ];
    // The scores whose values have this coefficient (Liu and Der Kiureghian 1986).
    let deviations = [e, r].map(|variation: f64| (variation * variation).ln_1p().sqrt());
    let of_scores = (coefficient * e * r).ln_1p() / (deviations[0] * deviations[1]);
    let sampling = sampling(1, vary, vec![pair(names[0], names[1], of_scores)]);
    let check = bare.margin_check().expect("a rotor");
    let first = bare
        .first_order(&sampling, Some(&check), Solver::default())
        .expect("first order");
    assert_eq!(first.inputs[1].mean, 0.9);
    assert_eq!(first.inputs[1].deviation, 0.9 * r);
    for mode in &first.modes {
        let scatter = mode.scatter.as_ref().expect("derivatives");
        let close = |found: f64, expected: f64, tolerance: f64| {
            found.close_to(expected, tolerance);
        };
        // The derivative has its own mesh, with a border at each station.
        close(scatter.hz_per_unit[0], 0.5 * scatter.mean_hz / 1.1, 1e-5);
        close(scatter.hz_per_unit[1], -0.5 * scatter.mean_hz / 0.9, 1e-5);
        let variance = 0.25 * (e * e + r * r - 2.0 * coefficient * e * r);
        close(
            scatter.deviation_hz,
            scatter.mean_hz * variance.sqrt(),
            1e-5,
        );
        // The density makes up for a part of what it is correlated with: a negative share.
        let share = 0.25 * (r * r - coefficient * e * r) / variance;
        assert!(share < -0.3);
        close(scatter.shares[1], share, 1e-6);
        close(scatter.shares[0], 1.0 - share, 1e-6);
        let second = -0.125 * e * e + 0.375 * r * r - 0.25 * coefficient * e * r;
        let shift_hz = scatter.mean_shift_hz.expect("a shift");
        close(shift_hz, scatter.mean_hz * second, 2e-3);
    }
}

/// f ∝ 1/√ρ: a deviation d of the density moves the mean by ½ (1/√(1 + d) + 1/√(1 − d)) − 1, and
/// the frequency has the deviation d/2.
#[test]
fn a_large_shift_of_the_mean_is_a_doubt() {
    let results = SweepResults {
        modes: SweepModes::Lowest(2),
        rotary_inertia: true,
        ..SweepResults::default()
    };
    let base = Base::from(bare().base().clone());
    let density = "scale(material.density)";
    let sweep = sweep(base, &[density], &results);
    let doubts = |deviation: f64| {
        let vary = vec![varied(density, lognormal(1.0, deviation))];
        let found = sweep.first_order(&sampling(1, vary, Vec::new()), None, Solver::default());
        found.expect("first order").doubts()
    };
    assert_eq!(doubts(0.1), Vec::<String>::new());
    let said = doubts(0.4);
    assert_eq!(said.len(), 2, "{said:?}");
    let shift = 0.5 * (1.4_f64.powf(-0.5) + 0.6_f64.powf(-0.5)) - 1.0;
    let percent = format!("{:.0} % of its standard deviation", 100.0 * shift / 0.2);
    said[0].begins("fore-aft 1: the curvature moves the mean by 0.0");
    assert!(said[0].contains(&percent), "{said:?} {percent}");
    said[0].ends("not reliable; solve rows");
}

/// The exact mean and deviation of the lognormal frequency of the same tower, of which the first
/// order misses what the series of the exponential say.
#[test]
fn random_rows_of_a_product_of_powers_have_the_exact_mean() {
    const ROWS: u64 = 20_000;
    let bare = bare();
    let names: Vec<&str> = bare.changes().iter().map(|change| change.name()).collect();
    let (e, r, coefficient) = (0.4_f64, 0.3_f64, -0.5);
    let vary = vec![
        varied(names[0], lognormal(1.0, e)),
        varied(names[1], lognormal(1.0, r)),
    ];
    let sampling = sampling(ROWS, vary, vec![pair(names[0], names[1], coefficient)]);
    let first = bare
        .first_order(&sampling, None, Solver::default())
        .expect("first order");
    let scatter = first.modes[0].scatter.as_ref().expect("derivatives");
    // The logarithms are normal with these variances and this covariance.
    let [of_e, of_r] = [(e * e).ln_1p(), (r * r).ln_1p()];
    let both = (coefficient * e * r).ln_1p();
    let variance = 0.25 * (of_e + of_r - 2.0 * both);
    let mean_hz = scatter.mean_hz * (0.5 * variance - 0.25 * (of_e - of_r)).exp();
    let deviation_hz = mean_hz * variance.exp_m1().sqrt();
    let draw = Draw::new(&sampling).expect("a sampling");
    let rows = run(&bare, &draw, 2, &mut |_| ControlFlow::Continue(())).expect("rows");
    let sample = rows.summary(None).modes[0]
        .frequency_hz
        .clone()
        .expect("rows");
    let error_hz = deviation_hz / (ROWS as f64).sqrt();
    sample.mean.within(mean_hz, 4.0 * error_hz);
    assert!((sample.deviation / deviation_hz - 1.0).abs() < 0.03);
    // The first order is wrong by many standard errors, in mean and deviation.
    assert!((sample.mean - scatter.mean_hz).abs() > 10.0 * error_hz);
    assert!((scatter.deviation_hz / deviation_hz - 1.0).abs() > 0.03);
}

fn refused(sweep: &Sweep, sampling: &Sampling) -> FirstOrderError {
    sweep
        .first_order(sampling, None, Solver::default())
        .expect_err("refused")
}

#[test]
fn what_has_no_first_order_is_refused() {
    let names = ["material.youngs_modulus", "scale(material.youngs_modulus)"];
    let vary = vec![
        varied(names[0], normal(2.1e11, 1e9)),
        varied(names[1], normal(1.0, 0.01)),
    ];
    let twice = sampling(10, vary, Vec::new());
    let error = refused(&lowest(&names, 1), &twice);
    assert!(matches!(error, FirstOrderError::Overlap { .. }), "{error}");
    let mass = |distribution| sampling(10, vec![varied("rna.mass", distribution)], Vec::new());
    let error = refused(&lowest(&["rna.mass"], 1), &mass(normal(-1e6, 1.0)));
    error.says("the tower at the mean values: rna.mass: ");
    let mut grid = mass(Distribution::Values(vec![3e5, 4e5]));
    (grid.kind, grid.rows) = (SamplingKind::Grid, 2);
    assert_matches!(
        refused(&lowest(&["rna.mass"], 1), &grid),
        FirstOrderError::Grid
    );
    let other = refused(&lowest(&["rna.center[2]"], 1), &mass(normal(3.5e5, 1e3)));
    assert_eq!(other, FirstOrderError::OtherChanges);
    let vary = vec![varied("scale(rna.mass)", normal(0.0, 0.1))];
    let factor = sampling(10, vary, Vec::new());
    let error = refused(&lowest(&["scale(rna.mass)"], 1), &factor);
    assert_matches!(error, FirstOrderError::ZeroFactor { .. });
}

/// A machine beside the axis splits equal bending planes by as much in both directions.
#[test]
fn a_mode_without_a_derivative_has_the_reason() {
    let name = "rna.center[1]";
    let sweep = lowest(&[name], 2);
    let beside = sampling(10, vec![varied(name, normal(0.0, 0.3))], Vec::new());
    let first = sweep
        .first_order(&beside, None, Solver::default())
        .expect("first order");
    for mode in &first.modes {
        match &mode.scatter {
            Err(NoScatter::NoDerivative { change, .. }) => assert_eq!(change, name),
            Ok(scatter) => assert!(scatter.deviation_hz < 1e-9, "{scatter:?}"),
            other => panic!("{other:?}"),
        }
    }
}

/// A list of values has a mean and a deviation too; a single value has none.
#[test]
fn lists_have_moments() {
    let vary = vec![
        varied("rna.mass", Distribution::Values(vec![3.4e5, 3.6e5])),
        varied("material.density", Distribution::Values(vec![8500.0])),
    ];
    let sweep = lowest(&["rna.mass", "material.density"], 1);
    let first = sweep
        .first_order(&sampling(10, vary, Vec::new()), None, Solver::default())
        .expect("first order");
    let scatter = first.modes[0].scatter.as_ref().expect("derivatives");
    assert_eq!(scatter.shares, [1.0, 0.0]);
    let expected = scatter.hz_per_unit[0].abs() * 1e4;
    assert!((scatter.deviation_hz / expected - 1.0).abs() < 1e-12);
}
