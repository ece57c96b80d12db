//! The likely cause of a wrong record: a missing line, a decimal comma, a unit next to the number,
//! an empty value.

use super::parameters::Parameter;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::{Items, Token, decimal_comma};

/// The text that may follow the values of a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum After {
    /// Text; a further number is a mistake.
    Text,
    /// Anything: templates contain more numbers than are read.
    Anything,
}

/// Checks the text after the last value of a record.
pub(super) fn check_rest(
    parameter: &Parameter,
    items: &Items<'_>,
    count: usize,
    after: After,
) -> Result<(), Diagnostic> {
    check_label(parameter, items, 0)?;
    let Some(next) = items.peek().filter(|token| token.is_number()) else {
        return Ok(());
    };
    if items.is_joined_number_next() {
        return Err(decimal_comma(&parameter.what(), next));
    }
    if after == After::Anything {
        return Ok(());
    }
    let found = count + items.numbers_left();
    let what = parameter.what();
    Err(next.wrong(DiagnosticKind::wrong_count(what, found, count)))
}

/// Refuses a record with the name of another parameter; `values` precede the name.
pub(super) fn check_label(
    parameter: &Parameter,
    items: &Items<'_>,
    values: usize,
) -> Result<(), Diagnostic> {
    let Some(label) = items.label_after(values) else {
        return Ok(());
    };
    let Some(other) = parameter.mistaken_for(label.text) else {
        return Ok(());
    };
    let [expected, found] = [parameter, other].map(|p| format!("`{}`", p.name));
    let hint = "is a line missing above, or is there an extra line?";
    Err(label
        .wrong(DiagnosticKind::misplaced(expected, found))
        .with_hint(hint))
}

/// A mistake in a value, with a suggestion as far as the text of the value allows one.
pub(super) fn explained(mistake: Diagnostic, token: &Token<'_>) -> Diagnostic {
    let text = token.text;
    if let Ok(number) = token.number("") {
        return if number.fract() == 0.0 && number.abs() < 1e15 {
            mistake.with_hint(format!("write {number}, without a point or an exponent"))
        } else {
            mistake
        };
    }
    let starts_as_number = text.starts_with(|c: char| c.is_ascii_digit() || c == '.');
    let is_infinite_or_nan = text.parse::<f64>().is_ok_and(|number| !number.is_finite());
    if token.is_quoted {
        mistake.with_hint("write it without quotes")
    } else if starts_as_number && text.ends_with(char::is_alphabetic) {
        mistake.with_hint("leave a blank between a number and its unit")
    } else if text.contains(char::is_alphabetic) && is_infinite_or_nan {
        mistake
    } else if starts_as_number {
        mistake.with_hint("write a number as 350000, 3.5e5 or 3.5d5")
    } else {
        mistake.with_hint("is a line missing above, or is there an extra line?")
    }
}

/// The mistake of two commas without a value between them, before a value.
pub(crate) fn left_out(what: &str, before: &Token<'_>) -> Diagnostic {
    let kind = DiagnosticKind::NoValue {
        what: what.to_owned(),
        reason: "a value is missing between two commas before this",
    };
    before.wrong(kind).with_hint("write each value")
}
