//! The result of a calibration as JSON.

use std::io::Write;

use serde::Serialize;

use super::{ResultError, write_result_json};

/// The result of a calibration, ready to be written.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CalibrationDocument {
    /// The name of the tower; may be empty.
    pub tower: String,
    /// The fitted input values.
    pub numbers: Vec<FittedNumber>,
    /// The correlations of the fitted values in their order, from -1 to 1; null for a value at a
    /// bound.
    pub correlations: Vec<Vec<Option<f64>>>,
    /// The measured frequencies and the frequencies of the tower, in the order of the file.
    pub measured: Vec<FittedFrequency>,
    /// Combinations of the input values, and how well the measurements without priors determine
    /// them; the best determined combination first.
    pub directions: Vec<FittedDirection>,
    /// Sum of the squared residuals of measurements and priors, in standard deviations.
    pub chi_square: f64,
    /// Number of measurements and priors minus the number of fitted values that are not at a bound.
    pub degrees_of_freedom: usize,
    /// Number of iterations.
    pub iterations: usize,
    /// Whether the measurements are assigned to the same modes before and after the fit.
    pub is_pairing_stable: bool,
    /// Whether the certificate of the fitted tower proves that no mode is missing.
    pub certified: bool,
    /// Remarks in words: inputs that the measurements determine or do not determine, and doubts
    /// about the fit.
    pub remarks: Vec<String>,
    /// Warnings and notes of the reader.
    pub warnings: Vec<String>,
}

/// A fitted input value.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FittedNumber {
    /// Its name.
    pub name: String,
    /// Its unit; empty for none.
    pub unit: &'static str,
    /// Value on the original tower; null if the variable sets several input values that differ on
    /// the original tower.
    pub before: Option<f64>,
    /// Its fitted value.
    pub value: f64,
    /// Standard deviation of the value; null at a bound.
    pub deviation: Option<f64>,
    /// The values one standard deviation below and above: 68 % of the probability is between them;
    /// null at a bound.
    pub interval: Option<[f64; 2]>,
    /// Whether its logarithm was fitted, as for every positive input value.
    pub is_logarithm: bool,
    /// Mean and standard deviation of its prior; null without a prior.
    pub prior: Option<[f64; 2]>,
    /// The residual of its prior in standard deviations; null without a prior.
    pub prior_residual: Option<f64>,
    /// The bound that it has reached, `lower` or `upper`; null for none.
    pub at_bound: Option<&'static str>,
    /// The measurements and priors that mainly determine it, with their shares of its variance;
    /// empty at a bound.
    pub decided_by: Vec<FittedShare>,
}

/// The contribution of one measurement or prior to the variance of a fitted value.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FittedShare {
    /// The measured mode, or the input value to which the prior applies.
    pub name: String,
    /// Whether it is a prior.
    pub is_prior: bool,
    /// Its share; the sum of all is 1.
    pub share: f64,
}

/// A measured frequency and the frequency of the tower.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FittedFrequency {
    /// The name of the mode.
    pub mode: String,
    /// Another mode that may have been measured; null if no other mode matches.
    pub or_mode: Option<String>,
    /// Measured frequency, Hz.
    pub measured_hz: f64,
    /// Its standard deviation, Hz.
    pub deviation_hz: f64,
    /// Frequency of the original tower, Hz.
    pub before_hz: f64,
    /// Frequency of the fitted tower, Hz.
    pub fitted_hz: f64,
    /// Fitted minus measured frequency, in standard deviations.
    pub residual: f64,
    /// The share of the type of motion that its name states in the energy of the mode of the fitted
    /// tower.
    pub share: f64,
}

/// A combination of the fitted input values.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FittedDirection {
    /// Number of standard deviations by which the measurements change together if the values change
    /// by these parts: a singular value of the weighted Jacobian.
    pub singular_value: f64,
    /// The change of each fitted value, as a vector of length 1: change of the logarithm for
    /// positive values (0.1 is about 10 %), in the unit of `scales` for other values.
    pub parts: Vec<f64>,
    /// The unit of each change in the unit of the input value; 1 for a logarithm.
    pub scales: Vec<f64>,
}

/// Writes the result of a calibration as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_calibration_json(
    document: &CalibrationDocument,
    writer: impl Write,
) -> Result<(), ResultError> {
    write_result_json(document, writer)
}
