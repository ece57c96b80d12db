//! The values of the rows of a sweep in memory.

use std::ops::Range;

use thiserror::Error;

use crate::sampling::Draw;

/// Gives the values of any row.
pub trait RowSource: Sync {
    /// The number of its first row in the whole sweep.
    fn first_row(&self) -> u64 {
        0
    }

    /// Number of rows.
    fn rows(&self) -> u64;

    /// Number of values of a row.
    fn width(&self) -> usize;

    /// Writes the values of a row, counted from 0 at its first row: one for each change.
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

/// The values of successive rows of a sweep; rows are numbered as in the whole sweep.
#[derive(Debug)]
pub struct SourceBlock<'a> {
    rows: Range<u64>,
    width: usize,
    values: Values<'a>,
}

enum Values<'a> {
    /// A source of all rows; values are requested when they are needed.
    Given(&'a dyn RowSource),
    /// The values of the rows, row by row.
    Read(Vec<f64>),
}

impl std::fmt::Debug for Values<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Given(_) => "Given",
            Self::Read(_) => "Read",
        })
    }
}

impl<'a> SourceBlock<'a> {
    /// Rows of a source, numbered as in the whole sweep.
    pub(crate) fn of(source: &'a dyn RowSource, rows: Range<u64>) -> Self {
        let width = source.width();
        let values = Values::Given(source);
        Self {
            rows,
            width,
            values,
        }
    }

    /// Rows with the values that were read.
    pub(crate) fn read(values: Vec<f64>, rows: Range<u64>, width: usize) -> Self {
        let values = Values::Read(values);
        Self {
            rows,
            width,
            values,
        }
    }
}

impl RowSource for SourceBlock<'_> {
    fn first_row(&self) -> u64 {
        self.rows.start
    }

    fn rows(&self) -> u64 {
        self.rows.end - self.rows.start
    }

    fn width(&self) -> usize {
        self.width
    }

    fn row(&self, row: u64, values: &mut [f64]) {
        match &self.values {
            Values::Given(source) => {
                source.row(self.rows.start - source.first_row() + row, values);
            }
            Values::Read(read) => {
                let start = row as usize * self.width;
                values.copy_from_slice(&read[start..start + self.width]);
            }
        }
    }
}

/// Columns in memory, one for each change.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns<'a> {
    columns: Vec<&'a [f64]>,
    first_row: u64,
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
    /// The number of rows of the first column.
    pub first: usize,
}

impl<'a> Columns<'a> {
    /// Columns of equal length.
    ///
    /// # Errors
    /// [`LengthsDiffer`] with the first column whose length differs.
    pub fn new(columns: Vec<&'a [f64]>) -> Result<Self, LengthsDiffer> {
        let first = columns.first().map_or(0, |column| column.len());
        match columns.iter().position(|column| column.len() != first) {
            None => Ok(Self {
                columns,
                first_row: 0,
            }),
            Some(column) => Err(LengthsDiffer {
                column,
                rows: columns[column].len(),
                first,
            }),
        }
    }

    /// The same columns as rows of a larger sweep, beginning at this row number.
    #[must_use]
    pub fn from_row(self, first_row: u64) -> Self {
        Self { first_row, ..self }
    }
}

impl RowSource for Columns<'_> {
    fn first_row(&self) -> u64 {
        self.first_row
    }

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
