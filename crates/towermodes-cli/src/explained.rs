//! Possible explanations of an error: the notes on the input and the warnings about the tower.

use towermodes::Tower;
use towermodes_files::TowerInput;

use crate::failure::Failure;
use crate::messages::{note, warn};

/// Prints the notes and warnings of a tower before the error of its computation. A soil stiffness
/// that is a million times too small gives a warning, but the error only states that the tower
/// buckles.
pub(crate) fn explained<T>(
    result: Result<T, impl Into<Failure>>,
    (tower, input): (&Tower, &TowerInput),
) -> Result<T, Failure> {
    if result.is_err() {
        note(&input.notes);
        warn(tower.warnings(), input);
    }
    result.map_err(Into::into)
}
