//! Why blades make no rotor whose equations have constant coefficients.

use thiserror::Error;

use crate::tower::MOST_BLADES;

/// A number of blades that cannot be solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum RotorError {
    /// Fewer than three.
    #[error(
        "a rotor of {blades} blades is not supported: seen from the tower, its inertia and stiffness vary periodically, which would need Floquet theory; \
         the number of blades must be 3 or more"
    )]
    TooFewBlades {
        /// The number given.
        blades: usize,
    },
    /// More than any rotor has.
    #[error(
        "a rotor of {blades} blades is not supported; the number of blades must be at most {MOST_BLADES}"
    )]
    TooManyBlades {
        /// The number given.
        blades: usize,
    },
}
