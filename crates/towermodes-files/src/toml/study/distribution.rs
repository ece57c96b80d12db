//! One entry of `[sweep.vary]`: the distribution of a value.

use std::ops::Range;

use toml::de::DeValue;

use super::super::schema::TableSchema;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, every_row, list, number, whole, wrong_kind};
use super::refuse_keys;
use super::schema::VARY;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::sampling::{Distribution, SamplingError, SamplingKind, Varied};

/// The keys of [`VARY`] that name a distribution; of the other keys, `truncated` belongs to normal
/// and lognormal values, `levels` to grids.
const DISTRIBUTIONS: [&str; 4] = ["uniform", "normal", "lognormal", "values"];

const HINT: &str = "write one of { uniform = [lowest, highest] }, { normal = [mean, deviation] }, { lognormal = [mean, deviation] }, { values = [...] }";

/// The suggestion for a distribution that an earlier version had.
fn gone(key: &str) -> Option<String> {
    let hint = "write { normal = [mean, deviation], truncated = [lowest, highest] }, or the rows as a table (table = \"values.csv\")";
    (key == "triangular").then(|| hint.to_owned())
}

/// A varied input by its name, and its values.
pub(super) fn varied(
    name: &str,
    span: &Range<usize>,
    value: &Value<'_>,
    kind: Option<SamplingKind>,
    reading: &mut Reading,
) -> Option<Varied> {
    if let Some(mistake) = unquoted(name, span, value, &VARY) {
        return reading.refuse(mistake);
    }
    let what = format!("`{name}`");
    if !value.get_ref().is_table() {
        return reading
            .refuse(wrong_kind(value, &what, "a distribution in braces").with_hint(HINT));
    }
    let table = Table::with_elsewhere(value, &what, &VARY, gone, reading)?;
    if table.get("triangular").is_some() {
        return None;
    }
    let found = one_distribution(&table, &what, reading)?;
    let distribution = distribution(&table, found, reading);
    let levels = levels(&table, found, kind, reading)?;
    let distribution = distribution?;
    if let Err(error) = distribution.check() {
        let place = table.get(found).map_or(span.clone(), Value::span);
        return reading.refuse(Diagnostic::new(place, DiagnosticKind::Sampling(error)));
    }
    Some(Varied {
        name: name.to_owned(),
        distribution,
        levels,
    })
}

/// The mistake of a name with dots without quotation marks, which TOML reads as a table in a table:
/// `rna.mass = { ... }`.
pub(in crate::toml) fn unquoted(
    name: &str,
    span: &Range<usize>,
    value: &Value<'_>,
    schema: &TableSchema,
) -> Option<Diagnostic> {
    let mut path = name.to_owned();
    let mut value = value.get_ref();
    while let DeValue::Table(entries) = value {
        let Some((key, inner)) = entries.iter().next() else {
            break;
        };
        if schema.key(key.get_ref()).is_some() || !inner.get_ref().is_table() {
            break;
        }
        path = format!("{path}.{}", key.get_ref());
        value = inner.get_ref();
    }
    (path != name).then(|| {
        let kind = DiagnosticKind::wrong_type(
            format!("the name `{path}`"),
            "in quotation marks",
            "a name without them",
        );
        Diagnostic::new(span.clone(), kind).with_hint(format!("write \"{path}\" = {{ ... }}"))
    })
}

/// The single distribution of an entry.
fn one_distribution(table: &Table<'_>, what: &str, reading: &mut Reading) -> Option<&'static str> {
    let mut given = DISTRIBUTIONS
        .into_iter()
        .filter(|key| table.get(key).is_some());
    match (given.next(), given.next()) {
        (Some(one), None) => Some(one),
        (Some(first), Some(second)) => {
            let because = format!("together with `{first}`");
            table.refuse_unused(second, because, "keep one distribution", reading);
            None
        }
        (None, _) if DISTRIBUTIONS.iter().any(|key| table.has_misspelled(key)) => None,
        (None, _) => {
            let kind = DiagnosticKind::Missing {
                what: format!("the distribution of {what}"),
            };
            reading.refuse(Diagnostic::new(table.span.clone(), kind).with_hint(HINT))
        }
    }
}

fn distribution(
    table: &Table<'_>,
    found: &'static str,
    reading: &mut Reading,
) -> Option<Distribution> {
    if !matches!(found, "normal" | "lognormal") {
        let because = format!("together with `{found}`, whose values are limited");
        refuse_keys(table, &["truncated"], &because, reading);
    }
    let value = table.get(found)?;
    Some(match found {
        "uniform" => {
            let [low, high] = numbers(value, found, reading)?;
            Distribution::Uniform { low, high }
        }
        "values" => Distribution::Values(any_numbers(value, found, reading)?),
        gaussian => {
            let given = numbers(value, gaussian, reading);
            let truncated = truncated(table, reading)?;
            let [mean, deviation] = given?;
            match gaussian {
                "normal" => Distribution::Normal {
                    mean,
                    deviation,
                    truncated,
                },
                _ => Distribution::LogNormal {
                    mean,
                    deviation,
                    truncated,
                },
            }
        }
    })
}

/// The limits of a Gaussian value, if they are given.
fn truncated(table: &Table<'_>, reading: &mut Reading) -> Option<Option<[f64; 2]>> {
    match table.get("truncated") {
        None => Some(None),
        Some(value) => {
            let [low, high] = numbers(value, "truncated", reading)?;
            if low < high {
                return Some(Some([low, high]));
            }
            let kind = DiagnosticKind::Sampling(SamplingError::Range { low, high });
            reading.refuse(
                Diagnostic::new(value.span(), kind).with_hint("truncated = [lowest, highest]"),
            )
        }
    }
}

/// The levels of a grid.
fn levels(
    table: &Table<'_>,
    found: &str,
    kind: Option<SamplingKind>,
    reading: &mut Reading,
) -> Option<Option<u64>> {
    let Some(value) = table.get("levels") else {
        return Some(None);
    };
    let because = match (found, kind) {
        ("uniform", Some(SamplingKind::Grid) | None) => {
            return whole(value, "levels", 2, reading).map(Some);
        }
        ("uniform", Some(_)) => "without sampling = \"grid\"".to_owned(),
        (other, _) => format!("together with `{other}`"),
    };
    refuse_keys(table, &["levels"], &because, reading);
    None
}

/// A list of `N` numbers.
fn numbers<const N: usize>(
    value: &Value<'_>,
    what: &str,
    reading: &mut Reading,
) -> Option<[f64; N]> {
    let found = any_numbers(value, what, reading)?;
    let count = found.len();
    <[f64; N]>::try_from(found).ok().or_else(|| {
        let kind = DiagnosticKind::wrong_count(what, count, N);
        reading.refuse(Diagnostic::new(value.span(), kind).with_hint(HINT))
    })
}

fn any_numbers(value: &Value<'_>, what: &str, reading: &mut Reading) -> Option<Vec<f64>> {
    let values = list(value, what, reading)?;
    every_row(values, |_, entry| number(entry, what, reading))
}
