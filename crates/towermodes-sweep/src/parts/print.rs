//! Results in memory as one table in CSV.

use std::io;

use super::csv;
use super::part::{Part, columns};
use crate::results::Results;
use crate::source::RowSource;
use crate::sweep::Sweep;

/// The results of all rows of a source as CSV, with the columns that parts have.
///
/// # Errors
/// If the table does not fit into memory.
pub fn results_csv(sweep: &Sweep, source: &dyn RowSource, results: Results) -> io::Result<Vec<u8>> {
    let changes = sweep.changes().len();
    let mut inputs = Vec::new();
    if sweep.has_inputs() {
        inputs = vec![0.0; results.rows() * changes];
        for (row, values) in inputs.chunks_exact_mut(changes).enumerate() {
            source.row(results.first_row + row as u64, values);
        }
    }
    let part = Part { inputs, results };
    csv::write(&part, &columns(sweep)).map_err(io::Error::from)
}
