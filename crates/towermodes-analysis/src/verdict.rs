//! PASS, WARN or FAIL for a difference and its limit.

/// The verdict on a difference.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Verdict {
    /// At most half of the limit.
    Pass,
    /// Above half of the limit, but within it.
    Warn,
    /// Above the limit.
    Fail,
    /// Not known, because the data are not sufficient.
    Undecided,
}

impl Verdict {
    /// The verdict on a relative difference and its limit. A difference that is NaN fails.
    ///
    /// # Example
    /// ```
    /// use towermodes_analysis::Verdict;
    ///
    /// assert_eq!(Verdict::of(-0.004, 0.01), Verdict::Pass);
    /// assert_eq!(Verdict::of(0.008, 0.01), Verdict::Warn);
    /// ```
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

    /// Whether it is a warning or a failure.
    pub fn is_objection(self) -> bool {
        matches!(self, Self::Warn | Self::Fail)
    }

    /// Its name in results: `pass`, `warn`, `fail`, `undecided`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Warn => "warn",
            Self::Fail => "fail",
            Self::Undecided => "undecided",
        }
    }
}
