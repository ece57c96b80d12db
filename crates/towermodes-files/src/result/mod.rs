//! Results as other programs read them.

mod csv;
mod json;

pub use csv::write_csv;
pub use json::{write_json, write_json_schema};

use thiserror::Error;

/// Why a result could not be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ResultError {
    /// The system refused to take it.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// JSON could not be made.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
    /// CSV could not be made.
    #[error(transparent)]
    Csv(#[from] ::csv::Error),
}
