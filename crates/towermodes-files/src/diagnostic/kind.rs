//! The kinds of mistakes in files, with the values that their messages contain.

use std::fmt;

use thiserror::Error;
use towermodes::frame::FrameError;
use towermodes::mooring::MooringError;
use towermodes::turbine::TurbineError;
use towermodes::{ModeNameError, ParameterError, Problem};

use crate::sampling::SamplingError;

/// A problem in a file. `Display` gives the message.
///
/// `what` is the quantity or part of the file as its format names it, for example `NacMass (mass,
/// kg)` or `row 3 of the soil`.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum DiagnosticKind {
    /// The text does not follow the grammar of TOML, YAML or CSV.
    #[error("invalid {format}: {reason}")]
    Syntax {
        /// The grammar.
        format: &'static str,
        /// The reason given by the parser.
        reason: String,
    },
    /// The file has no content.
    #[error("the file is empty")]
    EmptyFile,
    /// The file ends too early.
    #[error("the file ends where {expected} is expected")]
    EndOfFile {
        /// The content that is expected next.
        expected: String,
    },
    /// The file is of another kind than required.
    #[error("this is {found}")]
    WrongFile {
        /// The kind of the file, as a phrase such as `a blade file of ElastoDyn`.
        found: String,
    },
    /// A file that this file names cannot be read.
    #[error("{what} cannot be read: {reason}")]
    UnreadableFile {
        /// The parameter or table that names the file.
        what: String,
        /// The error of the file system.
        reason: String,
    },
    /// A key that the table does not have.
    #[error("`{key}` is not a key of {table}")]
    UnknownKey {
        /// The key.
        key: String,
        /// The table.
        table: String,
    },
    /// A key that has no effect because of another one.
    #[error("`{key}` has no effect {because}")]
    UnusedKey {
        /// The key.
        key: String,
        /// The reason: `beside …` or `without …`.
        because: String,
    },
    /// A key or parameter that must be there.
    #[error("{what} has no `{key}`")]
    MissingKey {
        /// The table or part that lacks it.
        what: String,
        /// The key that must be there.
        key: String,
    },
    /// Something other than a key that must be there.
    #[error("{what} is missing")]
    Missing {
        /// Name of the missing content.
        what: String,
    },
    /// A value of another type.
    #[error("{what} must be {expected}, found {found}")]
    WrongType {
        /// The quantity.
        what: String,
        /// The type that is expected, such as `a number`.
        expected: String,
        /// The content found instead.
        found: String,
    },
    /// A line that belongs at another place.
    #[error("expected {expected} here, found {found}")]
    Misplaced {
        /// Expected content.
        expected: String,
        /// Content of the file.
        found: String,
    },
    /// A number outside its range.
    #[error("{what} is {}, but must be {rule}", value.show(unit))]
    OutOfRange {
        /// The quantity.
        what: String,
        /// Its value.
        value: Exact,
        /// The unit of the value; empty for none.
        unit: &'static str,
        /// The range, such as `positive` or `from 0 to 90`.
        rule: String,
    },
    /// A number that is infinite or NaN.
    #[error("{what} is {value}, not a finite number")]
    NotFinite {
        /// The quantity.
        what: String,
        /// Its value.
        value: Exact,
    },
    /// A product of values that double precision cannot hold.
    #[error("{what} is too large or too small for a double-precision number")]
    Overflow {
        /// The product.
        what: String,
    },
    /// Values that must increase along the file but do not.
    #[error("{what} is not in increasing order: {} follows {}", value.show(unit), previous.show(unit))]
    NotRising {
        /// The quantity.
        what: String,
        /// The value.
        value: Exact,
        /// The value before it.
        previous: Exact,
        /// The unit of both.
        unit: &'static str,
    },
    /// A list or row of the wrong length.
    #[error("{what} has {found} {} instead of {expected}", counted(*.found, .items))]
    WrongCount {
        /// The list, table or row.
        what: String,
        /// The number of its items.
        found: usize,
        /// Its items: `values`, `rows` or `columns`.
        items: &'static str,
        /// The number that is expected, such as `3 or 4`.
        expected: String,
    },
    /// More items than the program can process.
    #[error("{found} {what} are more than the limit of {limit}")]
    TooMany {
        /// The items.
        what: String,
        /// Their number.
        found: usize,
        /// The largest number allowed.
        limit: usize,
    },
    /// Something that may occur only once, or twice for a step.
    #[error("{what} occurs {times} times")]
    Repeated {
        /// Name of the content that occurs too often.
        what: String,
        /// Number of occurrences so far.
        times: usize,
    },
    /// A name that does not occur in the file.
    #[error("there is no {what} `{name}`")]
    UnknownName {
        /// The kind of thing, such as `material`.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// A comma that ends a number, as a decimal comma does in files of Fortran programs.
    #[error("{what}: the number ends at the comma before `{rest}`")]
    Comma {
        /// The quantity.
        what: String,
        /// Content after the comma.
        rest: String,
    },
    /// A value that is omitted between commas or by a `/`: Fortran would use an undefined value.
    #[error("{what} has no value here: {reason}")]
    NoValue {
        /// The quantity.
        what: String,
        /// The reason why it is omitted.
        reason: &'static str,
    },
    /// Values that contradict each other.
    #[error("{0}")]
    Contradiction(String),
    /// Content that the format allows and this program does not model.
    #[error("{0}")]
    Unsupported(String),
    /// A name that is not an input value of the tower, or a name that occurs twice.
    #[error(transparent)]
    Parameter(ParameterError),
    /// A name that is not a mode name.
    #[error(transparent)]
    ModeName(ModeNameError),
    /// A distribution from which no values can be drawn.
    #[error(transparent)]
    Sampling(SamplingError),
    /// A tower that the library refuses.
    #[error(transparent)]
    Tower(Problem),
    /// A turbine that the library refuses.
    #[error(transparent)]
    Turbine(Box<TurbineError>),
    /// A frame that the library refuses.
    #[error(transparent)]
    Frame(Box<FrameError>),
    /// A mooring system that the library refuses.
    #[error(transparent)]
    Mooring(MooringError),
}

