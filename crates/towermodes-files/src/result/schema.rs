//! The JSON schemas of the results.

use std::io::Write;

use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::Value;

use super::agreement::{AgreementJson, ExaminationJson};
use super::blade::BladeSolutionJson;
use super::campbell::CampbellJson;
use super::comparison::ComparisonJson;
use super::convergence::ConvergenceJson;
use super::judgement::JudgementsJson;
use super::solution_json::SolutionJson;
use super::verification::VerificationJson;
use super::{ResultError, write_pretty};

/// A result that is written as JSON.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ResultKind {
    /// Of `towermodes solve`.
    Solution,
    /// Of `towermodes solve` for a rotating blade.
    Blade,
    /// Of `towermodes campbell`.
    Campbell,
    /// Of `towermodes compare`.
    Comparison,
    /// Of `towermodes converge`.
    Convergence,
    /// Of `towermodes check` for two descriptions.
    Agreement,
    /// Of `towermodes check` for one description.
    Examination,
    /// Of `towermodes elastodyn validate`.
    Judgement,
    /// Of `towermodes verify`.
    Verification,
}

/// Writes the JSON schema of a result, indented, with a newline at the end.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_json_schema(kind: ResultKind, writer: impl Write) -> Result<(), ResultError> {
    match kind {
        ResultKind::Solution => write_schema_of::<SolutionJson<'static>>(writer),
        ResultKind::Blade => write_schema_of::<BladeSolutionJson<'static>>(writer),
        ResultKind::Campbell => write_schema_of::<CampbellJson<'static>>(writer),
        ResultKind::Comparison => write_schema_of::<ComparisonJson>(writer),
        ResultKind::Convergence => write_schema_of::<ConvergenceJson>(writer),
        ResultKind::Agreement => write_schema_of::<AgreementJson>(writer),
        ResultKind::Examination => write_schema_of::<ExaminationJson>(writer),
        ResultKind::Judgement => write_schema_of::<JudgementsJson>(writer),
        ResultKind::Verification => write_schema_of::<VerificationJson<'static>>(writer),
    }
}

fn write_schema_of<T: JsonSchema>(writer: impl Write) -> Result<(), ResultError> {
    let one_line = RecursiveTransform(join_lines);
    let settings = SchemaSettings::default().with_transform(one_line);
    write_pretty(
        &settings.into_generator().into_root_schema_for::<T>(),
        writer,
    )
}

/// Joins the lines of a description: in the source they end at column 100.
fn join_lines(schema: &mut Schema) {
    let description = schema.get("description").and_then(Value::as_str);
    if let Some(joined) = description.map(|text| text.replace('\n', " ")) {
        schema.insert("description".to_owned(), joined.into());
    }
}
