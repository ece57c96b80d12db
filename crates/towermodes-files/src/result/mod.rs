//! Results as other programs read them.

mod agreement;
mod blade;
mod campbell;
mod comparison;
mod convergence;
mod judgement;
mod schema;
mod solution_csv;
mod solution_json;
mod verification;

pub use agreement::{write_agreement_json, write_examination_json};
pub use blade::{write_blade_csv, write_blade_json};
pub use campbell::{write_campbell_csv, write_campbell_json};
pub use comparison::{write_comparison_csv, write_comparison_json};
pub use convergence::{write_convergence_csv, write_convergence_json};
pub use judgement::write_judgement_json;
pub use schema::{ResultKind, write_json_schema};
pub use solution_csv::write_csv;
pub use solution_json::write_json;
pub use verification::{write_verification_csv, write_verification_json};

use std::io::Write;

use serde::Serialize;
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

/// Indented JSON with a newline at the end.
fn write_pretty(value: &impl Serialize, mut writer: impl Write) -> Result<(), ResultError> {
    serde_json::to_writer_pretty(&mut writer, value)?;
    writeln!(writer)?;
    Ok(())
}
