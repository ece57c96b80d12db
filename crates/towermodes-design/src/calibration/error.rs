//! Why there is no fit.

use thiserror::Error;
use towermodes::number::{Plain, Rounded, digits};
use towermodes::{ModeName, NoDerivative, SensitivityError, SolveError, TowerError};

/// The smallest accepted standard deviation, relative to the measured frequency or the mean: far
/// below the accuracy of any instrument, and above the errors of computed frequencies.
const LEAST_DEVIATION: f64 = 1e-9;
/// The largest accepted standard deviation, relative to the measured frequency or the mean; a value
/// with a larger one is unknown.
const MOST_DEVIATION: f64 = 1e6;

/// Whether the ratio of a standard deviation to a value is within these limits.
pub(super) fn is_in_proportion(deviation: f64, of: f64) -> bool {
    (LEAST_DEVIATION..=MOST_DEVIATION).contains(&(deviation / of).abs())
}

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum CalibrationError {
    /// No input values are to be fitted.
    #[error("no unknowns are given; name at least one input value of the tower")]
    NoUnknowns,
    /// Too few measurements for the unknowns.
    #[error(
        "{unknowns} unknowns cannot be found from {} and {}; measure more modes, fit fewer unknowns, or give an unknown a prior, such as `{beyond}`",
        counted(*.measured, "measurement"), counted(*.priors, "prior")
    )]
    TooFewMeasurements {
        /// The first unknown without a prior for which there is no measurement.
        beyond: String,
        /// The number of measurements.
        measured: usize,
        /// The number of unknowns with a prior.
        priors: usize,
        /// The number of unknowns.
        unknowns: usize,
    },
    /// A frequency or a standard deviation is not positive.
    #[error("the {what} of measurement {} is {}; it must be positive", .index + 1, Plain(*.value))]
    NotPositive {
        /// The measurement, from 0.
        index: usize,
        /// The name of the wrong value.
        what: &'static str,
        /// The wrong value.
        value: f64,
    },
    /// A standard deviation outside the accepted range relative to the frequency.
    #[error(
        "the standard deviation of measurement {} is {} Hz, {} times its frequency of {} Hz; it must be between {LEAST_DEVIATION:e} and {MOST_DEVIATION:e} times the frequency",
        .index + 1, Plain(*.deviation_hz), times(*.deviation_hz, *.frequency_hz), Plain(*.frequency_hz)
    )]
    DeviationRange {
        /// The measurement, from 0.
        index: usize,
        /// The standard deviation, Hz.
        deviation_hz: f64,
        /// The frequency, Hz.
        frequency_hz: f64,
    },
    /// Two measurements are of one mode.
    #[error(
        "measurements {} and {} are both of {mode}; give one frequency for each mode; combine several measurements of a mode into their weighted mean, with the standard deviation of this mean",
        .first + 1, .index + 1
    )]
    Repeated {
        /// The first, from 0.
        first: usize,
        /// The second, from 0.
        index: usize,
        /// Their mode.
        mode: ModeName,
    },
    /// A shape has no displacements, or not one for each height.
    #[error(
        "the shape of measurement {} must have one finite displacement for each height, not all zero",
        .index + 1
    )]
    Shape {
        /// The measurement, from 0.
        index: usize,
    },
    /// A sensor is not on the tower.
    #[error(
        "the shape of measurement {} has a sensor at {} m, but the tower extends from {} to {} m",
        .index + 1, Plain(*.height_m), Plain(*.base_m), Plain(*.top_m)
    )]
    SensorOutside {
        /// The measurement, from 0.
        index: usize,
        /// The height of the sensor, m.
        height_m: f64,
        /// The height of the tower base, m.
        base_m: f64,
        /// The height of the tower top, m.
        top_m: f64,
    },
    /// A lower bound that is not below the upper bound.
    #[error("the bounds of `{change}` are {} and {}; the lower must be below the upper", Plain(*.low), Plain(*.high))]
    Bounds {
        /// The unknown.
        change: String,
        /// The lower bound.
        low: f64,
        /// The upper bound.
        high: f64,
    },
    /// A prior without a positive deviation.
    #[error(
        "the prior of `{change}` has mean {} and standard deviation {}; both must be finite and the deviation positive",
        Plain(*.mean), Plain(*.deviation)
    )]
    Prior {
        /// The unknown.
        change: String,
        /// The mean.
        mean: f64,
        /// The deviation.
        deviation: f64,
    },
    /// A prior with an impossible mean.
    #[error(
        "the prior mean of `{change}` is {}, but this input value cannot be {}; give a positive mean",
        Plain(*.mean), if *.mean < 0.0 { "negative" } else { "0" }
    )]
    PriorNotPositive {
        /// The unknown.
        change: String,
        /// The mean.
        mean: f64,
    },
    /// A prior whose standard deviation is outside the accepted range relative to its mean.
    #[error(
        "the prior of `{change}` has a standard deviation of {}, {} times its mean {}; it must be between {LEAST_DEVIATION:e} and {MOST_DEVIATION:e} times the mean",
        Plain(*.deviation), times(*.deviation, *.mean), Plain(*.mean)
    )]
    PriorRange {
        /// The unknown.
        change: String,
        /// The mean.
        mean: f64,
        /// The deviation.
        deviation: f64,
    },
    /// Bounds of a positive input value that contain no positive value.
    #[error("the upper bound of `{change}` is {}, but this input value must be positive", Plain(*.high))]
    BoundsNotPositive {
        /// The unknown.
        change: String,
        /// The upper bound.
        high: f64,
    },
    /// A prior whose mean is outside the bounds.
    #[error(
        "the prior mean {} of `{change}` is outside the bounds {} and {}",
        Plain(*.mean), Plain(*.low), Plain(*.high)
    )]
    PriorOutside {
        /// The unknown.
        change: String,
        /// The mean.
        mean: f64,
        /// The lower bound.
        low: f64,
        /// The upper bound.
        high: f64,
    },
    /// Two unknowns change the same input value.
    #[error(
        "`{change}` changes {parameter}, which another unknown already changes; remove one of them"
    )]
    Overlap {
        /// The second unknown.
        change: String,
        /// The name of the input value.
        parameter: String,
    },
    /// An unknown has no finite value to start from.
    #[error("`{change}` has no value to start from: the tower has {found}; {remedy}")]
    NoStart {
        /// The unknown.
        change: String,
        /// The values of the tower.
        found: String,
        /// Suggestion.
        remedy: &'static str,
    },
    /// The tower is not solved or has no derivatives.
    #[error(transparent)]
    Sensitivity(#[from] SensitivityError),
    /// The tower is impossible.
    #[error(transparent)]
    Tower(#[from] TowerError),
    /// The modes for the pairing are not computed.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// The mode is not among the computed lowest modes of the tower.
    #[error(
        "measurement {} is of the mode {mode}, which is not among the {computed} lowest modes of the tower; the lowest are {there}",
        .index + 1
    )]
    NoMode {
        /// The measurement, from 0.
        index: usize,
        /// The mode.
        mode: ModeName,
        /// Number of computed modes.
        computed: usize,
        /// The names of the lowest modes.
        there: String,
    },
    /// A frequency has no derivative with respect to an unknown.
    #[error("{mode} has no derivative with respect to `{change}`: {reason}; remove one of the two")]
    NoDerivative {
        /// The mode.
        mode: ModeName,
        /// The unknown.
        change: String,
        /// The reason.
        reason: NoDerivative,
    },
    /// The measurements and priors do not determine the unknowns.
    #[error(
        "the measurements do not determine {}; give {} a prior, do not fit it, or measure other modes",
        .names.join(" and "), if .names.len() == 1 { "it" } else { "one of these" }
    )]
    Undetermined {
        /// The unknowns, in backquotes.
        names: Vec<String>,
    },
    /// Unknowns without a prior with which no measured frequency changes to first order.
    #[error(
        "{} not change any measured frequency{} (at {values}); give {} a prior, do not fit it, or measure other modes",
        match &names[..] { [one] => format!("{one} does"), all => format!("{} do", all.join(" and ")) },
        if *.is_stationary { " to first order" } else { "" },
        if .names.len() == 1 { "it" } else { "each of these" }
    )]
    NoEffect {
        /// The unknowns, in backquotes.
        names: Vec<String>,
        /// Whether a larger change of one of them moves a measured frequency.
        is_stationary: bool,
        /// All unknowns with their values there.
        values: String,
    },
    /// Unknowns that are 0, with which no measured frequency changes to first order, and for which
    /// neither prior nor bounds give a size.
    #[error(
        "no measured frequency changes with {} to first order (at {values}), and nothing says how large {} may be; give {} bounds or a prior",
        .names.join(" and "),
        if .names.len() == 1 { "it" } else { "they" },
        if .names.len() == 1 { "it" } else { "each of these" }
    )]
    NoSize {
        /// The unknowns, in backquotes.
        names: Vec<String>,
        /// All unknowns with their values there.
        values: String,
    },
    /// No values of the unknowns give a measured frequency, not even the largest and the smallest.
    #[error(
        "no value of the fitted inputs gives the measured frequency of {mode}, {} Hz; the nearest frequency is {} Hz with {values}; check the measurement and its mode, or fit other inputs",
        Plain(*.measured_hz), Rounded(*.nearest_hz)
    )]
    Unreachable {
        /// The measurement, from 0.
        index: usize,
        /// Its mode.
        mode: ModeName,
        /// Its frequency, Hz.
        measured_hz: f64,
        /// The nearest frequency, Hz.
        nearest_hz: f64,
        /// The unknowns with their values there.
        values: String,
    },
    /// Every unknown that could bring a frequency nearer to its measured value is at a bound.
    #[error(
        "no values within the bounds give the measured frequency of {mode}, {} Hz; the nearest frequency is {} Hz, limited by {bounds}; widen the bounds, check the measurement and its mode, or fit other inputs",
        Plain(*.measured_hz), Rounded(*.nearest_hz)
    )]
    OutsideBounds {
        /// The measurement, from 0.
        index: usize,
        /// Its mode.
        mode: ModeName,
        /// Its frequency, Hz.
        measured_hz: f64,
        /// The nearest frequency, Hz.
        nearest_hz: f64,
        /// The bounds in words.
        bounds: String,
    },
    /// The fit ends where a measured mode and another one exchange their names: the frequency with
    /// this name jumps there, and no tower has the frequencies between.
    #[error(
        "{mode} cannot be fitted to {} Hz: with {values} {mode} and {other} are coupled in two modes, which exchange their names, and the frequency of {mode} jumps between {} Hz and {} Hz; if {} Hz is the frequency of the other mode of the two, name {other}, or give the measured shape in place of a name",
        Plain(*.measured_hz), Rounded(.jump_hz[0]), Rounded(.jump_hz[1]), Plain(*.measured_hz)
    )]
    Exchanged {
        /// The measurement, from 0.
        index: usize,
        /// Its mode.
        mode: ModeName,
        /// The mode with which it exchanges its name.
        other: ModeName,
        /// Its frequency, Hz.
        measured_hz: f64,
        /// The frequency of the mode where the fit ends, and its frequency after the exchange of
        /// names, Hz.
        jump_hz: [f64; 2],
        /// The unknowns with their values there.
        values: String,
    },
    /// The iteration has not converged.
    #[error(
        "the fit has not converged in {iterations} iterations; its last values are {values}; give bounds, or priors near the expected values"
    )]
    NotConverged {
        /// The number of iterations.
        iterations: usize,
        /// The unknowns with their last values.
        values: String,
    },
}

