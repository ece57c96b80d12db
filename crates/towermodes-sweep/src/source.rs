//! The values of the rows of a sweep in memory.

use thiserror::Error;

use crate::sampling::Draw;

/// Gives the values of any row.
pub trait RowSource: Sync {
    /// Number of rows.
    fn rows(&self) -> u64;

    /// Number of values of a row.
    fn width(&self) -> usize;

    /// Writes the values of a row, from 0: one for each change.
    fn row(&self, row: u64, values: &mut [f64]);
}

impl RowSource for Draw {
    fn rows(&self) -> u64 {
        Draw::rows(self)
    }

    fn width(&self) -> usize {
        self.columns()
    }

    fn row(&self, row: u64, values: &mut [f64]) {
        Draw::row(self, row, values);
    }
}

/// Columns in memory, one for each change.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns<'a> {
    columns: Vec<&'a [f64]>,
}

/// Columns of different lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error(
    "column {column} has {rows} rows, but the first column has {first}; all columns need the same number"
)]
pub struct LengthsDiffer {
    /// The column, from 0.
    pub column: usize,
    /// Its number of rows.
    pub rows: usize,
    /// That of the first column.
    pub first: usize,
}

impl<'a> Columns<'a> {
    /// Columns of one length.
    ///
    /// # Errors
    /// [`LengthsDiffer`] with the first column of another length.
    pub fn new(columns: Vec<&'a [f64]>) -> Result<Self, LengthsDiffer> {
        let first = columns.first().map_or(0, |column| column.len());
        match columns.iter().position(|column| column.len() != first) {
            None => Ok(Self { columns }),
            Some(column) => Err(LengthsDiffer {
                column,
                rows: columns[column].len(),
                first,
            }),
        }
    }
}

impl RowSource for Columns<'_> {
    fn rows(&self) -> u64 {
        self.columns.first().map_or(0, |column| column.len() as u64)
    }

    fn width(&self) -> usize {
        self.columns.len()
    }

    fn row(&self, row: u64, values: &mut [f64]) {
        for (value, column) in values.iter_mut().zip(&self.columns) {
            *value = column[row as usize];
        }
    }
}
