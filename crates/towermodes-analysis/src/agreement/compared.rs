//! One quantity of two towers: the difference and its verdict.

use crate::verdict::Verdict;

/// The largest permitted relative differences.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AgreementLimits {
    /// For mass, mass per length, and the centre of mass as a fraction of the height.
    pub mass: f64,
    /// For bending stiffness and flexibility.
    pub stiffness: f64,
    /// For frequencies.
    pub frequency: f64,
}

impl Default for AgreementLimits {
    /// Mass 0.5 %, EI 1 %, frequencies 0.5 %.
    fn default() -> Self {
        Self {
            mass: 0.005,
            stiffness: 0.01,
            frequency: 0.005,
        }
    }
}

/// A quantity of two towers with the difference and its verdict.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Compared {
    /// The value of the first tower.
    pub first: f64,
    /// The value of the second tower.
    pub second: f64,
    /// second/first − 1, or (second − first)/scale for values that can be zero; infinite (in JSON
    /// null) if only the first is zero.
    #[cfg_attr(feature = "schema", schemars(with = "Option<f64>"))]
    pub difference: f64,
    /// The verdict on the difference.
    pub verdict: Verdict,
}

impl Compared {
    /// Compares two values by their ratio.
    pub(super) fn ratio(first: f64, second: f64, limit: f64) -> Self {
        Self::on_scale(first, second, first, limit)
    }

    /// Compares two values by their difference as a fraction of a scale.
    pub(super) fn on_scale(first: f64, second: f64, scale: f64, limit: f64) -> Self {
        let difference = if first == second {
            0.0
        } else {
            (second - first) / scale
        };
        Self {
            first,
            second,
            difference,
            verdict: Verdict::of(difference, limit),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Compared, Verdict};

    #[test]
    fn a_warning_begins_above_half_the_limit() {
        let verdict = |second| Compared::ratio(200.0, second, 0.01).verdict;
        assert_eq!(verdict(200.9), Verdict::Pass);
        assert_eq!(verdict(198.9), Verdict::Warn);
        assert_eq!(verdict(202.1), Verdict::Fail);
        assert_eq!(verdict(f64::NAN), Verdict::Fail);
        assert_eq!(Compared::ratio(0.0, 1.0, 0.01).verdict, Verdict::Fail);
        assert_eq!(Compared::ratio(0.0, 0.0, 0.01).verdict, Verdict::Pass);
        assert!(Verdict::Fail > Verdict::Warn && Verdict::Warn > Verdict::Pass);
    }
}
