//! The influence of the input values of a tower on its frequencies as JSON and CSV.

use std::io::Write;

use serde::Serialize;
use towermodes::TowerDescription;
use towermodes_analysis::influence::{
    Basis, Influence, InfluencedMode, Influences, Tolerance, Tolerances,
};

use super::{ResultError, write_records_csv, write_result_json};
use crate::diagnostic::Exact;
use crate::input::TowerInput;

/// The result of `towermodes sensitivities`.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct SensitivitiesDocument<'a> {
    /// The name of the tower in the file; may be empty.
    tower: &'a str,
    #[serde(flatten)]
    influences: InfluencesJson<'a>,
    /// Assumptions of the reader and data that it omits.
    warnings: Vec<String>,
}

/// The influence of the input values of a tower on its frequencies.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct InfluencesJson<'a> {
    /// The lowest modes by frequency. Every row of the tower is a segment boundary here, so
    /// frequencies may differ from those of a solution within their errors.
    modes: Vec<ModeJson<'a>>,
    /// The input values, in the order of the tower file.
    numbers: Vec<NumberJson<'a>>,
}

/// A mode.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct ModeJson<'a> {
    /// Order and family in words.
    label: &'a str,
    /// Its frequency, extrapolated, Hz.
    frequency_hz: f64,
    /// The combined effect of all tolerances, Hz: the root of the sum of squares; null without
    /// tolerances.
    tolerances_hz: Option<f64>,
}

/// An input value of the tower, or a change of several input values.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct NumberJson<'a> {
    /// The name: the address in the tower file, with indices from 0.
    name: &'a str,
    /// The value on the unchanged tower: the input value, 1 for a factor, 0 for an addition.
    value: f64,
    /// Its unit; empty for a number without a unit.
    unit: &'static str,
    /// The reference of the percentage.
    percent_of: Basis,
    /// Derivative of the mass of the tower and of the members of a substructure with respect to the
    /// value, kg per unit; null if the tower cannot be changed in both directions.
    mass_kg_per_unit: Option<f64>,
    /// The effect of the input value on each mode, in the order of the modes.
    modes: Vec<InfluenceJson>,
}

/// The effect of an input value on a mode.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct InfluenceJson {
    /// Derivative of the extrapolated frequency, Hz per unit; null if there is none.
    hz_per_unit: Option<f64>,
    /// Estimate of its error, Hz per unit; null if there is no derivative.
    error_hz_per_unit: Option<f64>,
    /// Percent of the frequency per percent of the input value; null for an input value of zero.
    percent_per_percent: Option<f64>,
    /// The effect of the tolerance of the input value, Hz; null without a tolerance.
    tolerance_hz: Option<f64>,
    /// Why there is no derivative; null if there is one.
    no_derivative: Option<String>,
}

/// The influence of one input value on one mode.
fn influence(number: &Influence, mode: usize, tolerance: Option<Tolerance>) -> InfluenceJson {
    let derivative = &number.derivatives[mode];
    let known = derivative.as_ref().ok();
    InfluenceJson {
        hz_per_unit: known.map(|derivative| derivative.hz_per_unit),
        error_hz_per_unit: known.map(|derivative| derivative.error_hz_per_unit),
        percent_per_percent: number.elasticities[mode],
        tolerance_hz: tolerance.and_then(|tolerance| number.effect_hz(tolerance, mode)),
        no_derivative: derivative.as_ref().err().map(ToString::to_string),
    }
}

impl<'a> InfluencesJson<'a> {
    /// The influences for the tower of an input.
    pub(super) fn of(
        description: &TowerDescription,
        influences: &'a Influences,
        tolerances: &Tolerances,
    ) -> Self {
        let mode = |(index, mode): (usize, &'a InfluencedMode)| ModeJson {
            label: &mode.label,
            frequency_hz: mode.frequency_hz,
            tolerances_hz: (!tolerances.is_empty())
                .then(|| tolerances.together_hz(influences, description, index)),
        };
        let number = |number: &'a Influence| {
            let tolerance = tolerances.of(&number.name, description);
            let modes = 0..influences.modes.len();
            NumberJson {
                name: &number.name,
                value: number.value,
                unit: number.unit,
                percent_of: number.basis,
                mass_kg_per_unit: Some(number.mass_kg_per_unit).filter(|mass| mass.is_finite()),
                modes: modes
                    .map(|mode| influence(number, mode, tolerance))
                    .collect(),
            }
        };
        Self {
            modes: influences.modes.iter().enumerate().map(mode).collect(),
            numbers: influences.numbers.iter().map(number).collect(),
        }
    }
}

/// Writes influences as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_sensitivities_json(
    input: &TowerInput,
    influences: &Influences,
    tolerances: &Tolerances,
    writer: impl Write,
) -> Result<(), ResultError> {
    let document = SensitivitiesDocument {
        tower: &input.description.name,
        influences: InfluencesJson::of(&input.description, influences, tolerances),
        warnings: input.notes.iter().map(ToString::to_string).collect(),
    };
    write_result_json(&document, writer)
}

/// Writes influences as CSV with a header, a line per input value and mode.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_sensitivities_csv(
    input: &TowerInput,
    influences: &Influences,
    tolerances: &Tolerances,
    writer: impl Write,
) -> Result<(), ResultError> {
    let exact = |value: Option<f64>| value.map_or(String::new(), |value| Exact(value).to_string());
    let records = influences.numbers.iter().flat_map(|number| {
        let tolerance = tolerances.of(&number.name, &input.description);
        let modes = influences.modes.iter().enumerate();
        modes.map(move |(index, mode)| {
            let of_mode = influence(number, index, tolerance);
            [
                number.name.clone(),
                exact(Some(number.value)),
                number.unit.to_owned(),
                mode.label.clone(),
                exact(Some(mode.frequency_hz)),
                exact(of_mode.hz_per_unit),
                exact(of_mode.error_hz_per_unit),
                exact(of_mode.percent_per_percent),
                exact(of_mode.tolerance_hz),
            ]
        })
    });
    let header = [
        "name",
        "value",
        "unit",
        "mode",
        "frequency_hz",
        "hz_per_unit",
        "error_hz_per_unit",
        "percent_per_percent",
        "tolerance_hz",
    ];
    write_records_csv(header, records, writer)
}
