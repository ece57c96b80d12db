//! Why modes could not be found.

use thiserror::Error;

/// Why the lowest eigenvalues of a pencil could not be found and proved complete.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum EigenError {
    /// More eigenvalues than unknowns.
    #[error("{wanted} modes were asked for, but there are only {available}")]
    TooMany {
        /// Asked for.
        wanted: usize,
        /// Unknowns.
        available: usize,
    },
    /// K has negative eigenvalues: the tower buckles or floats away.
    #[error("the stiffness has {negative} negative eigenvalues: the tower is unstable")]
    Unstable {
        /// How many.
        negative: usize,
    },
    /// The stiffness cancels so much that rounding hides what is left.
    #[error("springs to the ground are so stiff beside the tower that rounding hides it")]
    TooStiff,
    /// The numbers overflowed.
    #[error("the numbers of this tower are too large or too small to compute with")]
    NotFinite,
    /// The stiffest modes asked for are below the rounding of the softest.
    #[error(
        "of one kind of motion only the lowest {resolved} of {wanted} modes can be told from rounding: the stiffest part of the tower \
         is too stiff beside the softest"
    )]
    Unresolved {
        /// How many there should be.
        wanted: usize,
        /// How many have residuals that mean something.
        resolved: usize,
    },
    /// The count of eigenvalues never agreed with the list.
    #[error(
        "{found} modes were found but the inertia count says there are {counted} below {below_hz:.6e} Hz, \
         and {restarts} restarts did not find the rest"
    )]
    Incomplete {
        /// Modes in the list.
        found: usize,
        /// Modes that are there.
        counted: usize,
        /// Below this frequency, Hz.
        below_hz: f64,
        /// Restarts tried.
        restarts: usize,
    },
}
