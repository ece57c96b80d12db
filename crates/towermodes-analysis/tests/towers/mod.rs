//! The manual's library of towers, and what tests do with them.

use towermodes::{Options, Solution, Tower, TowerDescription, solve};
pub use towermodes_verify::towers::*;

/// Solves a description or panics with what is wrong.
pub fn solved(description: &TowerDescription, options: &Options) -> Solution {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    solve(&tower, options).expect("a solvable tower")
}

/// Asserts |got/expected − 1| ≤ tolerance, naming the case.
#[track_caller]
pub fn assert_close(got: f64, expected: f64, tolerance: f64, case: &str) {
    let difference = got / expected - 1.0;
    assert!(
        difference.abs() <= tolerance,
        "{case}: got {got:.12}, expected {expected:.12}, relative difference {difference:.2e} > {tolerance:.0e}"
    );
}
