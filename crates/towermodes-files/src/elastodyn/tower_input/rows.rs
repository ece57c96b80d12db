//! Rows of numbers: their values, ranges and fractions of the length.

use std::ops::Range;

use super::super::record::Kind;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::{Line, Token};

/// The numbers at the beginning of a row, one for each column; further numbers are not read.
pub(crate) fn numbers<'a, const N: usize>(
    line: &Line<'a>,
    row: &str,
    columns: [&str; N],
) -> Result<[(f64, Token<'a>); N], Diagnostic> {
    let too_few = |found: usize| {
        let kind = DiagnosticKind::wrong_count_of("numbers", row, found, N);
        let (missing, all) = (columns[found.min(N - 1)], columns.join(", "));
        Diagnostic::new(line.span(), kind)
            .with_hint(format!("{missing} is missing; a row has {all}"))
    };
    let mut tokens = line.tokens();
    let mut read = Vec::with_capacity(N);
    for column in columns {
        let token = tokens.next().ok_or_else(|| too_few(read.len()))?;
        read.push((token.number(&format!("{column} of {row}"))?, token));
    }
    read.try_into().map_err(|_| too_few(0))
}

/// Checks a number of a row.
pub(crate) fn check_cell(
    token: &Token<'_>,
    what: String,
    value: f64,
    kind: Kind,
) -> Result<(), Diagnostic> {
    match kind {
        Kind::Number(is_met, rule) if !is_met(value) => {
            Err(token.wrong(DiagnosticKind::out_of_range(what, value, rule)))
        }
        _ => Ok(()),
    }
}

/// Whether two fractions of a length agree within the tolerance of OpenFAST in double precision.
fn is_fraction(value: f64, wanted: f64) -> bool {
    (value - wanted).abs() <= 1e-14
}

/// Checks the fraction of the length of a row: 0 in the first row, increasing from row to row.
pub(crate) fn next_fraction(
    value: f64,
    token: &Token<'_>,
    previous: Option<f64>,
    column: &str,
) -> Result<f64, Diagnostic> {
    match previous {
        None if is_fraction(value, 0.0) => Ok(0.0),
        None => {
            let what = format!("{column} of the first row");
            Err(token.wrong(DiagnosticKind::out_of_range(what, value, "0")))
        }
        Some(previous) if value > previous => Ok(value),
        Some(previous) => Err(token
            .wrong(DiagnosticKind::not_rising(column, value, previous, ""))
            .with_hint(
                "it must increase from row to row; a step is two rows close together, such as 0.1 and 0.100001",
            )),
    }
}

/// Checks that the fraction of the length of the last row is 1, and returns it.
pub(crate) fn last_fraction(
    value: f64,
    span: Range<usize>,
    column: &str,
) -> Result<f64, Diagnostic> {
    if is_fraction(value, 1.0) {
        return Ok(1.0);
    }
    let what = format!("{column} of the last row");
    Err(Diagnostic::new(
        span,
        DiagnosticKind::out_of_range(what, value, "1"),
    ))
}