impl CalibrationError {
    /// The measurement that the error is about, from 0; none if the error is not about one
    /// measurement.
    pub fn measurement(&self) -> Option<usize> {
        match self {
            Self::NotPositive { index, .. }
            | Self::DeviationRange { index, .. }
            | Self::Repeated { index, .. }
            | Self::Shape { index }
            | Self::SensorOutside { index, .. }
            | Self::Unreachable { index, .. }
            | Self::OutsideBounds { index, .. }
            | Self::Exchanged { index, .. }
            | Self::NoMode { index, .. } => Some(*index),
            _ => None,
        }
    }

    /// The name of the unknown that the error is about; none if the error is not about one unknown.
    pub fn unknown(&self) -> Option<&str> {
        match self {
            Self::Bounds { change, .. }
            | Self::Prior { change, .. }
            | Self::PriorNotPositive { change, .. }
            | Self::PriorRange { change, .. }
            | Self::BoundsNotPositive { change, .. }
            | Self::TooFewMeasurements { beyond: change, .. }
            | Self::PriorOutside { change, .. }
            | Self::Overlap { change, .. }
            | Self::NoStart { change, .. }
            | Self::NoDerivative { change, .. } => Some(change),
            _ => None,
        }
    }

    /// Whether the problem contradicts itself or its tower; otherwise the computation failed.
    pub fn is_usage(&self) -> bool {
        let is_computed = matches!(
            self,
            Self::Sensitivity(_)
                | Self::Tower(_)
                | Self::Solve(_)
                | Self::NoDerivative { .. }
                | Self::Undetermined { .. }
                | Self::NoEffect { .. }
                | Self::NoSize { .. }
                | Self::Unreachable { .. }
                | Self::OutsideBounds { .. }
                | Self::Exchanged { .. }
                | Self::NotConverged { .. }
        );
        !is_computed
    }
}

/// The ratio of the absolute values of two numbers, with two digits.
fn times(number: f64, of: f64) -> String {
    let ratio = (number / of).abs();
    match ratio {
        1e-3..1e3 => digits(ratio, 2),
        _ => format!("{ratio:.0e}"),
    }
}

/// "1 prior", "2 priors".
fn counted(count: usize, noun: &str) -> String {
    match count {
        1 => format!("1 {noun}"),
        _ => format!("{count} {noun}s"),
    }
}
