//! Reasons why a rotor has no equations with constant coefficients.

use thiserror::Error;

use crate::tower::MOST_BLADES;

/// A number of blades that cannot be solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum RotorError {
    /// A rotor with fewer than three blades.
    #[error(
        "a rotor of {blades} blades is not supported: seen from the tower, its inertia and stiffness vary periodically, which would need Floquet theory; \
         the number of blades must be 3 or more"
    )]
    TooFewBlades {
        /// The number given.
        blades: usize,
    },
    /// A rotor with more blades than any real rotor.
    #[error(
        "a rotor of {blades} blades is not supported; the number of blades must be at most {MOST_BLADES}"
    )]
    TooManyBlades {
        /// The number given.
        blades: usize,
    },
}
