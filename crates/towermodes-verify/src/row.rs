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
