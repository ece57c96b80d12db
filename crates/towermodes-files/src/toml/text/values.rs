//! Numbers, texts and lists, with their mistakes.

use serde_spanned::Spanned;
use toml::de::{DeArray, DeValue};
use towermodes::MAX_SEGMENTS;

use super::reading::Reading;
use super::syntax::without_marks;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// A TOML value and its place.
pub(crate) type Value<'a> = Spanned<DeValue<'a>>;

/// A finite number.
pub(crate) fn number(value: &Value<'_>, what: &str, reading: &mut Reading) -> Option<f64> {
    let parsed = match value.get_ref() {
        DeValue::Float(float) => float.as_str().parse().ok(),
        DeValue::Integer(integer) => integer_value(integer.as_str(), integer.radix()),
        other => {
            let diagnostic = wrong_kind(value, what, "a number");
            let hint = other.as_str().and_then(|text| without_marks(text, what));
            return reading.refuse(match hint {
                Some(hint) => diagnostic.with_hint(hint),
                None => diagnostic,
            });
        }
    };
    let finite = parsed.filter(|number: &f64| number.is_finite());
    if finite.is_none() {
        let kind = DiagnosticKind::not_finite(what, parsed.unwrap_or(f64::INFINITY));
        reading.mistake(Diagnostic::new(value.span(), kind));
    }
    finite
}

/// The largest integer up to which all integers are exact in double precision.
const MOST: f64 = 9_007_199_254_740_992.0;

/// A whole number.
pub(crate) fn whole(
    value: &Value<'_>,
    what: &str,
    least: u64,
    reading: &mut Reading,
) -> Option<u64> {
    let found = number(value, what, reading)?;
    if found.fract() == 0.0 && (least as f64..=MOST).contains(&found) {
        return Some(found as u64);
    }
    let rule = format!("a whole number, at least {least}");
    let kind = DiagnosticKind::out_of_range(what, found, rule);
    reading.refuse(Diagnostic::new(value.span(), kind))
}

/// A finite number, or infinity if it is written as such.
pub(crate) fn number_or_infinity(
    value: &Value<'_>,
    what: &str,
    reading: &mut Reading,
) -> Option<f64> {
    infinity(value).or_else(|| number(value, what, reading))
}

/// Infinity as the word `inf`, not as a number that is too large.
pub(crate) fn infinity(value: &Value<'_>) -> Option<f64> {
    let DeValue::Float(float) = value.get_ref() else {
        return None;
    };
    match float.as_str() {
        "inf" | "+inf" => Some(f64::INFINITY),
        "-inf" => Some(f64::NEG_INFINITY),
        _ => None,
    }
}

fn integer_value(digits: &str, radix: u32) -> Option<f64> {
    match radix {
        10 => digits.parse().ok(),
        _ => i128::from_str_radix(digits, radix)
            .ok()
            .map(|integer| integer as f64),
    }
}

/// `true` or `false`.
pub(crate) fn truth(value: &Value<'_>, what: &str, reading: &mut Reading) -> Option<bool> {
    let truth = value.get_ref().as_bool();
    truth.or_else(|| reading.refuse(wrong_kind(value, what, "true or false")))
}

/// A text.
pub(crate) fn text<'a>(value: &'a Value<'_>, what: &str, reading: &mut Reading) -> Option<&'a str> {
    let text = value.get_ref().as_str();
    text.or_else(|| reading.refuse(wrong_kind(value, what, "a text in quotation marks")))
}

/// A list.
pub(crate) fn list<'a>(
    value: &'a Value<'a>,
    what: &str,
    reading: &mut Reading,
) -> Option<&'a DeArray<'a>> {
    let list = value.get_ref().as_array();
    list.or_else(|| reading.refuse(wrong_kind(value, what, "a list in brackets")))
}

/// The values of a row; `expected` gives the expected number of values, if a number is wrong.
pub(crate) fn row_of<'a>(
    row: &'a Value<'a>,
    what: &str,
    hint: &str,
    expected: impl Fn(usize) -> Option<String>,
    reading: &mut Reading,
) -> Option<&'a DeArray<'a>> {
    let Some(values) = row.get_ref().as_array() else {
        return reading.refuse(wrong_kind(row, what, "a list in brackets").with_hint(hint));
    };
    match expected(values.len()) {
        None => Some(values),
        Some(expected) => {
            let kind = DiagnosticKind::wrong_count(what, values.len(), expected);
            reading.refuse(Diagnostic::new(row.span(), kind).with_hint(hint))
        }
    }
}

/// Refuses heights with more pieces between them than a tower can have segments.
pub(crate) fn check_pieces(
    value: &Value<'_>,
    heights_m: impl Iterator<Item = f64>,
    reading: &mut Reading,
) -> Option<()> {
    let mut below_m = f64::INFINITY;
    let is_piece = |height_m: f64| std::mem::replace(&mut below_m, height_m) < height_m;
    let pieces = heights_m.map(is_piece).filter(|is_piece| *is_piece).count();
    if pieces <= MAX_SEGMENTS {
        return Some(());
    }
    let kind = DiagnosticKind::TooMany {
        what: "pieces between the heights".to_owned(),
        found: pieces,
        limit: MAX_SEGMENTS,
    };
    let start = value.span().start;
    let mistake = Diagnostic::new(start..start + 1, kind);
    reading.refuse(mistake.with_hint("keep every second row, or fewer"))
}

/// Every row of a list, made by `read` from its index and value; continues after a mistake, so that
/// all mistakes are reported together.
pub(crate) fn every_row<'a, T>(
    rows: &'a DeArray<'a>,
    mut read: impl FnMut(usize, &'a Value<'a>) -> Option<T>,
) -> Option<Vec<T>> {
    let read: Vec<Option<T>> = rows
        .iter()
        .enumerate()
        .map(|(index, row)| read(index, row))
        .collect();
    read.into_iter().collect()
}

/// The mistake of a value of another type than expected.
pub(crate) fn wrong_kind(value: &Value<'_>, what: &str, expected: &str) -> Diagnostic {
    let kind = DiagnosticKind::wrong_type(what, expected, kind(value.get_ref()));
    Diagnostic::new(value.span(), kind)
}

/// The name of the type of a value.
fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
