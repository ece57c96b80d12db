//! What a difference is worth.

/// What a difference is worth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// No more than half the limit.
    Pass,
    /// Above half the limit, but within it.
    Warn,
    /// Above the limit.
    Fail,
}

impl Verdict {
    /// The verdict on a relative difference; one that is no number fails.
    pub fn of(difference: f64, limit: f64) -> Self {
        let size = difference.abs();
        if size <= 0.5 * limit {
            Self::Pass
        } else if size <= limit {
            Self::Warn
        } else {
            Self::Fail
        }
    }

    /// Its name in results: `pass`, `warn`, `fail`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Warn => "warn",
            Self::Fail => "fail",
        }
    }
}
