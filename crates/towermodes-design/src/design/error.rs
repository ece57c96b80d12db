//! Why there is no design.

use thiserror::Error;
use towermodes::number::Plain;
use towermodes::{ModeName, NoDerivative, SensitivityError, SolveError, TowerError};

use super::unmet::Infeasible;

/// Bounds may be this many times as large as the present value; larger bounds indicate a wrong
/// unit.
pub(super) const WIDEST: f64 = 1e3;

/// Why there is no design.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum DesignError {
    /// There are no design variables.
    #[error("the design has no variables")]
    NoVariables,
    /// The design was cancelled.
    #[error("the design was cancelled")]
    GivenUp,
    /// There are no frequency bands.
    #[error("the design has no goal for a frequency")]
    NoGoals,
    /// Bounds that are not finite, or a lower bound above the upper bound.
    #[error("the bounds of `{variable}` are {low} and {high}, but the first must be lower")]
    Bounds {
        /// The name of the variable.
        variable: String,
        /// The lower bound.
        low: f64,
        /// The upper bound.
        high: f64,
    },
    /// A factor that is not positive.
    #[error("the lower bound of the factor `{variable}` is {low}, but must be positive")]
    Factor {
        /// The name of the variable.
        variable: String,
        /// The lower bound.
        low: f64,
    },
    /// An input value that is always positive has a bound that is not positive.
    #[error("the lower bound of `{variable}` is {low}, but this input value must be positive")]
    NotPositive {
        /// The name of the variable.
        variable: String,
        /// The lower bound.
        low: f64,
    },
    /// Bounds so far from the present value that the search would fail.
    #[error(
        "the bounds of `{variable}` are {} and {}, but its present value is {}: bounds may be up to {WIDEST} times the present value; check the unit (lengths are in m)",
        Plain(*.low), Plain(*.high), Plain(*.present)
    )]
    Wide {
        /// The name of the variable.
        variable: String,
        /// The lower bound.
        low: f64,
        /// The upper bound.
        high: f64,
        /// The largest input value that the variable changes, or 1 for a factor.
        present: f64,
    },
    /// No value of a stepped variable is within its bounds.
    #[error("no multiple of the step {step} of `{variable}` is between {low} and {high}")]
    NoStep {
        /// The name of the variable.
        variable: String,
        /// The step.
        step: f64,
        /// The lower bound.
        low: f64,
        /// The upper bound.
        high: f64,
    },
    /// Two variables change one input value.
    #[error("`{first}` and `{second}` both change {parameter}; remove one of them")]
    Twice {
        /// The name of the input value.
        parameter: String,
        /// The name of the first variable.
        first: String,
        /// The name of the second variable.
        second: String,
    },
    /// A band of frequencies is empty.
    #[error("the band of {mode} is {min_hz} to {max_hz} Hz, but the first must be lower")]
    Band {
        /// The mode.
        mode: ModeName,
        /// Its lowest frequency, Hz.
        min_hz: f64,
        /// Its highest frequency, Hz.
        max_hz: f64,
    },
    /// A limit of the shape is not positive, or its lower value is above its upper value.
    #[error("the limit {what} is {low} to {high}, but must be positive, the first lower")]
    Limit {
        /// Name of the limit.
        what: &'static str,
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
    /// The mode is not among the lowest modes of the tower.
    #[error("the tower has no mode {mode} among its {modes} lowest modes")]
    NoMode {
        /// The mode.
        mode: ModeName,
        /// Number of computed modes.
        modes: usize,
    },
    /// A frequency has no derivative.
    #[error("the frequency of {mode} has no derivative with respect to `{variable}`: {reason}")]
    NoDerivative {
        /// The mode.
        mode: ModeName,
        /// The variable.
        variable: String,
        /// The reason.
        reason: NoDerivative,
    },
    /// The derivatives cannot be computed.
    #[error(transparent)]
    Sensitivity(#[from] SensitivityError),
    /// The tower that was found cannot be solved.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// The tower that was found is impossible.
    #[error(transparent)]
    Tower(#[from] TowerError),
    /// No tower is possible where the search begins.
    #[error(
        "no tower is possible at the present values, in the middle or at the ends of the bounds: {0}; check the bounds of the variables (lengths are in m)"
    )]
    NoStart(Box<DesignError>),
    /// No tower was found within the bounds that meets the goals.
    #[error("{0}")]
    Infeasible(Box<Infeasible>),
    /// A tower that meets all limits exists, but none with stepped values was found.
    #[error(
        "a tower of {:.1} t meets all limits, but no tower with values in steps that meets them was found: use smaller steps or wider bounds",
        kg / 1e3
    )]
    NoCombination {
        /// Mass of the tower without stepped values, kg.
        kg: f64,
    },
}

impl DesignError {
    /// The name of the variable that the error is about; none if the error is not about one
    /// variable.
    pub fn variable(&self) -> Option<&str> {
        match self {
            Self::Bounds { variable, .. }
            | Self::Factor { variable, .. }
            | Self::NotPositive { variable, .. }
            | Self::Wide { variable, .. }
            | Self::NoStep { variable, .. }
            | Self::Twice {
                second: variable, ..
            }
            | Self::NoDerivative { variable, .. } => Some(variable),
            _ => None,
        }
    }

    /// The mode of the goal that the error is about; none if the error is not about one goal.
    pub fn mode(&self) -> Option<ModeName> {
        match self {
            Self::Band { mode, .. } | Self::NoMode { mode, .. } => Some(*mode),
            _ => None,
        }
    }
}
