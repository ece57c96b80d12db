//! Why eigenvalues could not be computed.

use thiserror::Error;

/// Why the lowest eigenvalues of a pencil could not be computed and proved complete.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum EigenError {
    /// More eigenvalues than unknowns.
    #[error("{wanted} modes were requested, but there are only {available}")]
    TooMany {
        /// Requested.
        wanted: usize,
        /// Unknowns.
        available: usize,
    },
    /// K has negative eigenvalues: the structure buckles, or nothing holds it.
    #[error("the stiffness has {negative} negative eigenvalues: the tower is unstable")]
    Unstable {
        /// How many.
        negative: usize,
    },
    /// The terms of the stiffness cancel so much that only rounding errors remain.
    #[error(
        "the foundation, soil or guy wires are too stiff relative to the tower: not resolvable in double precision"
    )]
    TooStiff,
    /// The numbers overflowed.
    #[error("the numbers of this tower are too large or too small to compute with")]
    NotFinite,
    /// The stiffest modes requested are below the rounding errors of the softest.
    #[error(
        "only the lowest {resolved} of {wanted} modes of one group of motions are resolvable in double precision: the stiffest part \
         of the tower is too stiff relative to the softest"
    )]
    Unresolved {
        /// How many were sought.
        wanted: usize,
        /// How many have small residuals.
        resolved: usize,
    },
    /// The eigenvalue count never agreed with the list.
    #[error(
        "{found} modes were found, but the inertia count gives {counted} below {below_hz:.6e} Hz, \
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
