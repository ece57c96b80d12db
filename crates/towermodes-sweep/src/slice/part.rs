//! Rows that are ready to be written.

use crate::rows::results::Results;
use crate::source::RowSource;
use crate::sweep::Sweep;

/// Results with the input values of their rows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Part {
    /// The values of the changes, row by row; empty if they are not columns.
    pub(super) inputs: Vec<f64>,
    pub(super) results: Results,
}

impl Part {
    pub(super) fn new(sweep: &Sweep, block: &dyn RowSource, results: Results) -> Self {
        let changes = sweep.changes().len();
        let mut inputs = Vec::new();
        if sweep.has_inputs() {
            inputs = vec![0.0; results.rows() * changes];
            let first = results.first_row - block.first_row();
            for (row, values) in (first..).zip(inputs.chunks_exact_mut(changes)) {
                block.row(row, values);
            }
        }
        Self { inputs, results }
    }
}
