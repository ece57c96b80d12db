//! The JSON schemas of the results.

use std::io::Write;

use schemars::{JsonSchema, schema_for};

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
    write_pretty(&schema_for!(T), writer)
}
