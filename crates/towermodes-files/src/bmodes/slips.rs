//! Slips that show on a line: it is another than is expected, a decimal comma, a unit at its
//! number, a value left out.

use std::ops::Range;

use super::list::{Items, is_number};
use super::quantity::Quantity;
use super::reader::After;
use crate::diagnostic::Diagnostic;
use crate::records::Token;

/// What may stand on a record after the last of its values.
pub(super) fn check_rest(
    quantity: &Quantity,
    items: &Items<'_>,
    count: usize,
    after: After,
) -> Result<(), Diagnostic> {
    check_label(quantity, items, 0)?;
    let Some(next) = items.peek().filter(|token| is_number(token)) else {
        return Ok(());
    };
    if items.is_joined_number_next() {
        let message = format!(
            "a comma ends {} before `{}`",
            quantity.what(),
            short(next.text)
        );
        let hint = "write a decimal point, as 3.5, and a blank between values";
        return Err(Diagnostic::new(next.span.clone(), message).with_hint(hint));
    }
    if after == After::Anything {
        return Ok(());
    }
    let message = format!(
        "{} has {count} numbers here, but {} more stand on the line",
        quantity.what(),
        items.numbers_left()
    );
    Err(Diagnostic::new(next.span.clone(), message))
}

/// Refuses a record that says it is another quantity; `values` stand before its name.
pub(super) fn check_label(
    quantity: &Quantity,
    items: &Items<'_>,
    values: usize,
) -> Result<(), Diagnostic> {
    let Some(label) = items.label_after(values) else {
        return Ok(());
    };
    let Some(other) = quantity.mistaken_for(label.text) else {
        return Ok(());
    };
    let message = format!(
        "`{}` is expected here, but the line says it is `{}`",
        quantity.name, other.name
    );
    let hint = "is a line missing above, or one too many?";
    Err(Diagnostic::new(label.span.clone(), message).with_hint(hint))
}

/// A mistake with what would be right, judged by what stands there.
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
    if token.is_quoted {
        mistake.with_hint("write it without quotes")
    } else if starts_as_number && text.ends_with(char::is_alphabetic) {
        mistake.with_hint("leave a blank between a number and its unit")
    } else if text.contains(char::is_alphabetic) && is_not_finite(text) {
        mistake
    } else if starts_as_number {
        mistake.with_hint("numbers are written as 350000, 3.5e5 or 3.5d5")
    } else {
        mistake.with_hint("is a line missing above, or one too many?")
    }
}

fn is_not_finite(text: &str) -> bool {
    text.parse::<f64>().is_ok_and(|number| !number.is_finite())
}

/// The mistake of a value between two commas with nothing in it.
pub(super) fn left_out(what: &str, span: Range<usize>) -> Diagnostic {
    let message = format!("{what} is left out: nothing stands between two commas before this");
    Diagnostic::new(span, message).with_hint("write each value")
}

/// The beginning of a text, for messages.
pub(super) fn short(text: &str) -> String {
    text.chars().take(40).collect()
}
