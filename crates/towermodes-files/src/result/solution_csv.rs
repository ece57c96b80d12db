//! A solution as CSV: one line a mode; shapes are in the JSON.

use std::io::Write;

use towermodes::{Mode, Solution};

use super::ResultError;

const HEADER: [&str; 11] = [
    "number",
    "family",
    "order",
    "label",
    "frequency_hz",
    "period_s",
    "algebraic_error_hz",
    "discretization_error_hz",
    "extrapolated_hz",
    "modal_mass_kg",
    "modal_inertia_kg_m2",
];

/// Writes the modes of a solution as CSV with a header.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_csv(solution: &Solution, writer: impl Write) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record(HEADER)?;
    for mode in &solution.modes {
        csv.write_record(record(mode))?;
    }
    csv.flush()?;
    Ok(())
}

fn record(mode: &Mode) -> [String; 11] {
    let or_empty = |value: Option<f64>| value.map_or_else(String::new, |v| v.to_string());
    [
        mode.number.to_string(),
        mode.family.name().to_owned(),
        mode.order.to_string(),
        mode.label(),
        mode.frequency_hz.to_string(),
        mode.period_s().to_string(),
        format!("{:e}", mode.algebraic_error_hz),
        format!("{:e}", mode.discretization_error_hz),
        mode.extrapolated_hz.to_string(),
        or_empty(mode.modal_mass_kg()),
        or_empty(mode.modal_inertia_kg_m2()),
    ]
}
