//! The frequency at which the added mass of a floating platform is evaluated.

use std::fmt;

use super::super::error::SolveError;
use crate::number::Plain;

/// The frequency at which the frequency-dependent added mass of a floating platform is taken.
///
/// # Example
/// ```
/// use towermodes::{AddedMassAt, Options};
///
/// // As in a linearization by OpenFAST.
/// let options = Options { added_mass: AddedMassAt::Infinite, ..Options::default() };
/// assert_ne!(options, Options::default());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum AddedMassAt {
    /// The added mass of each mode at its own frequency.
    #[default]
    Own,
    /// The added mass at infinite frequency, as in a linearization by OpenFAST.
    Infinite,
    /// The added mass at frequency zero.
    Zero,
    /// The added mass at this frequency, Hz.
    Hz(f64),
}

impl AddedMassAt {
    /// Reads `own`, `infinite`, `zero` or a frequency in Hz; none for any other text.
    ///
    /// # Example
    /// ```
    /// use towermodes::AddedMassAt;
    ///
    /// assert_eq!(AddedMassAt::named("zero"), Some(AddedMassAt::Zero));
    /// assert_eq!(AddedMassAt::named("0.5"), Some(AddedMassAt::Hz(0.5)));
    /// assert_eq!(AddedMassAt::named("inf"), Some(AddedMassAt::Infinite));
    /// assert_eq!(AddedMassAt::named("-1"), None);
    /// ```
    pub fn named(text: &str) -> Option<Self> {
        match text {
            "own" => Some(Self::Own),
            "infinite" | "inf" => Some(Self::Infinite),
            "zero" => Some(Self::Zero),
            number => {
                let own = Self::Hz(number.parse().ok()?);
                own.check().is_ok().then_some(own)
            }
        }
    }

    /// The angular frequency, rad/s, if it is the same for all modes.
    pub(crate) fn fixed(self) -> Option<f64> {
        match self {
            Self::Own => None,
            Self::Infinite => Some(f64::INFINITY),
            Self::Zero => Some(0.0),
            Self::Hz(hz) => Some(hz * std::f64::consts::TAU),
        }
    }

    /// Refuses a frequency that is negative or not finite.
    pub(super) fn check(self) -> Result<(), SolveError> {
        match self {
            Self::Hz(hz) if !(hz >= 0.0 && hz.is_finite()) => Err(SolveError::AddedMassAt { hz }),
            Self::Own | Self::Infinite | Self::Zero | Self::Hz(_) => Ok(()),
        }
    }
}

impl fmt::Display for AddedMassAt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Own => f.write_str("own"),
            Self::Infinite => f.write_str("infinite"),
            Self::Zero => f.write_str("zero"),
            Self::Hz(hz) => write!(f, "{}", Plain(*hz)),
        }
    }
}
