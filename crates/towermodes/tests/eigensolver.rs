//! The eigensolver on pencils made to be hard: repeated and nearly repeated eigenvalues, start
//! vectors that miss modes, indefinite K.

use crate::towers;

use towermodes::EigenError;
use towermodes::internal::eigen::{EigenWorkspace, Pencil, lowest};
use towermodes_testing::assert_matches;
use towers::assert_close;

/// K = diag(k), M = diag(k/λ): every eigenvector is a unit vector.
struct Diagonal {
    lambdas: Vec<f64>,
    stiffness: Vec<f64>,
    /// Which entries the start vector has.
    start: fn(usize) -> f64,
}

impl Diagonal {
    fn new(lambdas: Vec<f64>, start: fn(usize) -> f64) -> Self {
        let stiffness = (0..lambdas.len()).map(|i| 1.0 + i as f64).collect();
        Self {
            lambdas,
            stiffness,
            start,
        }
    }
}

impl Pencil for Diagonal {
    fn size(&self) -> usize {
        self.lambdas.len()
    }
    fn mass_times(&mut self, x: &[f64], out: &mut [f64]) {
        for i in 0..x.len() {
            out[i] = self.stiffness[i] / self.lambdas[i] * x[i];
        }
    }
    fn stiffness_times(&mut self, x: &[f64], out: &mut [f64]) {
        for i in 0..x.len() {
            out[i] = self.stiffness[i] * x[i];
        }
    }
    fn count_below(&mut self, shift: f64) -> usize {
        self.lambdas.iter().filter(|l| **l < shift).count()
    }
    fn factorize(&mut self) -> usize {
        self.stiffness.iter().filter(|k| **k < 0.0).count()
    }
    fn solve(&mut self, x: &mut [f64]) {
        x.iter_mut().zip(&self.stiffness).for_each(|(x, k)| *x /= k);
    }
    fn start(&mut self, out: &mut [f64]) {
        (0..out.len()).for_each(|i| out[i] = (self.start)(i));
    }
}

/// λ = 1, 16, 81, … like a beam's.
fn beam_like(size: usize) -> Vec<f64> {
    (1..=size).map(|k| (k as f64).powi(4)).collect()
}

fn check(mut pencil: Diagonal, wanted: usize, restarts: std::ops::RangeInclusive<usize>) {
    let mut expected = pencil.lambdas.clone();
    expected.sort_by(f64::total_cmp);
    let mut workspace = EigenWorkspace::default();
    let statistics = lowest(&mut pencil, wanted, &mut workspace).expect("all found");
    assert!(restarts.contains(&statistics.restarts), "{statistics:?}");
    let eigenvalues = workspace.eigenvalues();
    assert!(eigenvalues.len() >= wanted);
    for (found, expected) in eigenvalues.iter().zip(&expected) {
        assert_close(found.lambda, *expected, 1e-12, "eigenvalue");
        let error = (found.lambda - expected).abs();
        assert!(
            error <= found.error,
            "bound {:e} is below the error {error:e}",
            found.error
        );
    }
    for i in 0..eigenvalues.len() {
        for j in 0..=i {
            let inner: f64 = (0..pencil.size())
                .map(|k| workspace.vector(i)[k] * pencil.stiffness[k] * workspace.vector(j)[k])
                .sum();
            let holds = (inner - f64::from(u8::from(i == j))).abs() < 1e-10;
            assert!(holds, "vectors {i}, {j}: {inner}");
        }
    }
}

#[test]
fn a_beam_like_spectrum_needs_no_restart() {
    for wanted in [1, 4, 10, 40] {
        check(Diagonal::new(beam_like(200), |_| 1.0), wanted, 0..=0);
    }
}

#[test]
fn a_start_vector_without_the_lowest_modes_finds_them_all_the_same() {
    check(
        Diagonal::new(beam_like(100), |i| f64::from(u8::from(i > 2))),
        5,
        1..=4,
    );
    check(
        Diagonal::new(beam_like(100), |i| f64::from(u8::from(i % 2 == 1))),
        5,
        1..=4,
    );
}

#[test]
fn a_zero_start_vector_does_no_harm() {
    check(Diagonal::new(beam_like(50), |_| 0.0), 5, 0..=1);
}

