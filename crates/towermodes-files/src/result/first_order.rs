//! The scatter of frequencies to first order as JSON.

use std::io::Write;

use serde::Serialize;

use super::{ResultError, write_result_json};

/// The result of `towermodes sweep --first-order`, ready to be written.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FirstOrderDocument {
    /// The name of the tower; may be empty.
    pub tower: String,
    /// The varied input values.
    pub inputs: Vec<ScatteredInput>,
    /// Their correlations.
    pub correlations: Vec<CorrelatedInputs>,
    /// The required distance |n Ω/f − 1| of an excitation; null without the rotor speed.
    pub margin: Option<f64>,
    /// The modes.
    pub modes: Vec<ScatteredMode>,
    /// Warnings and notes of the reader.
    pub warnings: Vec<String>,
}

/// A varied input value.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ScatteredInput {
    /// Its name.
    pub name: String,
    /// Its unit; empty for a factor.
    pub unit: String,
    /// Mean of its distribution.
    pub mean: f64,
    /// Standard deviation of its distribution.
    pub deviation: f64,
}

/// The correlation of two varied input values.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CorrelatedInputs {
    /// Their names.
    pub between: [String; 2],
    /// The correlation coefficient of the normal scores.
    pub coefficient: f64,
}

/// The standard deviation of the frequency of a mode.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ScatteredMode {
    /// The mode by family and order: `fore-aft 1`.
    pub mode: String,
    /// Order and family in words.
    pub label: String,
    /// Extrapolated frequency at the mean values of the inputs, Hz; null if there is no first-order
    /// result.
    pub mean_hz: Option<f64>,
    /// Its error without extrapolation, Hz.
    pub error_hz: Option<f64>,
    /// Standard deviation, Hz.
    pub deviation_hz: Option<f64>,
    /// The difference of the mean by curvature, to second order, Hz; null if not known.
    pub mean_shift_hz: Option<f64>,
    /// The effect of each input, in the order of the inputs; empty if there is no first-order
    /// result.
    pub inputs: Vec<InputEffect>,
    /// The probabilities of violated margins; empty without the rotor speed.
    pub margins: Vec<MarginProbability>,
    /// Why there is no first-order result; null if there is one.
    pub no_scatter: Option<String>,
}

/// The effect of an input on a frequency.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct InputEffect {
    /// The derivative of the frequency, Hz per unit of the input.
    pub hz_per_unit: f64,
    /// Its share in the variance. The sum is 1; with correlations a share may be negative.
    pub share: f64,
}

/// The probability that an excitation is closer than the margin.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MarginProbability {
    /// The multiple n of the rotor speed.
    pub multiple: usize,
    /// The probability, with a normal distribution of the frequency.
    pub probability: f64,
}

/// Writes a scatter to first order as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_first_order_json(
    document: &FirstOrderDocument,
    writer: impl Write,
) -> Result<(), ResultError> {
    write_result_json(document, writer)
}
