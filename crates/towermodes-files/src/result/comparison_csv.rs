//! A comparison of methods as CSV.

use std::io::Write;

use towermodes_analysis::study::Comparison;

use super::ResultError;

/// Writes a comparison as CSV: one line per method and mode.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_comparison_csv(
    comparison: &Comparison,
    writer: impl Write,
) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record([
        "method",
        "segments",
        "degree",
        "degrees_of_freedom",
        "seconds_per_solve",
        "family",
        "order",
        "label",
        "is_pair",
        "frequency_hz",
        "relative_difference",
    ])?;
    let or_empty = |value: Option<String>| value.unwrap_or_default();
    for column in &comparison.columns {
        for (index, mode) in comparison.modes.iter().enumerate() {
            let difference = column.relative_differences[index];
            csv.write_record([
                column.method.name().to_owned(),
                column.segments.to_string(),
                or_empty(column.degree.map(|degree| degree.to_string())),
                column.degrees_of_freedom.to_string(),
                or_empty(column.seconds_per_solve.map(|time| format!("{time:e}"))),
                mode.family.name().to_owned(),
                mode.order.to_string(),
                mode.label.clone(),
                mode.is_pair.to_string(),
                or_empty(column.frequencies_hz[index].map(|f| f.to_string())),
                or_empty(difference.map(|difference| format!("{difference:e}"))),
            ])?;
        }
    }
    csv.flush()?;
    Ok(())
}
