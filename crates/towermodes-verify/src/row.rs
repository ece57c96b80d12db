//! One line of the manual.

use crate::expected::Expected;
use crate::manual::Chapter;

/// One line of the manual: an expected value and what came out.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Where in the manual it stands.
    pub chapter: Chapter,
    /// The case's name.
    pub case: String,
    /// Where the expected value is from.
    pub source: &'static str,
    /// What it is a value of: "bending 2".
    pub what: String,
    /// The method with its segments.
    pub method: String,
    /// What the values are multiples of: `Hz`, or `1`.
    pub unit: &'static str,
    /// The expected value.
    pub expected: Expected,
    /// What came out, or why nothing did.
    pub got: Result<f64, String>,
    /// By how much the two may differ, relatively.
    pub tolerance: f64,
}

impl Row {
    /// got/expected − 1.
    pub fn relative_difference(&self) -> Option<f64> {
        let got = self.got.as_ref().ok()?;
        Some(got / self.expected.value - 1.0)
    }

    /// Whether another row, next to this one, is of the same case.
    pub fn is_of_the_case_of(&self, other: &Self) -> bool {
        (&self.case, self.source) == (&other.case, other.source)
    }

    /// What came out with one digit more than was expected, or why nothing did.
    pub fn shown(&self) -> String {
        let decimals = self.expected.decimals + 1;
        match &self.got {
            Ok(got) => format!("{got:.decimals$}"),
            Err(why) => why.clone(),
        }
    }

    /// The relative difference with one digit; below 1e-12 only that, because the last bits depend
    /// on the machine.
    pub fn shown_difference(&self) -> String {
        match self.relative_difference() {
            None => String::new(),
            Some(difference) if difference.abs() < 1e-12 => "<1e-12".into(),
            Some(difference) => format!("{difference:.0e}"),
        }
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

    /// Whether it came out.
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
    /// How many of them do not agree.
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
