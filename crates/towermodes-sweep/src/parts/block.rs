//! The values of successive rows of a sweep.

use std::ops::Range;

use super::plan::SweepSource;
use crate::sampling::Draw;
use crate::source::RowSource;
use crate::table::TableError;

/// The values of successive rows of a [`SweepSource`], numbered from 0.
#[derive(Debug)]
pub struct SourceBlock<'a> {
    rows: Range<u64>,
    width: usize,
    values: Values<'a>,
}

#[derive(Debug)]
enum Values<'a> {
    /// Drawn when they are needed.
    Drawn(&'a Draw),
    /// Of a table, row by row.
    Read(Vec<f64>),
}

impl SweepSource {
    /// The values of rows, numbered from 0. Those of a table are read now, so a part of a table
    /// needs memory for itself only; those of a sample need none.
    ///
    /// # Errors
    /// [`TableError`] if the table has changed, or cannot be read any more.
    ///
    /// # Panics
    /// If there are no such rows.
    pub fn block(&self, rows: Range<u64>) -> Result<SourceBlock<'_>, TableError> {
        assert!(rows.start <= rows.end && rows.end <= self.rows());
        let (width, values) = match self {
            Self::Sampled { draw, .. } => (draw.columns(), Values::Drawn(draw)),
            Self::Table(table) => {
                let values = Values::Read(table.read(rows.clone())?);
                (table.changes().len(), values)
            }
        };
        Ok(SourceBlock {
            rows,
            width,
            values,
        })
    }
}

impl RowSource for SourceBlock<'_> {
    fn rows(&self) -> u64 {
        self.rows.end - self.rows.start
    }

    fn width(&self) -> usize {
        self.width
    }

    fn row(&self, row: u64, values: &mut [f64]) {
        match &self.values {
            Values::Drawn(draw) => draw.row(self.rows.start + row, values),
            Values::Read(read) => {
                let start = row as usize * self.width;
                values.copy_from_slice(&read[start..start + self.width]);
            }
        }
    }
}
