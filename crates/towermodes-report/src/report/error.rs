//! Why there is no report.

use thiserror::Error;

/// Why there is no report. Every input should give one, so each error is a defect of this crate.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The page could not be filled in.
    #[error("the report's page cannot be filled in: {message}")]
    Page {
        /// What the template says.
        message: String,
    },
    /// The data of the moving tower could not be written.
    #[error("the data of the moving tower cannot be written: {message}")]
    Data {
        /// What is wrong with it.
        message: String,
    },
}
