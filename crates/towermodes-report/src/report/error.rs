//! The errors of rendering a report.

use thiserror::Error;

/// A report that cannot be rendered. Every input should give one, so each error is a defect of this
/// crate.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The page could not be filled in.
    #[error("the report's page cannot be filled in: {message}")]
    Page {
        /// The message of the template engine.
        message: String,
    },
    /// The data of the animation could not be written.
    #[error("the data of the moving tower cannot be written: {message}")]
    Data {
        /// The message of the serializer.
        message: String,
    },
}
