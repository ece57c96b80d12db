//! The JSON schemas made from the types of the results.

use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::Value;
use towermodes_analysis::agreement::{Agreement, Examination};
use towermodes_analysis::elastodyn::ShapeValidation;
use towermodes_analysis::study::{Comparison, Convergence};

use super::blade::BladeDocument;
use super::calibration::CalibrationDocument;
use super::campbell::CampbellDocument;
use super::coupled_campbell::CoupledCampbellDocument;
use super::damping::DampingDocument;
use super::design::DesignDocument;
use super::first_order::FirstOrderDocument;
use super::parameters::ParametersDocument;
use super::sensitivities::SensitivitiesDocument;
use super::several::SeveralDocument;
use super::solution::SolutionDocument;
use super::{ResultError, ResultKind, write_result_json};

/// The JSON schema of a result, made from its type: [`ResultKind::json_schema`] must equal it.
///
/// # Errors
/// [`ResultError`] if the schema cannot be written.
pub fn generated_schema(kind: ResultKind) -> Result<String, ResultError> {
    match kind {
        ResultKind::Solution => {
            generated_schema_of::<SolutionDocument<'static>>("towermodes solution", "solve")
        }
        ResultKind::Several => generated_schema_of::<SeveralDocument<'static>>(
            "towermodes solutions of several files",
            "solve FILE FILE",
        ),
        ResultKind::Blade => generated_schema_of::<BladeDocument<'static>>(
            "towermodes blade solution",
            "solve BLADE",
        ),
        ResultKind::Campbell => {
            generated_schema_of::<CampbellDocument<'static>>("towermodes campbell", "campbell")
        }
        ResultKind::CoupledCampbell => generated_schema_of::<CoupledCampbellDocument<'static>>(
            "towermodes campbell of a turbine",
            "campbell TURBINE",
        ),
        ResultKind::Damping => {
            generated_schema_of::<DampingDocument<'static>>("towermodes damping", "damping")
        }
        ResultKind::Parameters => generated_schema_of::<ParametersDocument<'static>>(
            "towermodes parameters",
            "parameters",
        ),
        ResultKind::Sensitivities => generated_schema_of::<SensitivitiesDocument<'static>>(
            "towermodes sensitivities",
            "sensitivities",
        ),
        ResultKind::Design => generated_schema_of::<DesignDocument>("towermodes design", "design"),
        ResultKind::Calibration => {
            generated_schema_of::<CalibrationDocument>("towermodes calibration", "calibrate")
        }
        ResultKind::FirstOrder => generated_schema_of::<FirstOrderDocument>(
            "towermodes sweep to first order",
            "sweep --first-order",
        ),
        ResultKind::Comparison => {
            generated_schema_of::<Comparison>("towermodes comparison", "compare")
        }
        ResultKind::Convergence => {
            generated_schema_of::<Convergence>("towermodes convergence", "converge")
        }
        ResultKind::Agreement => {
            generated_schema_of::<Agreement>("towermodes check", "check FILE OTHER")
        }
        ResultKind::Examination => {
            generated_schema_of::<Examination>("towermodes check of one file", "check FILE")
        }
        ResultKind::ShapeValidation => generated_schema_of::<ShapeValidation>(
            "towermodes elastodyn validate",
            "elastodyn validate",
        ),
    }
}

/// The JSON schema of a type, with a title and the command whose result it describes.
///
/// # Errors
/// [`ResultError`] if the schema cannot be written.
pub fn generated_schema_of<T: JsonSchema>(
    title: &str,
    command: &str,
) -> Result<String, ResultError> {
    let one_line = RecursiveTransform(join_lines);
    let settings = SchemaSettings::default().with_transform(one_line);
    let mut schema = settings.into_generator().into_root_schema_for::<T>();
    let description = format!(
        "The result of `towermodes {command} --format json`. Keys are stable: new keys may be added, existing keys are not renamed."
    );
    schema.insert("title".to_owned(), title.into());
    schema.insert("description".to_owned(), description.into());
    let mut text = Vec::new();
    write_result_json(&schema, &mut text)?;
    Ok(String::from_utf8_lossy(&text).into_owned())
}

/// Joins the lines of a description: in the source they end at column 100.
fn join_lines(schema: &mut Schema) {
    let description = schema.get("description").and_then(Value::as_str);
    if let Some(joined) = description.map(|text| text.replace('\n', " ")) {
        schema.insert("description".to_owned(), joined.into());
    }
}
