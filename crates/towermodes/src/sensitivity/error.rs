//! Errors of the derivatives.

use thiserror::Error;

use crate::solve::{SolveError, TooManyModes};
use crate::tower::TowerError;

/// Why there are no derivatives of the frequencies of a tower.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SensitivityError {
    /// The description of the tower is invalid.
    #[error(transparent)]
    Tower(#[from] TowerError),
    /// The modes of the tower cannot be computed.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// A change sets several input values that are not equal, so it has no single value at which to
    /// differentiate.
    #[error(
        "the input values of `{change}` are {first} and {second}, so a derivative at one value does not exist; use scale(…) or add(…)"
    )]
    Unequal {
        /// The name of the change.
        change: String,
        /// One of the values.
        first: f64,
        /// Another one.
        second: f64,
    },
}

impl TooManyModes for SensitivityError {
    fn available_modes(&self) -> Option<usize> {
        match self {
            Self::Solve(error) => error.available_modes(),
            Self::Tower(_) | Self::Unequal { .. } => None,
        }
    }
}