/// A number in a message with all digits that it needs, with an exponent if that is shorter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exact(
    /// The number.
    pub f64,
);

impl Exact {
    /// The number with its unit.
    fn show(&self, unit: &str) -> String {
        let gap = if unit.is_empty() { "" } else { " " };
        format!("{self}{gap}{unit}")
    }
}

impl fmt::Display for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        match size == 0.0 || (1e-4..1e12).contains(&size) || !size.is_finite() {
            true => write!(f, "{}", self.0),
            false => write!(f, "{:e}", self.0),
        }
    }
}

impl DiagnosticKind {
    /// [`Self::WrongType`].
    pub(crate) fn wrong_type(
        what: impl Into<String>,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> Self {
        Self::WrongType {
            what: what.into(),
            expected: expected.into(),
            found: found.into(),
        }
    }

    /// [`Self::OutOfRange`] of a number without a unit.
    pub(crate) fn out_of_range(
        what: impl Into<String>,
        value: f64,
        rule: impl Into<String>,
    ) -> Self {
        Self::out_of_range_in(what, value, "", rule)
    }

    /// [`Self::OutOfRange`] of a number in a unit.
    pub(crate) fn out_of_range_in(
        what: impl Into<String>,
        value: f64,
        unit: &'static str,
        rule: impl Into<String>,
    ) -> Self {
        Self::OutOfRange {
            what: what.into(),
            value: Exact(value),
            unit,
            rule: rule.into(),
        }
    }

    /// [`Self::WrongCount`].
    pub(crate) fn wrong_count(
        what: impl Into<String>,
        found: usize,
        expected: impl fmt::Display,
    ) -> Self {
        Self::wrong_count_of("values", what, found, expected)
    }

    /// [`Self::WrongCount`] of other items than values.
    pub(crate) fn wrong_count_of(
        items: &'static str,
        what: impl Into<String>,
        found: usize,
        expected: impl fmt::Display,
    ) -> Self {
        Self::WrongCount {
            what: what.into(),
            found,
            items,
            expected: format!("{expected}"),
        }
    }

    /// [`Self::NotFinite`].
    pub(crate) fn not_finite(what: impl Into<String>, value: f64) -> Self {
        Self::NotFinite {
            what: what.into(),
            value: Exact(value),
        }
    }

    /// [`Self::NotRising`].
    pub(crate) fn not_rising(
        what: impl Into<String>,
        value: f64,
        previous: f64,
        unit: &'static str,
    ) -> Self {
        Self::NotRising {
            what: what.into(),
            value: Exact(value),
            previous: Exact(previous),
            unit,
        }
    }

    /// [`Self::Misplaced`].
    pub(crate) fn misplaced(expected: impl Into<String>, found: impl Into<String>) -> Self {
        Self::Misplaced {
            expected: expected.into(),
            found: found.into(),
        }
    }

    /// [`Self::UnreadableFile`].
    pub(crate) fn unreadable(what: impl Into<String>, reason: &impl fmt::Display) -> Self {
        Self::UnreadableFile {
            what: what.into(),
            reason: reason.to_string(),
        }
    }

    /// [`Self::MissingKey`].
    pub(crate) fn missing_key(what: impl Into<String>, key: impl Into<String>) -> Self {
        Self::MissingKey {
            what: what.into(),
            key: key.into(),
        }
    }
}

/// "value" for one item, "values" for several.
fn counted(count: usize, items: &'static str) -> &'static str {
    match count {
        1 => items.strip_suffix('s').unwrap_or(items),
        _ => items,
    }
}

#[cfg(test)]
mod tests {
    use super::Exact;

    #[test]
    fn numbers_have_all_their_digits() {
        let shown = [350e3, 1.000_000_2, -0.5, 1e300, 2.5e-9].map(|x| Exact(x).to_string());
        assert_eq!(shown, ["350000", "1.0000002", "-0.5", "1e300", "2.5e-9"]);
    }
}
