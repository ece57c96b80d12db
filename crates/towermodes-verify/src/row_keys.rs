//! The keys of a row of the manual in serialized results.

use serde::{Serialize, Serializer};

use crate::row::Row;

/// A reference value and the computed value.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(remote = "Row")]
struct RowKeys {
    /// The chapter of the manual, by its name on the command line.
    #[serde(getter = "chapter")]
    chapter: &'static str,
    /// The tower or beam.
    case: String,
    /// The source of the expected value.
    source: &'static str,
    /// A remark for readers of the values, for example on omitted digits of the source; empty if
    /// there is none.
    remark: &'static str,
    /// The method with its segments.
    method: String,
    /// The quantity of the value, for example "bending 2".
    #[serde(rename = "mode")]
    what: String,
    /// `Hz`, `kg`, `N/m` and the like, or `1` for dimensionless values.
    unit: &'static str,
    /// The expected value.
    #[serde(getter = "expected")]
    expected: f64,
    /// The computed value; null if there is none.
    #[serde(getter = "got")]
    got: Option<f64>,
    /// got/expected − 1; null if there is no computed value.
    #[serde(getter = "Row::relative_difference")]
    relative_difference: Option<f64>,
    /// The largest permitted relative difference.
    tolerance: f64,
    /// Whether the difference is within the tolerance.
    #[serde(getter = "Row::passes")]
    passes: bool,
    /// Why the printed value is known to be wrong; null if the value passes or fails.
    #[serde(getter = "Row::misprint")]
    misprint: Option<String>,
}

fn chapter(row: &Row) -> &'static str {
    row.chapter.name
}

fn expected(row: &Row) -> f64 {
    row.expected.value
}

fn got(row: &Row) -> Option<f64> {
    row.got.as_ref().ok().copied()
}

impl Serialize for Row {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        RowKeys::serialize(self, serializer)
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Row {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Row".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        RowKeys::json_schema(generator)
    }
}
