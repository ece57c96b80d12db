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
    /// A remark for readers of the values; empty if there is none.
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
            self.verdict().name().to_owned(),
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
            self.verdict().name().to_owned(),
        ]
    }

    /// The result of the comparison. A row counts as a misprint only if the computed value agrees
    /// with the correct value.
    pub fn verdict(&self) -> Verdict {
        let agrees_with = |value: f64| {
            let got = self.got.as_ref();
            got.is_ok_and(|got| (got / value - 1.0).abs() <= self.tolerance)
        };
        match self.expected.misprint {
            _ if agrees_with(self.expected.value) => Verdict::Pass,
            Some(misprint) if agrees_with(misprint.correct) => Verdict::Misprint,
            _ => Verdict::Fail,
        }
    }

    /// Whether the difference from the printed value is within the tolerance.
    pub fn passes(&self) -> bool {
        self.verdict() == Verdict::Pass
    }

    /// The sentence on the misprint of the source, if the row differs for this reason.
    pub fn misprint(&self) -> Option<String> {
        let misprint = self.expected.misprint?;
        let decimals = self.expected.decimals;
        let sentence = format!(
            "{}, {} ({}): printed {:.decimals$}, correct {:.decimals$}; {}",
            self.method,
            self.what,
            self.source,
            self.expected.value,
            misprint.correct,
            misprint.reason
        );
        (self.verdict() == Verdict::Misprint).then_some(sentence)
    }
}

/// The result of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The computed value agrees with the printed one.
    Pass,
    /// It agrees with the correct value of a known misprint, not with the printed one.
    Misprint,
    /// It agrees with neither.
    Fail,
}

impl Verdict {
    /// The text of the verdict in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pass => "PASS",
            Self::Misprint => "MISPRINT",
            Self::Fail => "FAIL",
        }
    }
}

/// All values of the manual that were compared.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Verification {
    /// Number of values compared.
    pub values: usize,
    /// Number of values outside their tolerance, without known misprints.
    pub failures: usize,
    /// Number of values that differ from a known misprint of their source and agree with the
    /// correct value.
    pub misprints: usize,
    /// Every value.
    pub rows: Vec<Row>,
}

impl Verification {
    /// Counts the rows by their verdicts.
    pub fn of(rows: Vec<Row>) -> Self {
        Self {
            values: rows.len(),
            failures: count(&rows, Verdict::Fail),
            misprints: count(&rows, Verdict::Misprint),
            rows,
        }
    }
}

/// Number of rows with this verdict.
fn count(rows: &[Row], verdict: Verdict) -> usize {
    rows.iter().filter(|row| row.verdict() == verdict).count()
}

/// "40 of 43 values are within their tolerance; 3 differ in the last digits from misprints of
/// their sources".
pub fn summary(rows: &[Row]) -> String {
    let passed = count(rows, Verdict::Pass);
    let within = format!(
        "{passed} of {} values are within their tolerance",
        rows.len()
    );
    match count(rows, Verdict::Misprint) {
        0 => within,
        1 => format!("{within}; 1 differs in the last digits from a misprint of its source"),
        misprints => {
            format!(
                "{within}; {misprints} differ in the last digits from misprints of their sources"
            )
        }
    }
}
