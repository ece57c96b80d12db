//! The scatter of frequencies to first order: from derivatives at the means of the distributions,
//! without solving rows.

mod compute;
mod normal;

use thiserror::Error;
use towermodes::number::digits;
use towermodes::{ModeName, NoDerivative, SensitivityError};
use towermodes_files::SamplingError;

/// The scatter of frequencies to first order.
///
/// With inputs of means μ and covariances C, a frequency f(x) with the gradient g at μ has about
/// the mean f(μ) and the variance gᵀ C g. The mean differs from f(μ) by ½ tr(H C) with the second
/// derivatives H, which is of second order in the scatter.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstOrder {
    /// The inputs, in the order of the changes.
    pub inputs: Vec<InputScatter>,
    /// The modes of the sweep.
    pub modes: Vec<ModeScatter>,
}

/// Mean and standard deviation of an input.
#[derive(Debug, Clone, PartialEq)]
pub struct InputScatter {
    /// The name of the change.
    pub name: String,
    /// The unit of its values; empty for a factor.
    pub unit: &'static str,
    /// The mean.
    pub mean: f64,
    /// The standard deviation.
    pub deviation: f64,
}

/// The scatter of a frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeScatter {
    /// The mode.
    pub name: ModeName,
    /// Its scatter, or why there is none.
    pub scatter: Result<Scatter, NoScatter>,
}

/// Mean and standard deviation of a frequency to first order.
#[derive(Debug, Clone, PartialEq)]
pub struct Scatter {
    /// The extrapolated frequency at the means of the inputs, Hz.
    pub mean_hz: f64,
    /// The error of the frequency without extrapolation, Hz.
    pub error_hz: f64,
    /// Standard deviation, Hz.
    pub deviation_hz: f64,
    /// The second-order shift of the mean due to curvature, Hz: Σ ½ (f(μ + l) + f(μ − l)) − f(μ)
    /// over the independent directions l of the inputs. None if such a tower cannot be solved.
    pub mean_shift_hz: Option<f64>,
    /// The derivative with respect to each input, Hz per unit.
    pub hz_per_unit: Vec<f64>,
    /// The share of each input in the variance, gᵢ (C g)ᵢ/(gᵀ C g). The sum is 1. With correlations
    /// a share may be negative, if the input partly cancels the effect of others. Zeros if the
    /// variance is zero.
    pub shares: Vec<f64>,
    /// For each checked multiple of the rotor speed, the probability that the required distance is
    /// violated, with a normal distribution of the frequency.
    pub violated: Vec<f64>,
}

/// If the shift of the mean by curvature is larger than this share of the standard deviation, the
/// first order is not accurate enough: with one normal input the standard deviation is then 4 % too
/// small.
const LARGEST_SHIFT: f64 = 0.2;

impl FirstOrder {
    /// For each mode whose mean is shifted by curvature by more than a fifth of its standard
    /// deviation, a sentence that the first order is not accurate.
    pub fn doubts(&self) -> Vec<String> {
        let doubt = |mode: &ModeScatter| {
            let scatter = mode.scatter.as_ref().ok()?;
            let (shift_hz, deviation_hz) = (scatter.mean_shift_hz?, scatter.deviation_hz);
            if shift_hz.abs() <= LARGEST_SHIFT * deviation_hz {
                return None;
            }
            let compared = match deviation_hz > 0.0 {
                true => format!(
                    ", {} of its standard deviation of {} Hz",
                    percent(shift_hz.abs() / deviation_hz),
                    digits(deviation_hz, 3)
                ),
                false => ", while its standard deviation to first order is 0".to_owned(),
            };
            let shift = digits(shift_hz, 3);
            Some(format!(
                "{}: the curvature moves the mean by {shift} Hz{compared}: the first-order estimate is not reliable; solve rows",
                mode.name
            ))
        };
        self.modes.iter().filter_map(doubt).collect()
    }
}

/// "34 %".
fn percent(share: f64) -> String {
    format!("{} %", digits(100.0 * share, 2))
}

/// Why a frequency has no scatter to first order.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum NoScatter {
    /// The tower at the means does not have the mode.
    #[error("the tower at the mean values has no such mode: {sentence}")]
    NoMode {
        /// The error of the tower, as a sentence.
        sentence: String,
    },
    /// A frequency has no derivative.
    #[error("no derivative with respect to `{change}`: {reason}")]
    NoDerivative {
        /// The change.
        change: String,
        /// The reason.
        reason: NoDerivative,
    },
}

/// Why there is no scatter to first order.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FirstOrderError {
    /// A distribution or a correlation is impossible.
    #[error(transparent)]
    Sampling(#[from] SamplingError),
    /// A grid: its levels have no probabilities.
    #[error(
        "a grid has levels without probabilities; use sampling = \"random\" with distributions"
    )]
    Grid,
    /// The distributions belong to other changes than those of the sweep.
    #[error("the distributions are not those of the changes of the sweep")]
    OtherChanges,
    /// The mean values describe no possible tower, or this tower cannot be solved.
    #[error("the tower at the mean values: {sentence}")]
    Means {
        /// The error, as a sentence.
        sentence: String,
    },
    /// The tower at the means has no derivatives.
    #[error("the tower at the mean values: {0}")]
    Sensitivity(#[from] SensitivityError),
    /// A factor whose mean is 0: its derivative does not follow from the derivatives of the input
    /// values.
    #[error(
        "`{change}` has the mean 0, where a factor has no derivative; vary the input value itself, or use add(…)"
    )]
    ZeroFactor {
        /// The change.
        change: String,
    },
    /// Two changes of different kinds change the same input value.
    #[error(
        "`{first}` and `{second}` change the same input value in different ways, so they have no separate derivatives; solve the rows of the sweep"
    )]
    Overlap {
        /// The first change.
        first: String,
        /// The second change.
        second: String,
    },
}
