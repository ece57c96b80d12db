//! The verification manual as JSON and as CSV.

use std::io::Write;

use schemars::JsonSchema;
use serde::Serialize;
use towermodes_verify::Row;

use super::{ResultError, write_pretty};

/// The result of `towermodes verify --format json`. Keys are stable: new ones may be added, none is
/// renamed.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "towermodes verification")]
pub(super) struct VerificationJson<'a> {
    /// Number of values compared.
    values: usize,
    /// How many of them did not come out.
    failures: usize,
    /// Every value.
    rows: Vec<RowJson<'a>>,
}

/// A value that is known, and what came out.
#[derive(Serialize, JsonSchema)]
struct RowJson<'a> {
    /// The chapter of the manual, by its name on the command line.
    chapter: &'static str,
    /// The tower or beam.
    case: &'a str,
    /// Where the expected value is from.
    source: &'static str,
    /// The method with its segments.
    method: &'a str,
    /// What it is a value of, as "bending 2".
    mode: &'a str,
    /// `Hz`, or `1` for dimensionless frequencies.
    unit: &'static str,
    /// The expected value.
    expected: f64,
    /// What came out; null if nothing did.
    got: Option<f64>,
    /// got/expected − 1; null if nothing came out.
    relative_difference: Option<f64>,
    /// How large that may be.
    tolerance: f64,
    /// Whether it is not larger.
    passes: bool,
}

/// Writes rows of the manual as indented JSON.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_verification_json(rows: &[Row], writer: impl Write) -> Result<(), ResultError> {
    let json = VerificationJson {
        values: rows.len(),
        failures: rows.iter().filter(|row| !row.passes()).count(),
        rows: rows.iter().map(row_json).collect(),
    };
    write_pretty(&json, writer)
}

fn row_json(row: &Row) -> RowJson<'_> {
    RowJson {
        chapter: row.chapter.name,
        case: &row.case,
        source: row.source,
        method: &row.method,
        mode: &row.what,
        unit: row.unit,
        expected: row.expected.value,
        got: row.got.as_ref().ok().copied(),
        relative_difference: row.relative_difference(),
        tolerance: row.tolerance,
        passes: row.passes(),
    }
}

/// Writes rows of the manual as CSV.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_verification_csv(rows: &[Row], writer: impl Write) -> Result<(), ResultError> {
    let mut csv = ::csv::Writer::from_writer(writer);
    csv.write_record([
        "chapter",
        "case",
        "source",
        "method",
        "mode",
        "unit",
        "expected",
        "got",
        "relative_difference",
        "tolerance",
        "verdict",
    ])?;
    for row in rows {
        let difference = row.relative_difference();
        csv.write_record([
            row.chapter.name.to_owned(),
            row.case.clone(),
            row.source.to_owned(),
            row.method.clone(),
            row.what.clone(),
            row.unit.to_owned(),
            row.expected.value.to_string(),
            row.got.as_ref().map_or_else(Clone::clone, f64::to_string),
            difference.map_or_else(String::new, |difference| format!("{difference:e}")),
            format!("{:e}", row.tolerance),
            row.verdict().to_owned(),
        ])?;
    }
    csv.flush()?;
    Ok(())
}
