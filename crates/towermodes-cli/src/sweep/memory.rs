//! A small sweep in memory, printed as CSV.

use std::ops::ControlFlow;

use towermodes_sweep::{results_csv, run as solve_rows};

use super::planned::Planned;
use super::progress::SweepProgress;
use super::warned;
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
    let values = planned.source.block(0..rows).map_err(Failure::Table)?;
    let mut progress = SweepProgress::new(rows);
    let results = solve_rows(&planned.sweep, &values, arguments.threads(), &mut |done| {
        progress.set(done);
        ControlFlow::Continue(())
    });
    drop(progress);
    let results = results.map_err(Failure::Rows)?;
    let failed = results.failures.get(0).map(|(row, sentence)| {
        let count = results.failures.len();
        let verb = if count == 1 { "has" } else { "have" };
        format!("{count} of {rows} rows {verb} no complete result (column error); the first is row {row}, counted from 0: {sentence}")
    });
    let remarks = [results.warnings.clone(), results.shared.clone()];
    let csv = results_csv(&planned.sweep, &values, results);
    let csv = csv.map_err(|error| Failure::Unwritable("the results".to_owned(), error))?;
    note_texts(&Vec::from_iter(failed));
    let [warnings, shared] = &remarks;
    warned::report([warnings, shared], rows);
    deliver(&csv, None)
}
