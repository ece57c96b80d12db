//! Results in memory as one table in CSV.

use std::io;

use super::csv;
use super::part::{Part, columns};
use crate::results::Results;
use crate::source::RowSource;
use crate::sweep::Sweep;

/// The results of rows of a source as CSV, with the columns that parts have.
///
/// # Errors
/// [`io::ErrorKind::InvalidInput`] if the source has another number of values than the sweep has
/// changes, or does not have these rows.
pub fn results_csv(sweep: &Sweep, source: &dyn RowSource, results: Results) -> io::Result<Vec<u8>> {
    let (values, changes) = (source.width(), sweep.changes().len());
    let end = results.first_row + results.rows() as u64;
    if values != changes || source.rows() < end {
        let rows = source.rows();
        return Err(io::Error::new(
            io::ErrorKind::InvalidInput,
            format!(
                "the results have {changes} changes and rows up to {end}, \
                 but the source has {values} values in each of {rows} rows"
            ),
        ));
    }
    let part = Part::new(sweep, source, results.first_row, results);
    csv::write(&part, &columns(sweep)).map_err(io::Error::from)
}
