//! Numbers, texts and lists, with their mistakes.

use serde_spanned::Spanned;
use toml::de::{DeArray, DeValue};

use super::Reading;
use super::table::kind;
use crate::diagnostic::Diagnostic;

/// A TOML value and its place.
pub(super) type Value<'a> = Spanned<DeValue<'a>>;

/// A finite number.
pub(super) fn number(value: &Value<'_>, what: &str, reading: &mut Reading) -> Option<f64> {
    let parsed = match value.get_ref() {
        DeValue::Float(float) => float.as_str().parse().ok(),
        DeValue::Integer(integer) => integer_value(integer.as_str(), integer.radix()),
        other => {
            let message = format!("{what} must be a number, not {}", kind(other));
            let diagnostic = Diagnostic::new(value.span(), message);
            let is_quoted =
                matches!(other, DeValue::String(text) if text.trim().parse::<f64>().is_ok());
            reading.mistake(if is_quoted {
                diagnostic.with_hint("write the number without quotation marks")
            } else {
                diagnostic
            });
            return None;
        }
    };
    let finite = parsed.filter(|number: &f64| number.is_finite());
    if finite.is_none() {
        let message = match parsed {
            Some(number) if number.is_nan() => format!("{what} is nan, not a finite number"),
            _ => format!("{what} is infinite or too large for a number"),
        };
        reading.mistake(Diagnostic::new(value.span(), message));
    }
    finite
}

fn integer_value(digits: &str, radix: u32) -> Option<f64> {
    match radix {
        10 => digits.parse().ok(),
        _ => i128::from_str_radix(digits, radix)
            .ok()
            .map(|integer| integer as f64),
    }
}

/// A text.
pub(super) fn text<'a>(value: &'a Value<'_>, what: &str, reading: &mut Reading) -> Option<&'a str> {
    match value.get_ref() {
        DeValue::String(text) => Some(text),
        other => {
            let message = format!(
                "{what} must be a text in quotation marks, not {}",
                kind(other)
            );
            reading.mistake(Diagnostic::new(value.span(), message));
            None
        }
    }
}

/// A list.
pub(super) fn list<'a>(
    value: &'a Value<'a>,
    what: &str,
    reading: &mut Reading,
) -> Option<&'a DeArray<'a>> {
    match value.get_ref() {
        DeValue::Array(list) => Some(list),
        other => {
            let message = format!("{what} must be a list in brackets, not {}", kind(other));
            reading.mistake(Diagnostic::new(value.span(), message));
            None
        }
    }
}
