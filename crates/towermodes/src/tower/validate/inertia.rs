//! The checks of inertia tensors and of matrices that must not have a negative eigenvalue.

use super::super::parts::inertia::Inertia;
use super::scale::{error, finite};
use crate::space::SpatialMatrix;
use crate::symmetric::eigenpairs;
use crate::tower::error::{Place, Problem, TowerError};

/// A principal moment of inertia may be negative by this fraction of the largest one, because
/// tensors are rounded.
const ROUNDED: f64 = 1e-9;
/// A scaled eigenvalue is treated as negative below minus this value.
const NEGATIVE: f64 = 1e-9;

/// Refuses an impossible tensor: with an infinite entry or a negative principal moment.
pub(super) fn check_inertia(place: Place, inertia: &Inertia) -> Result<(), TowerError> {
    for value in inertia.tensor().into_iter().flatten() {
        finite(place, "an entry of the inertia", value, " kg m2")?;
    }
    match negative_inertia(inertia) {
        Some(problem) => error(place, problem),
        None => Ok(()),
    }
}

/// A tensor with a negative principal moment.
pub(in crate::tower) fn negative_inertia(inertia: &Inertia) -> Option<Problem> {
    let principal_kg_m2 = inertia.principal_kg_m2();
    let largest = principal_kg_m2[2].max(-principal_kg_m2[0]);
    let is_negative = principal_kg_m2[0] < -ROUNDED * largest;
    is_negative.then_some(Problem::NegativeInertia { principal_kg_m2 })
}

/// Returns an error for a matrix with a negative eigenvalue, after scaling its diagonal to one.
pub(in crate::tower) fn indefinite(what: &'static str, matrix: &SpatialMatrix) -> Option<Problem> {
    let scale = |i: usize| match matrix[i][i] {
        diagonal if diagonal > 0.0 => diagonal.sqrt(),
        _ => 1.0,
    };
    let scaled: SpatialMatrix =
        std::array::from_fn(|i| std::array::from_fn(|j| matrix[i][j] / scale(i) / scale(j)));
    if eigenpairs(scaled).0[0] >= -NEGATIVE {
        return None;
    }
    let eigenvalue = eigenpairs(*matrix).0[0];
    Some(Problem::Indefinite { what, eigenvalue })
}
