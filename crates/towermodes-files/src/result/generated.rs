//! The JSON schemas made from the types of the results.

use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::Value;

use super::{ResultError, write_result_json};

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

/// Joins the lines of a description, which end at column 100 in the source.
fn join_lines(schema: &mut Schema) {
    let description = schema.get("description").and_then(Value::as_str);
    if let Some(joined) = description.map(|text| text.replace('\n', " ")) {
        schema.insert("description".to_owned(), joined.into());
    }
}
