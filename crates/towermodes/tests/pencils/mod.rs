//! Eigenvalue problems as dense matrices, and whether the O(n) algorithms agree with them.
#![allow(dead_code, reason = "each test uses a part")]

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use towermodes::internal::eigen::Pencil;

/// A matrix from a product, column by column; it must be symmetric.
fn dense_of(size: usize, mut times: impl FnMut(&[f64], &mut [f64])) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(size, size);
    let mut unit = vec![0.0; size];
    for column in 0..size {
        unit[column] = 1.0;
        times(&unit, matrix.column_mut(column).as_mut_slice());
        unit[column] = 0.0;
    }
    let asymmetry = (&matrix - matrix.transpose()).norm() / matrix.norm();
    assert!(asymmetry < 1e-13, "asymmetry {asymmetry:e}");
    matrix
}

/// K and M.
pub fn dense(pencil: &mut dyn Pencil) -> (DMatrix<f64>, DMatrix<f64>) {
    let size = pencil.size();
    let mass = dense_of(size, |x, y| pencil.mass_times(x, y));
    let stiffness = dense_of(size, |x, y| pencil.stiffness_times(x, y));
    (stiffness, mass)
}

/// Positive λ of K u = λ M u for K positive definite, rising.
pub fn dense_eigenvalues(pencil: &mut dyn Pencil) -> Vec<f64> {
    let (stiffness, mass) = dense(pencil);
    let root = stiffness.cholesky().expect("positive definite").l();
    let half = root.solve_lower_triangular(&mass).expect("regular");
    let scaled = root
        .solve_lower_triangular(&half.transpose())
        .expect("regular");
    let symmetric = 0.5 * (&scaled + scaled.transpose());
    let thetas = SymmetricEigen::new(symmetric).eigenvalues;
    // What is negative beside rounding is an eigenvalue of an indefinite M, which no shift above
    // zero counts.
    let least = 1e-13 * thetas.amax();
    let positive = thetas.iter().filter(|theta| **theta > least);
    let mut lambdas: Vec<f64> = positive.map(|theta| 1.0 / theta).collect();
    lambdas.sort_by(f64::total_cmp);
    lambdas
}

/// Shifts all over the spectrum: between neighbours, close to each side of each, below all.
fn shifts(eigenvalues: &[f64]) -> Vec<(f64, usize)> {
    let mut shifts = vec![(0.0, 0), (eigenvalues[0] * 0.5, 0)];
    // Above 1e6 λ₁ the dense eigenvalues have lost the digits that a near shift needs.
    let trusted = eigenvalues
        .iter()
        .take_while(|&&value| value < 1e6 * eigenvalues[0]);
    for (index, &value) in trusted.enumerate() {
        let is_apart = |other: Option<&f64>| other.is_none_or(|o| (o / value - 1.0).abs() > 1e-5);
        let below = index.checked_sub(1).and_then(|i| eigenvalues.get(i));
        if !is_apart(below) || !is_apart(eigenvalues.get(index + 1)) {
            continue;
        }
        shifts.push((value * (1.0 - 1e-6), index));
        shifts.push((value * (1.0 + 1e-6), index + 1));
        if let Some(next) = eigenvalues.get(index + 1) {
            shifts.push(((value * next).sqrt(), index + 1));
        }
    }
    shifts
}

/// Counts of eigenvalues below shifts all over the spectrum are those of the dense matrices.
pub fn check_counts(pencil: &mut dyn Pencil, at_least: usize, case: &str) {
    let eigenvalues = dense_eigenvalues(pencil);
    let shifts = shifts(&eigenvalues);
    let count = shifts.len();
    assert!(count > at_least, "{case}: {count} shifts mean nothing");
    for (shift, count) in shifts {
        assert_eq!(pencil.count_below(shift), count, "{case} at {shift:e}");
    }
}

/// K⁻¹ K x = x, relative to the largest entry.
pub fn check_solve(pencil: &mut dyn Pencil, tolerance: f64, case: &str) {
    let size = pencil.size();
    assert_eq!(pencil.factorize(), 0, "{case}: not positive definite");
    let exact = DVector::from_fn(size, |i, _| 1.0 + (i as f64).sin());
    let mut x = vec![0.0; size];
    pencil.stiffness_times(exact.as_slice(), &mut x);
    // What was factored stays whatever is counted in between.
    pencil.count_below(77.0);
    pencil.solve(&mut x);
    for (x, exact) in x.iter().zip(&exact) {
        let error = (x - exact).abs();
        assert!(error < tolerance, "{case}: {x} instead of {exact}");
    }
}
