//! The errors of rendering a report.

use thiserror::Error;

/// A report that cannot be rendered. Every input should give one, so each error is a defect of this
/// crate.
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
