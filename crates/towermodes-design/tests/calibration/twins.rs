//! Twin experiments: frequencies of a known tower with random errors must give the tower back,
//! within the standard deviations that the fit states.

use towermodes::{Ground, GroundLayer, LayerSoil, Rna, Sand, SoilModel, Solver, TowerDescription};
use towermodes_testing::{Close, tube};

use super::{Problem, fitted, frequencies, measured, options, tower, unknown, with_prior};
use towermodes_design::calibration::{AtBound, calibrate};

/// Random numbers of PCG's generator (O'Neill 2014), the same in every run.
struct Random(u64);

impl Random {
    fn uniform(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let mixed = self.0 ^ (self.0 >> 33);
        let mixed = mixed.wrapping_mul(0xff51_afd7_ed55_8ccd);
        ((mixed ^ (mixed >> 33)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// By Box & Muller (1958).
    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.uniform()).cos()
    }
}

const MODES: [&str; 5] = [
    "fore-aft 1",
    "side-side 1",
    "fore-aft 2",
    "side-side 2",
    "torsion 1",
];
const CASES: usize = 400;

/// A tower whose rocking stiffness, wall thickness and RNA mass differ from those of `base`.
fn twin(base: &TowerDescription, random: &mut Random) -> (TowerDescription, [f64; 3]) {
    // The wall and the mass are drawn from their priors; of the stiffness nothing is known.
    let rocking = 1e11 * (0.3 * random.normal()).exp();
    let wall = 1.0 + 0.02 * random.normal();
    let mass = 350e3 + 5e3 * random.normal();
    let mut twin = base.clone();
    for (name, value) in [
        ("foundation.rocking", rocking),
        ("scale(stations[*].wall)", wall),
        ("rna.mass", mass),
    ] {
        let change = towermodes::Change::parse(name, base).expect("a change");
        change.apply(&mut twin, value);
    }
    (twin, [rocking, wall, mass])
}

#[test]
fn the_truth_is_within_the_stated_deviations_as_often_as_it_should() {
    let base = tower();
    let mut random = Random(20_261_122);
    let (mut within_one, mut within_two, mut chi_square) = ([0; 3], [0; 3], 0.0);
    let mut solver = Solver::new(options());
    for _ in 0..CASES {
        let (twin, truth) = twin(&base, &mut random);
        let exact = frequencies(&twin, &MODES);
        let of = |(mode, hz): (&&str, &f64)| {
            let deviation = 0.002 * hz;
            measured(mode, hz + deviation * random.normal(), deviation)
        };
        let problem = Problem {
            measured: MODES.iter().zip(&exact).map(of).collect(),
            unknowns: vec![
                unknown(&base, "foundation.rocking"),
                with_prior(&base, "scale(stations[*].wall)", 1.0, 0.02),
                with_prior(&base, "rna.mass", 350e3, 5e3),
            ],
            base: base.clone(),
        };
        let result = calibrate(&problem, &mut solver).expect("a fit");
        chi_square += result.chi_square;
        assert_eq!(result.degrees_of_freedom, 4);
        for (j, (unknown, truth)) in result.unknowns.iter().zip(truth).enumerate() {
            let [low, high] = unknown.interval.expect("free");
            let spread = 0.5 * (high / low).ln();
            let error = (unknown.value / truth).ln().abs() / spread;
            within_one[j] += usize::from(error < 1.0);
            within_two[j] += usize::from(error < 2.0);
        }
    }
    // 68.3 and 95.4 %; with 400 cases one standard error is 2.3 and 1.0 %.
    for j in 0..3 {
        let share = |count: usize| count as f64 / CASES as f64;
        share(within_one[j]).within(0.683, 0.06);
        share(within_two[j]).within(0.954, 0.03);
    }
    // The mean of chi-square is the number of degrees of freedom, here with a standard error of
    // √(8/400).
    (chi_square / CASES as f64).within(4.0, 0.5);
}

#[test]
fn exact_frequencies_give_the_truth_from_far_away() {
    let base = tower();
    for (rocking, lateral) in [(1e10, 1e9), (4e11, 5e8), (3e10, 2e10)] {
        let mut twin = base.clone();
        twin.foundation = super::springs(lateral, rocking);
        let exact = frequencies(&twin, &MODES);
        let of = |(mode, hz): (&&str, &f64)| measured(mode, *hz, 1e-3 * hz);
        let problem = Problem {
            measured: MODES.iter().zip(&exact).map(of).collect(),
            unknowns: vec![
                unknown(&base, "foundation.rocking"),
                unknown(&base, "foundation.lateral"),
            ],
            base: base.clone(),
        };
        let result = fitted(&problem).expect("a fit");
        let values: Vec<f64> = result.unknowns.iter().map(|one| one.value).collect();
        assert!((values[0] / rocking - 1.0).abs() < 1e-5, "{values:?}");
        assert!((values[1] / lateral - 1.0).abs() < 1e-4, "{values:?}");
        assert!(result.chi_square < 1e-8, "{}", result.chi_square);
    }
}

/// The residuals of the fitted tower are those of a separate solve of its description.
#[test]
fn the_fitted_tower_has_the_fitted_frequencies() {
    let base = tower();
    let problem = Problem {
        measured: vec![
            measured("fore-aft 1", 0.25, 0.001),
            measured("fore-aft 2", 1.6, 0.01),
        ],
        unknowns: vec![
            unknown(&base, "foundation.rocking"),
            with_prior(&base, "add(rna.center[2])", 0.0, 0.5),
        ],
        base,
    };
    let result = fitted(&problem).expect("a fit");
    let again = frequencies(&result.description, &["fore-aft 1", "fore-aft 2"]);
    for (one, hz) in result.measured.iter().zip(again) {
        // The numbers of the description have eight digits.
        assert!((one.fitted_hz / hz - 1.0).abs() < 1e-7);
        let residual = (one.fitted_hz - one.measured_hz) / one.deviation_hz;
        assert!((one.residual - residual).abs() < 1e-9);
    }
    assert!(!result.unknowns[1].is_logarithm);
    // A minimum: the sum of squares is larger beside it.
    for (name, factor) in [
        ("scale(foundation.rocking)", 1.01),
        ("scale(foundation.rocking)", 0.99),
    ] {
        let mut beside = result.description.clone();
        towermodes::Change::parse(name, &beside)
            .expect("a change")
            .apply(&mut beside, factor);
        let hz = frequencies(&beside, &["fore-aft 1", "fore-aft 2"]);
        let terms = result.measured.iter().zip(hz);
        let of_data: f64 = terms
            .map(|(one, hz)| ((hz - one.measured_hz) / one.deviation_hz).powi(2))
            .sum();
        let of_prior = result.unknowns[1].prior_residual.expect("a prior").powi(2);
        assert!(of_data + of_prior > result.chi_square);
    }
}

/// A number that is 0 on the tower has no size of its own: its unit must not matter.
#[test]
fn a_number_that_is_zero_is_found() {
    let modes = ["fore-aft 1", "fore-aft 2"];
    let mut base = tower();
    base.rna = Rna::point(350e3);
    let truth = frequencies(&base, &modes);
    base.rna.mass_kg = 0.0;
    let of = |(mode, hz): (&&str, &f64)| measured(mode, *hz, 1e-3 * hz);
    let problem = Problem {
        measured: modes.iter().zip(&truth).map(of).collect(),
        unknowns: vec![unknown(&base, "rna.mass")],
        base,
    };
    let result = fitted(&problem).expect("a fit");
    let mass = &result.unknowns[0];
    assert_eq!((mass.before, mass.is_logarithm), (Some(0.0), false));
    assert!((mass.value / 350e3 - 1.0).abs() < 1e-5, "{}", mass.value);
    assert!(result.chi_square < 1e-6, "{}", result.chi_square);
    assert!(result.iterations < 30, "{}", result.iterations);
}

/// A mass cannot be negative, even if the measurements ask for it.
#[test]
fn a_mass_that_would_be_negative_stays_at_zero() {
    let mut base = tower();
    base.rna = Rna::point(0.0);
    let hz = 1.1 * frequencies(&base, &["fore-aft 1"])[0];
    let problem = Problem {
        measured: vec![measured("fore-aft 1", hz, 0.01 * hz)],
        unknowns: vec![unknown(&base, "rna.mass")],
        base,
    };
    let result = fitted(&problem).expect("a fit");
    assert_eq!(result.unknowns[0].value, 0.0);
    assert_eq!(result.unknowns[0].at_bound, Some(AtBound::Lower));
    assert!((result.measured[0].residual + 100.0 / 11.0).abs() < 1e-6);
}

/// The same fit in other coordinates: the factor of a stiffness, the stiffness, and what is added
/// to it in N m, whose derivatives differ by eleven powers of ten.
#[test]
fn units_do_not_matter() {
    let base = tower();
    let mut twin = base.clone();
    twin.foundation = super::springs(2e9, 6e10);
    twin.rna.mass_kg = 340e3;
    let exact = frequencies(&twin, &MODES);
    let fit = |name: &str| {
        let of = |(mode, hz): (&&str, &f64)| measured(mode, *hz, 1e-3 * hz);
        let problem = Problem {
            measured: MODES.iter().zip(&exact).map(of).collect(),
            unknowns: vec![unknown(&base, name), unknown(&base, "add(rna.mass)")],
            base: base.clone(),
        };
        let result = fitted(&problem).expect(name);
        let [rocking, mass] = &result.unknowns[..] else {
            panic!("{result:?}")
        };
        assert!((mass.value + 10e3).abs() < 1.0, "{name}: {}", mass.value);
        let deviations = [rocking, mass].map(|one| one.deviation.expect("free"));
        let weakest = result.directions.last().expect("two").singular_value;
        assert!(weakest > 1.0, "{name}: {weakest}");
        (rocking.value, deviations)
    };
    let (value, [of_value, of_mass]) = fit("foundation.rocking");
    assert!((value / 6e10 - 1.0).abs() < 1e-6, "{value}");
    let (factor, [of_factor, mass_again]) = fit("scale(foundation.rocking)");
    assert!((factor / 0.6 - 1.0).abs() < 1e-6, "{factor}");
    assert!((of_factor * 1e11 / of_value - 1.0).abs() < 1e-5);
    assert!((mass_again / of_mass - 1.0).abs() < 1e-5);
    let (added, [of_added, mass_again]) = fit("add(foundation.rocking)");
    assert!((added / -4e10 - 1.0).abs() < 1e-6, "{added}");
    let holds = (of_added / of_value - 1.0).abs() < 1e-5;
    assert!(holds, "{of_added:e} {of_value:e} {added:e} {value:e}");
    assert!((mass_again / of_mass - 1.0).abs() < 1e-5);
}

/// The height of a boundary between two layers is 0 in the datum of the stations. It may also be
/// lower.
#[test]
fn a_height_of_zero_may_become_negative() {
    let sand = |ends_m, subgrade_modulus_n_per_m3| {
        let sand = Sand {
            subgrade_modulus_n_per_m3: Some(subgrade_modulus_n_per_m3),
            ..Sand::default()
        };
        GroundLayer::new(ends_m, LayerSoil::Sand(sand), SoilModel::Api)
    };
    let with_boundary = |boundary_m| {
        let layers = vec![
            sand([10.0, boundary_m], 5e6),
            sand([boundary_m, -20.0], 4e7),
        ];
        TowerDescription {
            foundation: super::springs(0.0, 0.0),
            ground: Some(Ground::new(10.0, layers)),
            rna: tower().rna,
            ..tube(&[(-10.0, 6.0, 0.06), (10.0, 6.0, 0.06), (90.0, 4.0, 0.02)])
        }
    };
    let names = ["fore-aft 1", "side-side 1"];
    let truth = frequencies(&with_boundary(-1.0), &names);
    let base = with_boundary(0.0);
    let boundary = "set(ground.layer[0].bottom,ground.layer[1].top)";
    let result = fitted(&Problem {
        unknowns: vec![unknown(&base, boundary)],
        measured: vec![
            measured(names[0], truth[0], 1e-4),
            measured(names[1], truth[1], 1e-4),
        ],
        base,
    });
    let height_m = result.expect("a fit").unknowns[0].value;
    assert!((height_m + 1.0).abs() < 1e-3, "{height_m}");
}
