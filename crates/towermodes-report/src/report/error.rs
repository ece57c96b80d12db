//! The errors of rendering a report.

use thiserror::Error;

/// Why a report cannot be rendered. This should not happen for any input, so each error is a bug of
/// this crate.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The data of the animation cannot be written.
    #[error("the data of the animation cannot be written: {message}")]
    Data {
        /// The message of the serializer.
        message: String,
    },
}
