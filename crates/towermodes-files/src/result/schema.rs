//! The JSON schemas of the results.

use std::io::Write;

use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::Value;
use towermodes_analysis::agreement::{Agreement, Examination};
use towermodes_analysis::elastodyn::ShapeValidation;
use towermodes_analysis::study::{Comparison, Convergence};

use super::blade::BladeDocument;
use super::campbell::CampbellDocument;
use super::solution::SolutionDocument;
use super::{ResultError, write_result_json};

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
    ShapeValidation,
}

/// Writes the JSON schema of a result, indented, with a newline at the end.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_json_schema(kind: ResultKind, writer: impl Write) -> Result<(), ResultError> {
    use ResultKind as Of;
    match kind {
        Of::Solution => {
            write_schema_of::<SolutionDocument<'static>>("towermodes solution", "solve", writer)
        }
        Of::Blade => write_schema_of::<BladeDocument<'static>>(
            "towermodes blade solution",
            "solve BLADE",
            writer,
        ),
        Of::Campbell => {
            write_schema_of::<CampbellDocument<'static>>("towermodes campbell", "campbell", writer)
        }
        Of::Comparison => write_schema_of::<Comparison>("towermodes comparison", "compare", writer),
        Of::Convergence => {
            write_schema_of::<Convergence>("towermodes convergence", "converge", writer)
        }
        Of::Agreement => {
            write_schema_of::<Agreement>("towermodes check", "check FILE OTHER", writer)
        }
        Of::Examination => {
            write_schema_of::<Examination>("towermodes check of one file", "check FILE", writer)
        }
        Of::ShapeValidation => write_schema_of::<ShapeValidation>(
            "towermodes elastodyn validate",
            "elastodyn validate",
            writer,
        ),
    }
}

/// Writes the JSON schema of a type with a title and the command whose result it describes.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_schema_of<T: JsonSchema>(
    title: &str,
    command: &str,
    writer: impl Write,
) -> Result<(), ResultError> {
    let one_line = RecursiveTransform(join_lines);
    let settings = SchemaSettings::default().with_transform(one_line);
    let mut schema = settings.into_generator().into_root_schema_for::<T>();
    let description = format!(
        "The result of `towermodes {command} --format json`. Keys are stable: new ones may be added, none is renamed."
    );
    schema.insert("title".to_owned(), title.into());
    schema.insert("description".to_owned(), description.into());
    write_result_json(&schema, writer)
}

/// Joins the lines of a description: in the source they end at column 100.
fn join_lines(schema: &mut Schema) {
    let description = schema.get("description").and_then(Value::as_str);
    if let Some(joined) = description.map(|text| text.replace('\n', " ")) {
        schema.insert("description".to_owned(), joined.into());
    }
}
