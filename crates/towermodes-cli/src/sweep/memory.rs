//! A small sweep in memory, printed as CSV.

use std::ops::ControlFlow;

use towermodes_sweep::{RowSource, SweepSource, results_csv, run as solve_rows};

use super::planned::Planned;
use super::progress::SweepProgress;
use crate::args::SweepArguments;
use crate::failure::{Failure, note_texts};
use crate::output::deliver;

/// More rows are written to a folder, where an interrupted sweep can continue.
pub(crate) const MOST_ROWS: u64 = 100_000;

/// Solves all rows and prints them.
pub(super) fn run(planned: &Planned, arguments: &SweepArguments) -> Result<(), Failure> {
    let rows = planned.source.rows();
    if rows > MOST_ROWS {
        return Err(Failure::ManyRows { rows });
    }
    let values = Values::of(&planned.source, planned.sweep.changes().len())?;
    let progress = SweepProgress::new(rows);
    let results = solve_rows(&planned.sweep, &values, arguments.threads(), &mut |done| {
        progress.set(done);
        ControlFlow::Continue(())
    });
    drop(progress);
    let results = results.map_err(Failure::Rows)?;
    let failed = results.failures.first().map(|(row, sentence)| {
        let count = results.failures.len();
        let verb = if count == 1 { "has" } else { "have" };
        format!("{count} of {rows} rows {verb} no complete result (column error); first: row {row}: {sentence}")
    });
    let csv = results_csv(&planned.sweep, &values, results);
    let csv = csv.map_err(|error| Failure::Unwritable("the results".to_owned(), error))?;
    note_texts(&Vec::from_iter(failed));
    deliver(&csv, None)
}

/// The values of all rows.
pub(super) enum Values<'a> {
    /// Drawn when they are needed.
    Drawn(&'a towermodes_sweep::Draw),
    /// Of a table, row by row.
    Read { values: Vec<f64>, columns: usize },
}

impl<'a> Values<'a> {
    pub(super) fn of(source: &'a SweepSource, columns: usize) -> Result<Self, Failure> {
        Ok(match source {
            SweepSource::Sampled { draw, .. } => Self::Drawn(draw),
            SweepSource::Table(table) => Self::Read {
                values: table.read(0..table.rows()).map_err(Failure::Table)?,
                columns,
            },
        })
    }
}

impl RowSource for Values<'_> {
    fn rows(&self) -> u64 {
        match self {
            Self::Drawn(draw) => draw.rows(),
            Self::Read { values, columns } => (values.len() / columns) as u64,
        }
    }

    fn width(&self) -> usize {
        match self {
            Self::Drawn(draw) => draw.width(),
            Self::Read { columns, .. } => *columns,
        }
    }

    fn row(&self, row: u64, to: &mut [f64]) {
        match self {
            Self::Drawn(draw) => draw.row(row, to),
            Self::Read { values, columns } => {
                let start = row as usize * columns;
                to.copy_from_slice(&values[start..start + columns]);
            }
        }
    }
}
