//! The rows and cells of a CSV table with their places, their numbers and units of length, for
//! tables whose header gives the quantity and unit of each column.

mod cells;
mod number;
mod unit;

pub(crate) use cells::{Cell, Record, Records};
pub(crate) use number::Numbers;
pub(crate) use unit::Unit;

use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Largest number of mistakes that are collected; further ones have the same cause.
pub(crate) const MAX_MISTAKES: usize = 20;

/// Number of cells in the rows of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Width {
    /// The number of columns.
    pub(crate) columns: usize,
    /// The number of columns that must have a cell in each row.
    pub(crate) needed: usize,
}

impl Width {
    /// Refuses a row with too few or too many cells; empty cells at its end do not count.
    pub(crate) fn check(self, record: &Record<'_>) -> Result<(), Diagnostic> {
        let filled = record.cells.iter().rposition(|cell| !cell.text.is_empty());
        let filled = filled.map_or(0, |last| last + 1);
        let found = record.cells.len();
        if filled > self.columns {
            let kind = DiagnosticKind::wrong_count_of("cells", "the row", filled, self.columns);
            let hint = "if a decimal comma is meant, separate the columns by semicolons";
            let span = record.cells[self.columns].span.clone();
            return Err(Diagnostic::new(span, kind).with_hint(hint));
        }
        if found < self.needed {
            let kind = DiagnosticKind::wrong_count_of("cells", "the row", found, self.columns);
            return Err(Diagnostic::new(record.span.clone(), kind));
        }
        Ok(())
    }
}

/// The rows after the header, each with its mistake if it has too many or too few cells; the row
/// after the first `most` is the last one, and a mistake.
pub(crate) fn rows(
    records: Records<'_>,
    width: Width,
    most: usize,
) -> impl Iterator<Item = Result<Record<'_>, Diagnostic>> {
    records
        .take(most + 1)
        .enumerate()
        .map(move |(index, record)| {
            let record = record?;
            if index == most {
                let (what, found, limit) = ("rows".to_owned(), index + 1, most);
                let kind = DiagnosticKind::TooMany { what, found, limit };
                return Err(Diagnostic::new(record.span, kind));
            }
            width.check(&record).map(|()| record)
        })
}

/// Refuses a first row of numbers, where the column names should be.
pub(crate) fn check_header(record: &Record<'_>, example: &str) -> Result<(), Diagnostic> {
    let is_number = |cell: &Cell<'_>| cell.text.replace(',', ".").parse::<f64>().is_ok();
    if !record.cells.iter().all(is_number) {
        return Ok(());
    }
    let kind = DiagnosticKind::misplaced("a header with names of columns", "numbers");
    Err(Diagnostic::new(record.span.clone(), kind).with_hint(example))
}

/// The mistake of a table without a row after the header.
pub(crate) fn no_rows(text: &str) -> Diagnostic {
    let end = text.trim_end().len();
    let expected = "a row after the header".to_owned();
    Diagnostic::new(end..end, DiagnosticKind::EndOfFile { expected })
}
