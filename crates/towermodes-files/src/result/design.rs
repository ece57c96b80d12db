//! The result of a design as JSON.

use std::io::Write;

use serde::Serialize;

use super::{ResultError, write_result_json};

/// The result of a design, ready to be written.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DesignDocument {
    /// The name of the tower; may be empty.
    pub tower: String,
    /// The design variables.
    pub variables: Vec<DesignedVariable>,
    /// Mass of the original tower with outfitting and point masses, without RNA, and of the members
    /// of a substructure, kg.
    pub mass_before_kg: f64,
    /// Mass of the tower found, kg.
    pub mass_kg: f64,
    /// Mass of the minimum without steps, kg; null if no variable has steps.
    pub mass_without_steps_kg: Option<f64>,
    /// The frequency bands.
    pub frequencies: Vec<DesignedFrequency>,
    /// The active limits, which prevent a lighter tower.
    pub active: Vec<DesignedLimit>,
    /// The residual of the conditions of a minimum (Karush, Kuhn, Tucker) of the problem without
    /// steps, relative.
    pub kkt_residual: f64,
    /// Whether the residual is zero except for rounding: the problem without steps meets the
    /// first-order conditions of a local minimum.
    pub is_stationary: bool,
    /// Whether no lighter tower was found among the changes by one step and the exchanges of two
    /// steps for which the derivatives predict a lighter tower; null if no variable has steps.
    pub steps_are_searched: Option<bool>,
    /// Whether the certificate of the tower found proves that no mode is missing.
    pub certified: bool,
    /// Number of solved towers.
    pub solves: usize,
    /// Warnings and notes of the reader.
    pub warnings: Vec<String>,
}

/// A design variable with the value found.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DesignedVariable {
    /// Its name.
    pub name: String,
    /// Its unit; empty for none.
    pub unit: &'static str,
    /// Its value on the original tower.
    pub before: f64,
    /// Whether this value is the mean of different input values.
    pub before_is_mean: bool,
    /// Its value on the tower found.
    pub after: f64,
    /// Its lowest value.
    pub lowest: f64,
    /// Its highest value.
    pub highest: f64,
}

/// A frequency goal of the design.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DesignedFrequency {
    /// The name of the mode.
    pub mode: String,
    /// Lowest frequency, Hz; null for none.
    pub min_hz: Option<f64>,
    /// Highest frequency, Hz; null for none.
    pub max_hz: Option<f64>,
    /// Frequency of the original tower, Hz; null if it has no such mode.
    pub before_hz: Option<f64>,
    /// Extrapolated frequency of the tower found, Hz.
    pub after_hz: f64,
    /// Estimated error of the frequency without extrapolation, Hz.
    pub error_hz: f64,
    /// The share of the type of motion that its name states in the energy of the mode.
    pub share: f64,
    /// If the mode has less than 60 % of its energy in the type of motion that its name states:
    /// the other modes with at least a quarter of this motion, to which the limits also apply.
    pub others: Vec<DesignedOther>,
}

/// Another mode to which the limits on a frequency apply.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DesignedOther {
    /// The name of this mode.
    pub mode: String,
    /// Its extrapolated frequency, Hz.
    pub hz: f64,
    /// The share of its energy in the type of motion that the name of the limited mode states.
    pub share: f64,
}

/// An active limit, which prevents a lighter tower.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DesignedLimit {
    /// The limit as text.
    pub limit: String,
    /// Decrease of the mass per unit by which the limit is relaxed, kg per unit.
    pub kg_per_unit: f64,
    /// Change of the mass per percent of the limit, kg; null for a limit of 0.
    pub kg_per_percent: Option<f64>,
}

/// Writes the result of a design as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_design_json(document: &DesignDocument, writer: impl Write) -> Result<(), ResultError> {
    write_result_json(document, writer)
}
