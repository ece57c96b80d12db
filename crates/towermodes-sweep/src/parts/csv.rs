//! Parts in CSV, each with a file that has its key and its digest.

use std::io::{Read, Write};
use std::ops::Range;

use towermodes::ModeName;

use super::part::{Column, Part};
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
                Column::Share(mode) => number(&mut cell, results.share[row * modes + mode])?,
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

/// The text of the key file of a part with a digest.
pub(super) fn key_text(key: &str, part: u64, digest: &str) -> String {
    format!("{key} {part} {digest}\n")
}

/// Reads the results of a part with given rows.
///
/// # Errors
/// What is wrong with the text.
pub(super) fn read(
    content: impl Read,
    columns: &[(String, Column)],
    rows: Range<u64>,
    modes: &[ModeName],
) -> Result<Results, String> {
    let expected = (rows.end - rows.start) as usize;
    let unsolved = Results::unsolved(rows.start, expected, modes);
    let mut results = unsolved.map_err(|error| error.to_string())?;
    let mut reader = ::csv::Reader::from_reader(content);
    let (mut record, mut row) = (::csv::ByteRecord::new(), 0);
    let wrong = |error: ::csv::Error| error.to_string();
    while reader.read_byte_record(&mut record).map_err(wrong)? {
        if row == expected {
            return Err(format!("it has more rows than {expected}"));
        }
        if record.len() != columns.len() {
            return Err(format!("line {} has {} cells", row + 2, record.len()));
        }
        for ((_, column), cell) in columns.iter().zip(&record) {
            put(&mut results, row, column, cell)?;
        }
        row += 1;
    }
    match row == expected {
        true => Ok(results),
        false => Err(format!("it has {row} rows in place of {expected}")),
    }
}

/// Puts a cell of a row into the results.
fn put(results: &mut Results, row: usize, column: &Column, cell: &[u8]) -> Result<(), String> {
    let text = std::str::from_utf8(cell).map_err(|error| error.to_string())?;
    let number = || match text {
        "" => Ok(f64::NAN),
        digits => digits
            .parse::<f64>()
            .map_err(|_| format!("line {} has `{digits}` in place of a number", row + 2)),
    };
    let modes = results.modes.len();
    match *column {
        Column::Row | Column::Input(_) => {}
        Column::MassKg => results.mass_kg[row] = number()?,
        Column::Certified => results.certified[row] = text == "true",
        Column::Hz(mode) => results.frequency_hz[row * modes + mode] = number()?,
        Column::ErrorHz(mode) => results.error_hz[row * modes + mode] = number()?,
        Column::Share(mode) => results.share[row * modes + mode] = number()?,
        Column::Sentence if text.is_empty() => {}
        Column::Sentence => {
            let row = results.first_row + row as u64;
            let kept = results.failures.push(row, text);
            kept.map_err(|error| error.to_string())?;
        }
    }
    Ok(())
}
