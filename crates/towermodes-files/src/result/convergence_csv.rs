//! The convergence of a method as CSV.

use std::io::Write;

use towermodes_analysis::study::Convergence;

use super::ResultError;

/// Writes the convergence of a method as CSV: one line per level and mode.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_convergence_csv(
    convergence: &Convergence,
    writer: impl Write,
) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record([
        "method",
        "segments",
        "degree",
        "degrees_of_freedom",
        "family",
        "order",
        "label",
        "is_pair",
        "frequency_hz",
        "limit_hz",
        "relative_error",
        "observed_order",
    ])?;
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for level in &convergence.levels {
        for (index, mode) in convergence.modes.iter().enumerate() {
            let error = level.errors[index].map(|error| format!("{error:e}"));
            csv.write_record([
                convergence.method.name().to_owned(),
                level.segments.to_string(),
                level
                    .asked
                    .degree()
                    .map_or_else(String::new, |degree| degree.to_string()),
                level.degrees_of_freedom.to_string(),
                mode.family.name().to_owned(),
                mode.order.to_string(),
                mode.label.clone(),
                mode.is_pair.to_string(),
                number(level.frequencies_hz[index]),
                mode.frequency_hz.to_string(),
                error.unwrap_or_default(),
                number(level.orders[index]),
            ])?;
        }
    }
    csv.flush()?;
    Ok(())
}
