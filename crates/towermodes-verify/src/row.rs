//! One line of the manual.

use crate::chapter::Chapter;
use crate::expected::Expected;

/// One line of the manual: an expected and a computed value.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The chapter of the manual.
    pub chapter: Chapter,
    /// The name of the case.
    pub case: String,
    /// The source of the expected value.
    pub source: &'static str,
    /// What a reader of the values should know; empty for nothing.
    pub remark: &'static str,
    /// The name of the quantity: "bending 2".
    pub what: String,
    /// The method with its number of segments.
    pub method: String,
    /// The unit of the values: `Hz`, `kg`, `N/m`, or `1` for dimensionless ones.
    pub unit: &'static str,
    /// The expected value.
    pub expected: Expected,
    /// The computed value, or the reason why there is none.
    pub got: Result<f64, String>,
    /// The permitted relative difference.
    pub tolerance: f64,
}

impl Row {
    /// got/expected − 1.
    pub fn relative_difference(&self) -> Option<f64> {
        let got = self.got.as_ref().ok()?;
        Some(got / self.expected.value - 1.0)
    }

    /// Whether a neighbouring row belongs to the same case.
    pub fn is_of_the_case_of(&self, other: &Self) -> bool {
        (&self.case, self.source) == (&other.case, other.source)
    }

    /// The computed value with one digit more than the expected one, or the reason why there is
    /// none.
    pub fn shown(&self) -> String {
        let decimals = self.expected.decimals + 1;
        match &self.got {
            Ok(got) => format!("{got:.decimals$}"),
            Err(why) => why.clone(),
        }
    }

    /// The relative difference with one digit, or `<1e-12`, because the last bits depend on the
    /// processor.
    pub fn shown_difference(&self) -> String {
        match self.relative_difference() {
            None => String::new(),
            Some(difference) if difference.abs() < 1e-12 => "<1e-12".into(),
            Some(difference) => format!("{difference:.0e}"),
        }
    }

    /// The cells of a table of rows: method, mode, expected, computed, difference, tolerance,
    /// verdict.
    pub fn cells(&self) -> [String; 7] {
        let decimals = self.expected.decimals;
        [
            self.method.clone(),
            self.what.clone(),
            format!("{:.decimals$}", self.expected.value),
            self.shown(),
            self.shown_difference(),
            format!("{:.0e}", self.tolerance),
            self.verdict().to_owned(),
        ]
    }

    /// The names of the columns of [`record`](Self::record).
    pub const COLUMNS: [&'static str; 11] = [
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
    ];

    /// The row as a record of CSV.
    pub fn record(&self) -> [String; 11] {
        let difference = self.relative_difference();
        [
            self.chapter.name.to_owned(),
            self.case.clone(),
            self.source.to_owned(),
            self.method.clone(),
            self.what.clone(),
            self.unit.to_owned(),
            self.expected.value.to_string(),
            self.got.as_ref().map_or_else(Clone::clone, f64::to_string),
            difference.map_or_else(String::new, |difference| format!("{difference:e}")),
            format!("{:e}", self.tolerance),
            self.verdict().to_owned(),
        ]
    }

    /// PASS or FAIL.
    pub fn verdict(&self) -> &'static str {
        if self.passes() { "PASS" } else { "FAIL" }
    }

    /// Whether the difference is within the tolerance.
    pub fn passes(&self) -> bool {
        self.relative_difference()
            .is_some_and(|difference| difference.abs() <= self.tolerance)
    }
}

/// All values of the manual that were compared.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Verification {
    /// Number of values compared.
    pub values: usize,
    /// Number of values outside their tolerance.
    pub failures: usize,
    /// Every value.
    pub rows: Vec<Row>,
}

impl Verification {
    /// Counts the rows that do not pass.
    pub fn of(rows: Vec<Row>) -> Self {
        Self {
            values: rows.len(),
            failures: rows.iter().filter(|row| !row.passes()).count(),
            rows,
        }
    }
}
