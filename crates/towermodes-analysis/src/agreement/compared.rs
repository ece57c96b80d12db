//! One quantity of two towers, how far apart they are, and whether that is little enough.

use crate::verdict::Verdict;

/// How large relative differences may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AgreementLimits {
    /// Of masses, whole and per length, and of the centre of mass as a share of the height.
    pub mass: f64,
    /// Of EI and of what follows from it.
    pub stiffness: f64,
    /// Of frequencies.
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

/// A quantity of two towers.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Compared {
    /// That of the first tower.
    pub first: f64,
    /// That of the second.
    pub second: f64,
    /// second/first − 1, or (second − first)/scale for what can be zero; infinite (in JSON
    /// null) where only the first is zero.
    #[cfg_attr(feature = "schema", schemars(with = "Option<f64>"))]
    pub difference: f64,
    /// What the difference is worth.
    pub verdict: Verdict,
}

impl Compared {
    /// Two values by their ratio.
    pub(super) fn ratio(first: f64, second: f64, limit: f64) -> Self {
        Self::on_scale(first, second, first, limit)
    }

    /// Two values by their difference as a share of a scale.
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
