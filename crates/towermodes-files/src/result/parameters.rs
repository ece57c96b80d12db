//! The input values of a tower by name as JSON and CSV.

use std::io::Write;

use serde::Serialize;
use towermodes::Parameter;

use super::{ResultError, write_records_csv, write_result_json};
use crate::diagnostic::Exact;
use crate::input::TowerInput;

/// The result of `towermodes parameters`.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct ParametersDocument<'a> {
    /// The name of the tower in the file; may be empty.
    tower: &'a str,
    /// The input values, in the order of the tower file.
    parameters: Vec<ParameterJson<'a>>,
    /// Assumptions of the reader and data that it omits.
    warnings: Vec<String>,
}

/// An input value of a tower.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct ParameterJson<'a> {
    /// Its name: the address in the tower file, with indices from 0.
    name: String,
    /// Its value; null if it is infinite (rigid).
    value: f64,
    /// Its unit; empty for a number without a unit.
    unit: &'static str,
    /// Its meaning.
    meaning: &'static str,
    /// The file that contains it; null if no file does.
    file: Option<&'a str>,
    /// Its line in that file, from 1.
    line: Option<usize>,
}

/// Writes input values of a tower as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_parameters_json(
    input: &TowerInput,
    parameters: &[Parameter],
    writer: impl Write,
) -> Result<(), ResultError> {
    let document = ParametersDocument {
        tower: &input.description.name,
        parameters: parameters.iter().map(|one| json(input, *one)).collect(),
        warnings: input.notes.iter().map(ToString::to_string).collect(),
    };
    write_result_json(&document, writer)
}

fn json(input: &TowerInput, parameter: Parameter) -> ParameterJson<'_> {
    let (file, line) = input.line_of(parameter.place()).unzip();
    ParameterJson {
        name: parameter.to_string(),
        value: parameter.value(&input.description),
        unit: parameter.unit(),
        meaning: parameter.meaning(),
        file,
        line,
    }
}

/// Writes input values of a tower as CSV with a header, a line per input value.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_parameters_csv(
    input: &TowerInput,
    parameters: &[Parameter],
    writer: impl Write,
) -> Result<(), ResultError> {
    let records = parameters.iter().map(|parameter| {
        let one = json(input, *parameter);
        [
            one.name,
            Exact(one.value).to_string(),
            one.unit.to_owned(),
            one.meaning.to_owned(),
            one.file.unwrap_or_default().to_owned(),
            one.line.map_or_else(String::new, |line| line.to_string()),
        ]
    });
    let header = ["name", "value", "unit", "meaning", "file", "line"];
    write_records_csv(header, records, writer)
}