#[test]
fn every_copy_of_a_repeated_eigenvalue_is_found() {
    // A Krylov process from one vector sees one copy only; the count knows of the others.
    let pairs: Vec<f64> = beam_like(40).into_iter().flat_map(|l| [l, l]).collect();
    check(Diagonal::new(pairs.clone(), |_| 1.0), 6, 1..=8);
    let triples: Vec<f64> = beam_like(30).into_iter().flat_map(|l| [l, l, l]).collect();
    check(Diagonal::new(triples, |_| 1.0), 3, 1..=8);
    // An odd number cuts a pair, between whose members no count can be taken: both come.
    let mut workspace = EigenWorkspace::default();
    lowest(&mut Diagonal::new(pairs, |_| 1.0), 3, &mut workspace).expect("all found");
    assert!(workspace.eigenvalues().len() >= 4);
}

#[test]
fn near_pairs_are_told_apart_or_returned_together() {
    for split in [1e-3, 1e-6, 1e-9, 1e-12] {
        let near: Vec<f64> = beam_like(40)
            .into_iter()
            .flat_map(|l| [l, l * (1.0 + split)])
            .collect();
        check(Diagonal::new(near.clone(), |_| 1.0), 6, 0..=8);
        check(Diagonal::new(near, |_| 1.0), 5, 0..=8);
    }
}

/// Rounding of the first mode is 1e-16 of θ₁, and θ₂ is 1e-10 of θ₁: residuals of about 1e-6 do not
/// tell modes apart that differ by 1e-7, so the list must contain both.
#[test]
fn a_list_does_not_end_between_modes_that_its_residuals_do_not_tell_apart() {
    let lambdas = vec![1.0, 1e10, 1e10 * (1.0 + 1e-7), 1e11, 2e11, 3e11];
    let mut workspace = EigenWorkspace::default();
    lowest(&mut Diagonal::new(lambdas, |_| 1.0), 2, &mut workspace).expect("all found");
    assert_eq!(workspace.eigenvalues().len(), 3);
}

#[test]
fn all_eigenvalues_of_small_pencils() {
    for size in 1..12 {
        check(
            Diagonal::new(beam_like(size), |i| 1.0 / (1.0 + i as f64)),
            size,
            0..=0,
        );
    }
    check(Diagonal::new(vec![3.0; 5], |_| 1.0), 5, 0..=0);
}

#[test]
fn impossible_questions_are_refused() {
    let mut workspace = EigenWorkspace::default();
    let mut ask = |pencil: &mut Diagonal, wanted| lowest(pencil, wanted, &mut workspace);
    let mut pencil = Diagonal::new(beam_like(5), |_| 1.0);
    let too_many = EigenError::TooMany {
        wanted: 6,
        available: 5,
    };
    assert_eq!(ask(&mut pencil, 6), Err(too_many));
    assert!(ask(&mut pencil, 0).is_ok());
    pencil.stiffness[3] = -1.0;
    assert_matches!(
        ask(&mut pencil, 2),
        Err(EigenError::Unstable { negative: 1 })
    );
    let mut broken = Diagonal::new(vec![1.0, f64::NAN, 3.0], |_| 1.0);
    assert!(ask(&mut broken, 1).is_err());
}

/// A pencil whose count is always one more than there is: the list can never be proved.
struct Liar(Diagonal);

impl Pencil for Liar {
    fn size(&self) -> usize {
        self.0.size()
    }
    fn mass_times(&mut self, x: &[f64], out: &mut [f64]) {
        self.0.mass_times(x, out);
    }
    fn stiffness_times(&mut self, x: &[f64], out: &mut [f64]) {
        self.0.stiffness_times(x, out);
    }
    fn count_below(&mut self, shift: f64) -> usize {
        self.0.count_below(shift) + 1
    }
    fn factorize(&mut self) -> usize {
        0
    }
    fn solve(&mut self, x: &mut [f64]) {
        self.0.solve(x);
    }
    fn start(&mut self, out: &mut [f64]) {
        self.0.start(out);
    }
}

#[test]
fn a_count_that_never_agrees_is_an_error_not_a_list() {
    let mut workspace = EigenWorkspace::default();
    let mut liar = Liar(Diagonal::new(beam_like(60), |_| 1.0));
    let result = lowest(&mut liar, 3, &mut workspace);
    assert_matches!(result, Err(EigenError::Incomplete { .. }));
    assert!(workspace.eigenvalues().is_empty());
}
