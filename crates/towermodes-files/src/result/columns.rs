//! Flat quantities of a result: each is one entry of a list, from which its CSV and the arrays of
//! the Python package follow.

use std::io::Write;

use super::ResultError;

/// A quantity of a record of a result.
#[derive(Debug, Clone, Copy)]
pub struct Column<R: 'static> {
    /// Its key in the JSON; a dot separates the keys of nested objects.
    pub key: &'static str,
    /// Its unit; empty for pure numbers and texts.
    pub unit: &'static str,
    /// Its meaning.
    pub meaning: &'static str,
    /// Its value in a record.
    pub value: fn(&R) -> Cell,
}

/// A value in a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A text; empty for none.
    Text(String),
    /// A count.
    Count(usize),
    /// A number; in CSV an empty cell if it is infinite or NaN.
    Number(f64),
    /// A small number, written in CSV with an exponent.
    Small(f64),
}

impl Cell {
    /// The text of the cell in CSV.
    pub fn csv(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Count(count) => count.to_string(),
            Self::Number(number) if !number.is_finite() => String::new(),
            Self::Number(number) => number.to_string(),
            Self::Small(number) => format!("{number:e}"),
        }
    }
}

/// The values of a record.
pub(super) fn record<R>(columns: &[Column<R>], of: &R) -> impl Iterator<Item = String> {
    columns.iter().map(move |column| (column.value)(of).csv())
}

/// Writes records as CSV with the keys as header.
pub(super) fn write_columns_csv<R>(
    columns: &[Column<R>],
    records: &[R],
    writer: impl Write,
) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record(columns.iter().map(|column| column.key))?;
    for one in records {
        csv.write_record(record(columns, one))?;
    }
    csv.flush()?;
    Ok(())
}
