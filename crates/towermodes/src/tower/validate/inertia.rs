//! The check of an inertia tensor.

use super::super::parts::inertia::Inertia;
use super::scale::{error, finite};
use crate::tower::error::{Place, Problem, TowerError};

/// A principal moment of inertia may be negative by this fraction of the largest: tensors are
/// rounded.
const ROUNDED: f64 = 1e-9;

/// Refuses a tensor that no body has: with an infinite entry or a negative principal moment.
pub(super) fn check_inertia(place: Place, inertia: &Inertia) -> Result<(), TowerError> {
    for value in inertia.tensor().into_iter().flatten() {
        finite(place, "an entry of the inertia", value, " kg m2")?;
    }
    let principal_kg_m2 = inertia.principal_kg_m2();
    let largest = principal_kg_m2[2].max(-principal_kg_m2[0]);
    if principal_kg_m2[0] >= -ROUNDED * largest {
        return Ok(());
    }
    error(place, Problem::NegativeInertia { principal_kg_m2 })
}
