//! Checks common to towers and blades.

use super::super::error::SolveError;

/// Refuses a request for no modes.
pub(crate) fn check_modes(modes: usize) -> Result<(), SolveError> {
    match modes {
        0 => Err(SolveError::NoModes),
        _ => Ok(()),
    }
}

/// Refuses no segments, or more than `most`.
pub(crate) fn check_segments(segments: usize, most: usize) -> Result<(), SolveError> {
    match (1..=most).contains(&segments) {
        true => Ok(()),
        false => Err(SolveError::Segments { segments, most }),
    }
}

/// Refuses more modes than the model has degrees of freedom.
pub(crate) fn check_size(
    modes: usize,
    segments: usize,
    available: usize,
) -> Result<(), SolveError> {
    match modes > available {
        false => Ok(()),
        true => Err(SolveError::TooManyModes {
            modes,
            segments,
            available,
        }),
    }
}
