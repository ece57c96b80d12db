//! Parts in CSV, each with a hidden file that has its key and its digest.

use std::io::Write;

use towermodes::ModeName;

use super::part::{Column, Part};
use crate::digest::Digest;
use crate::results::Results;

/// The text of a part.
pub(super) fn write(part: &Part, columns: &[(String, Column)]) -> Result<Vec<u8>, ::csv::Error> {
    let mut writer = ::csv::Writer::from_writer(Vec::new());
    writer.write_record(columns.iter().map(|(name, _)| name))?;
    let results = &part.results;
    let modes = results.modes.len();
    let changes = part.inputs.len().checked_div(results.rows()).unwrap_or(0);
    let mut cell = Vec::new();
    for (row, sentence) in results.sentences().enumerate() {
        for (_, column) in columns {
            cell.clear();
            match *column {
                Column::Row => write!(cell, "{}", results.first_row + row as u64)?,
                Column::Input(input) => number(&mut cell, part.inputs[row * changes + input])?,
                Column::MassKg => number(&mut cell, results.mass_kg[row])?,
                Column::Certified => write!(cell, "{}", results.certified[row])?,
                Column::Hz(mode) => number(&mut cell, results.frequency_hz[row * modes + mode])?,
                Column::ErrorHz(mode) => number(&mut cell, results.error_hz[row * modes + mode])?,
                Column::Sentence => cell.extend(sentence.unwrap_or_default().bytes()),
            }
            writer.write_field(&cell)?;
        }
        writer.write_record(None::<&[u8]>)?;
    }
    writer
        .into_inner()
        .map_err(|error| error.into_error().into())
}

/// A number with all its digits; nothing for NaN.
fn number(cell: &mut Vec<u8>, number: f64) -> std::io::Result<()> {
    match number.is_nan() {
        true => Ok(()),
        // With an exponent where the number is large or small.
        false => write!(cell, "{number:?}"),
    }
}

/// The name of the hidden file of a part.
pub(super) fn key_name(part: &str) -> String {
    format!(".{part}.key")
}

/// The text of the hidden file of a part.
pub(super) fn key_text(key: &str, part: u64, content: &[u8]) -> String {
    format!("{key} {part} {}\n", Digest::of(content))
}

/// Reads the results of a part.
///
/// # Errors
/// What is wrong with the text.
pub(super) fn read(
    content: &[u8],
    columns: &[(String, Column)],
    first_row: u64,
    modes: &[ModeName],
) -> Result<Results, String> {
    let mut reader = ::csv::Reader::from_reader(content);
    let records = reader.byte_records();
    let records: Result<Vec<::csv::ByteRecord>, _> = records.collect();
    let records = records.map_err(|error| error.to_string())?;
    let unsolved = Results::unsolved(first_row, records.len(), modes);
    let mut results = unsolved.map_err(|error| error.to_string())?;
    for (row, record) in records.iter().enumerate() {
        if record.len() != columns.len() {
            return Err(format!("line {} has {} cells", row + 2, record.len()));
        }
        for ((_, column), cell) in columns.iter().zip(record) {
            let text = std::str::from_utf8(cell).map_err(|error| error.to_string())?;
            let number = || match text {
                "" => Ok(f64::NAN),
                digits => digits
                    .parse::<f64>()
                    .map_err(|_| format!("line {} has `{digits}` in place of a number", row + 2)),
            };
            match *column {
                Column::Row | Column::Input(_) => {}
                Column::MassKg => results.mass_kg[row] = number()?,
                Column::Certified => results.certified[row] = text == "true",
                Column::Hz(mode) => results.frequency_hz[row * modes.len() + mode] = number()?,
                Column::ErrorHz(mode) => results.error_hz[row * modes.len() + mode] = number()?,
                Column::Sentence if text.is_empty() => {}
                Column::Sentence => {
                    let failure = (first_row + row as u64, text.to_owned());
                    results.failures.push(failure);
                }
            }
        }
    }
    Ok(results)
}
