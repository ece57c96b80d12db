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

/// The lines of rows. Numbers are written without quotation marks; only messages may need them.
pub(super) fn rows(part: &Part, columns: &[(String, Column)]) -> io::Result<Vec<u8>> {
    let results = &part.results;
    let modes = results.modes.len();
    let changes = part.inputs.len().checked_div(results.rows()).unwrap_or(0);
    let mut text = Vec::with_capacity(results.rows() * columns.len() * CELL_BYTES);
    for (row, sentence) in results.sentences().enumerate() {
        for (place, (_, column)) in columns.iter().enumerate() {
            if place > 0 {
                text.push(b',');
            }
            match *column {
                Column::Row => write!(text, "{}", results.first_row + row as u64)?,
                Column::Input(input) => number(&mut text, part.inputs[row * changes + input])?,
                Column::MassKg => number(&mut text, results.mass_kg[row])?,
                Column::Certified => text.extend(match results.certified[row] {
                    true => &b"true"[..],
                    false => b"false",
                }),
                Column::Hz(mode) => number(&mut text, results.frequency_hz[row * modes + mode])?,
                Column::ErrorHz(mode) => number(&mut text, results.error_hz[row * modes + mode])?,
                Column::Share(mode) => number(&mut text, results.share[row * modes + mode])?,
                Column::Sentence => text.extend(quoted(sentence.unwrap_or_default())?),
            }
        }
        text.push(b'\n');
    }
    Ok(text)
}

/// Approximate length of a number with its comma.
const CELL_BYTES: usize = 20;

/// A text as a cell; the row has other cells, so an empty text needs no quotation marks.
fn quoted(sentence: &str) -> io::Result<Vec<u8>> {
    if sentence.is_empty() {
        return Ok(Vec::new());
    }
    let mut writer = ::csv::Writer::from_writer(Vec::new());
    writer.write_record([sentence])?;
    let mut cell = writer.into_inner().map_err(|error| error.into_error())?;
    // The end of the line.
    cell.pop();
    Ok(cell)
}

/// A number with all its digits in the format `{:?}`: with an exponent if it is large or small;
/// nothing for NaN.
fn number(text: &mut Vec<u8>, number: f64) -> io::Result<()> {
    match number.abs() {
        size if size.is_nan() => Ok(()),
        // Between 1e-5 and 1e-4 `ryu` writes no exponent. From 1e15 the two writers may round a tie
        // differently. Results are not below 1e-300.
        0.0 | 1e-4..1e15 | 1e-300..1e-5 => {
            text.extend(ryu::Buffer::new().format_finite(number).as_bytes());
            Ok(())
        }
        _ => write!(text, "{number:?}"),
    }
}

/// The rows of a slice, one block after another.
pub(super) struct Rows(::csv::Reader<BufReader<File>>);

impl Rows {
    /// The rows of a file after its header.
    ///
    /// # Errors
    /// The error in the names of the columns.
    pub(super) fn new(file: BufReader<File>, columns: &[(String, Column)]) -> Result<Self, String> {
        let mut reader = ::csv::ReaderBuilder::new().flexible(true).from_reader(file);
        let found = reader.headers().map_err(|error| error.to_string())?;
        match found.iter().eq(columns.iter().map(|(name, _)| name)) {
            true => Ok(Self(reader)),
            false => Err("it has other columns".to_owned()),
        }
    }

    /// Reads as many rows as the empty results have into these.
    ///
    /// # Errors
    /// The error in the text.
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

/// Stores a cell of a row, by the index of the row, in the results.
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

#[cfg(test)]
mod tests {
    use super::{number, quoted};

    #[test]
    fn numbers_are_written_as_the_standard_library_does() {
        let edges = [
            0.0,
            -0.0,
            1.0,
            -2.5,
            1e-4,
            9.999e-5,
            0.1 + 0.2,
            1e15,
            1e16,
            9.999e15,
            1.5e300,
            -1e-300,
            f64::INFINITY,
            5e-324,
        ];
        let powers = (-7200..7200).map(|k| 1.2345678901234567 * 1.1_f64.powi(k));
        for value in edges.into_iter().chain(powers) {
            let mut text = Vec::new();
            number(&mut text, value).expect("a vector takes all");
            assert_eq!(String::from_utf8_lossy(&text), format!("{value:?}"));
        }
        let mut text = Vec::new();
        number(&mut text, f64::NAN).expect("a vector takes all");
        assert!(text.is_empty());
    }

    #[test]
    fn sentences_are_quoted_where_they_must_be() {
        for (sentence, cell) in [
            ("", ""),
            ("plain", "plain"),
            ("a, b", "\"a, b\""),
            ("say \"a\"", "\"say \"\"a\"\"\""),
        ] {
            let quoted = quoted(sentence).expect("a vector takes all");
            assert_eq!(String::from_utf8_lossy(&quoted), cell);
        }
    }
}
