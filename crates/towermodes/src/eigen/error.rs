//! Errors of the computation of eigenvalues.

use thiserror::Error;

/// Why the lowest eigenvalues of a pencil could not be computed and proved complete.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum EigenError {
    /// More eigenvalues than unknowns.
    #[error("{wanted} modes are requested, but the model has only {available}")]
    TooMany {
        /// Requested.
        wanted: usize,
        /// Unknowns.
        available: usize,
    },
    /// K has negative eigenvalues: the tower buckles or floats away.
    #[error("the tower is unstable: the stiffness matrix has {negative} negative eigenvalues")]
    Unstable {
        /// How many.
        negative: usize,
    },
    /// The terms of the stiffness cancel so much that the result is below the rounding error.
    #[error(
        "the stiffness of foundation, soil or guy wires is too large relative to the tower to be resolved in double precision"
    )]
    TooStiff,
    /// The numbers overflowed.
    #[error("a quantity of this tower is too large or too small: the computation overflows")]
    NotFinite,
    /// The stiffest modes requested are below the rounding errors of the softest.
    #[error(
        "only {resolved} of {wanted} modes of one type of motion can be resolved in double precision: the stiffest part of the tower \
         is too stiff relative to the softest"
    )]
    Unresolved {
        /// Number of requested modes.
        wanted: usize,
        /// Number of modes with small residuals.
        resolved: usize,
    },
    /// The eigenvalue count never agreed with the list.
    #[error(
        "{found} modes were found, but the eigenvalue count gives {counted} below {below_hz:.6e} Hz; \
         {restarts} restarts did not find the missing modes"
    )]
    Incomplete {
        /// Modes in the list.
        found: usize,
        /// Number of modes by the eigenvalue count.
        counted: usize,
        /// The limit of the count, Hz.
        below_hz: f64,
        /// Restarts tried.
        restarts: usize,
    },
}
