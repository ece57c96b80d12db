//! A parameter of a file: its name, meaning and range.

/// Largest number of rows: real tables have tens of rows, and a malicious file must not use up the
/// memory.
pub(super) const MAX_ROWS: usize = 100_000;

/// A parameter of a file: a row of the tables that are used for reading, writing and messages.
#[derive(Debug, Clone, Copy)]
pub(super) struct Record {
    /// Its name on the line.
    pub(super) name: &'static str,
    /// Its meaning, with its unit.
    pub(super) meaning: &'static str,
    pub(super) kind: Kind,
}

/// The type of a parameter and the range of its values.
#[derive(Debug, Clone, Copy)]
pub(super) enum Kind {
    /// True or false, the name of a file, or a value that is not read.
    Other,
    /// A whole number from this one to [`MAX_ROWS`].
    Count(usize),
    /// A number in a range, and the range as text.
    Number(fn(f64) -> bool, &'static str),
}

pub(super) const ANY: Kind = Kind::Number(|_| true, "a number");
pub(super) const POSITIVE: Kind = Kind::Number(|value| value > 0.0, "greater than 0");
pub(super) const NON_NEGATIVE: Kind = Kind::Number(|value| value >= 0.0, "non-negative");
/// An angle of less than a right angle, degrees.
pub(super) const ACUTE: Kind =
    Kind::Number(|angle| angle.abs() < 90.0, "between -90 and 90 degrees");
/// An angle of at most half a turn, degrees.
pub(super) const HALF_TURN: Kind =
    Kind::Number(|angle| angle.abs() <= 180.0, "from -180 to 180 degrees");
/// A damping ratio, percent of critical.
pub(super) const PERCENT: Kind = Kind::Number(
    |value| (0.0..=100.0).contains(&value),
    "from 0 to 100 percent",
);

/// A row of a table of parameters.
pub(super) const fn record(name: &'static str, meaning: &'static str, kind: Kind) -> Record {
    Record {
        name,
        meaning,
        kind,
    }
}

impl Record {
    /// Whether a number is in the range, and the range as text.
    pub(super) fn check(&self, value: f64) -> (bool, &'static str) {
        match self.kind {
            Kind::Number(is_met, rule) => (is_met(value), rule),
            _ => (true, ""),
        }
    }

    /// Its name in messages.
    pub(super) fn label(&self) -> String {
        let meaning = self.meaning.trim_start_matches([' ', ',']);
        format!("{} ({meaning})", self.name)
    }
}
