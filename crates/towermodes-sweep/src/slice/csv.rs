//! Slices in CSV.

use std::fs::File;
use std::io::{self, BufReader, Write};

use super::column::Column;
use super::part::Part;
use crate::rows::results::Results;

/// The line with the names of the columns.
pub(super) fn names(columns: &[(String, Column)]) -> io::Result<Vec<u8>> {
    let mut writer = ::csv::Writer::from_writer(Vec::new());
    writer.write_record(columns.iter().map(|(name, _)| name))?;
    writer.into_inner().map_err(|error| error.into_error())
}

/// The lines of rows.
pub(super) fn rows(part: &Part, columns: &[(String, Column)]) -> io::Result<Vec<u8>> {
    let mut writer = ::csv::Writer::from_writer(Vec::new());
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
    writer.into_inner().map_err(|error| error.into_error())
}

/// A number with all its digits; nothing for NaN.
fn number(cell: &mut Vec<u8>, number: f64) -> std::io::Result<()> {
    match number.is_nan() {
        true => Ok(()),
        // With an exponent where the number is large or small.
        false => write!(cell, "{number:?}"),
    }
}

/// The rows of a slice, one block after the other.
pub(super) struct Rows(::csv::Reader<BufReader<File>>);

impl Rows {
    /// Those of a file behind its header.
    ///
    /// # Errors
    /// What is wrong with the names of the columns.
    pub(super) fn new(file: BufReader<File>, columns: &[(String, Column)]) -> Result<Self, String> {
        let mut reader = ::csv::ReaderBuilder::new().flexible(true).from_reader(file);
        let found = reader.headers().map_err(|error| error.to_string())?;
        match found.iter().eq(columns.iter().map(|(name, _)| name)) {
            true => Ok(Self(reader)),
            false => Err("it has other columns".to_owned()),
        }
    }

    /// Reads rows into empty results, as many as these have.
    ///
    /// # Errors
    /// What is wrong with the text.
    pub(super) fn fill(
        &mut self,
        results: &mut Results,
        columns: &[(String, Column)],
    ) -> Result<(), String> {
        let mut record = ::csv::ByteRecord::new();
        for place in 0..results.rows() {
            let row = results.first_row + place as u64;
            let read = self.0.read_byte_record(&mut record);
            match read {
                Ok(true) if record.len() == columns.len() => {}
                Ok(true) => return Err(format!("row {row} has {} cells", record.len())),
                Ok(false) => return Err(format!("it ends before row {row}")),
                Err(error) => return Err(error.to_string()),
            }
            for ((_, column), cell) in columns.iter().zip(&record) {
                put(results, place, column, cell)?;
            }
        }
        Ok(())
    }

    /// Refuses further rows.
    pub(super) fn end(mut self) -> Result<(), String> {
        let mut record = ::csv::ByteRecord::new();
        match self.0.read_byte_record(&mut record) {
            Ok(false) => Ok(()),
            Ok(true) => Err("it has more rows than stated in its first line".to_owned()),
            Err(error) => Err(error.to_string()),
        }
    }
}

/// Puts a cell of a row, by its place, into the results.
fn put(results: &mut Results, place: usize, column: &Column, cell: &[u8]) -> Result<(), String> {
    let row = results.first_row + place as u64;
    let text = std::str::from_utf8(cell).map_err(|error| error.to_string())?;
    let number = || match text {
        "" => Ok(f64::NAN),
        digits => digits
            .parse::<f64>()
            .map_err(|_| format!("row {row} has `{digits}` in place of a number")),
    };
    let modes = results.modes.len();
    match *column {
        Column::Row if text.parse() != Ok(row) => {
            return Err(format!("it has row `{text}` in place of row {row}"));
        }
        Column::Row | Column::Input(_) => {}
        Column::MassKg => results.mass_kg[place] = number()?,
        Column::Certified => results.certified[place] = text == "true",
        Column::Hz(mode) => results.frequency_hz[place * modes + mode] = number()?,
        Column::ErrorHz(mode) => results.error_hz[place * modes + mode] = number()?,
        Column::Share(mode) => results.share[place * modes + mode] = number()?,
        Column::Sentence if text.is_empty() => {}
        Column::Sentence => {
            let kept = results.failures.push(row, text);
            kept.map_err(|error| error.to_string())?;
        }
    }
    Ok(())
}
