//! Why a tower cannot be written in windIO.

use thiserror::Error;

/// Why a tower cannot be written in windIO.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum WindIoWriteError {
    /// Two heights have the same position on the axis within rounding.
    #[error(
        "the heights {below_m} m and {above_m} m are too close together for positions from 0 to 1 along {length_m} m"
    )]
    TooClose {
        /// The lower height, m.
        below_m: f64,
        /// The higher height, m.
        above_m: f64,
        /// Length of the tower, m.
        length_m: f64,
    },
    /// The support of the tower would be lost, and the written tower would look clamped.
    #[error(
        "the tower stands on a substructure of members, which this program does not write in windIO: to write the tower alone, read the file with --clamped, or delete [substructure] in the tower file"
    )]
    OnFrame,
    /// The tower does not belong to the description.
    #[error("the description has neither stations nor properties")]
    NoSections,
}
