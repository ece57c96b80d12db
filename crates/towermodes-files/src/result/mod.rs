//! Results as JSON with their schemas, and as CSV.
//!
//! The types of the library serialize themselves. This folder contains only the documents that
//! combine a result with its tower and the notes of the reader.

mod blade;
mod calibration;
mod campbell;
mod columns;
mod coupled_campbell;
mod coupled_campbell_csv;
mod damping;
mod design;
mod first_order;
#[cfg(feature = "schema")]
mod generated;
mod mooring;
mod parameters;
mod schema;
mod sensitivities;
mod several;
mod solution;
mod solution_csv;
mod study_csv;
mod substructure;

pub use blade::{write_blade_csv, write_blade_json};
pub use calibration::{
    CalibrationDocument, FittedDirection, FittedFrequency, FittedNumber, FittedShare,
    write_calibration_json,
};
pub use campbell::{write_campbell_csv, write_campbell_json};
pub use columns::{Cell, Column};
pub use coupled_campbell::write_coupled_campbell_json;
pub use coupled_campbell_csv::write_coupled_campbell_csv;
pub use damping::{write_damping_csv, write_damping_json};
pub use design::{
    DesignDocument, DesignedFrequency, DesignedLimit, DesignedOther, DesignedVariable,
    write_design_json,
};
pub use first_order::{
    CorrelatedInputs, FirstOrderDocument, InputEffect, MarginProbability, ScatteredInput,
    ScatteredMode, write_first_order_json,
};
#[cfg(feature = "schema")]
pub use generated::generated_schema_of;
pub use mooring::{LineAtRest, SolvedMooring, write_mooring_csv, write_mooring_json};
pub use parameters::{write_parameters_csv, write_parameters_json};
pub use schema::{RESULTS, ResultKind};
pub use sensitivities::{write_sensitivities_csv, write_sensitivities_json};
pub use several::{SolvedFile, write_several_csv, write_several_json};
pub use solution::{write_json, write_json_with_sensitivities};
pub use solution_csv::{MODE_COLUMNS, write_csv};
pub use study_csv::{write_comparison_csv, write_convergence_csv};
pub use substructure::{
    LargestMotion, SolvedSubstructure, write_substructure_csv, write_substructure_json,
};

use std::io::Write;

use serde::Serialize;
use thiserror::Error;

/// Why a result could not be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ResultError {
    /// The writer returned an error.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// The value cannot be represented in JSON.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
    /// The records cannot be represented in CSV.
    #[error(transparent)]
    Csv(#[from] ::csv::Error),
}

/// Writes a result as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_result_json(
    value: &impl Serialize,
    mut writer: impl Write,
) -> Result<(), ResultError> {
    serde_json::to_writer_pretty(&mut writer, value)?;
    writeln!(writer)?;
    Ok(())
}

/// Writes a header and records as CSV.
///
/// # Errors
/// [`ResultError`] if writing fails, or if the length of a record differs from that of the header.
pub fn write_records_csv<const N: usize>(
    header: [&str; N],
    records: impl IntoIterator<Item = [String; N]>,
    writer: impl Write,
) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record(header)?;
    for record in records {
        csv.write_record(record)?;
    }
    csv.flush()?;
    Ok(())
}
