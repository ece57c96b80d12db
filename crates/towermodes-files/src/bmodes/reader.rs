//! Reads a deck record by record, each value with its place, and notices early when lines are
//! missing or too many.

use std::ops::Range;

use super::list::{Items, is_number};
use super::quantity::Quantity;
use super::slips::{check_label, check_rest, explained, left_out, short};
use crate::diagnostic::Diagnostic;
use crate::records::{Line, Lines, Token};

/// A value and the bytes of its file that it takes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Value<T> {
    pub(super) value: T,
    pub(super) span: Range<usize>,
}

impl<T> Value<T> {
    /// A mistake about this value.
    pub(super) fn wrong(&self, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(self.span.clone(), message)
    }
}

/// What a file's numbers are followed by on their record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum After {
    /// Text; a further number is one too many.
    Text,
    /// Anything: templates keep more numbers than are read.
    Anything,
}

/// How a value is read from a token.
type Read<T> = fn(&Token<'_>, &str) -> Result<T, Diagnostic>;

/// What is left of a file.
#[derive(Debug, Clone)]
pub(super) struct Reader<'a> {
    pub(super) lines: Lines<'a>,
}

impl<'a> Reader<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        let lines = Lines::new(text);
        Self { lines }
    }

    /// A record that is read and dropped; one that carries a value of the deck is none.
    pub(super) fn comment(&mut self, what: &str) -> Result<Line<'a>, Diagnostic> {
        let line = self.lines.expect(what)?;
        let mut items = Items::new(line);
        let Ok(Some(item)) = items.next_item() else {
            return Ok(line);
        };
        let first = item.token;
        if !is_value(&first) {
            return Ok(line);
        }
        let has_two = item.repeats > 1 || items.peek().is_some_and(is_number);
        let gives = if is_number(&first) && has_two {
            "numbers".to_owned()
        } else {
            let label = items.label_after(0);
            let Some(quantity) = label.and_then(|label| Quantity::called(label.text)) else {
                return Ok(line);
            };
            format!("`{}`", quantity.name)
        };
        let message = format!("{what} is expected here, but the line gives {gives}");
        Err(Diagnostic::new(first.span, message).with_hint("is a line missing above?"))
    }

    /// Whether the next record has a value of the deck: one with its name, several numbers, or
    /// nothing but a number.
    pub(super) fn value_follows(&self) -> bool {
        let is_lone_number = |line: Line<'a>| {
            let mut tokens = line.tokens();
            tokens.next().is_some_and(|token| is_number(&token)) && tokens.next().is_none()
        };
        let next = self.lines.peek();
        next.is_some_and(is_lone_number) || self.clone().comment("").is_err_and(|_| next.is_some())
    }

    /// A number on a record of its own.
    pub(super) fn number(&mut self, quantity: &Quantity) -> Result<Value<f64>, Diagnostic> {
        self.single(quantity, number)
    }

    /// A whole number on a record of its own.
    pub(super) fn integer(&mut self, quantity: &Quantity) -> Result<Value<i64>, Diagnostic> {
        self.single(quantity, integer)
    }

    /// A whole number from `least` to `most`.
    pub(super) fn count(
        &mut self,
        quantity: &Quantity,
        least: usize,
        most: usize,
    ) -> Result<Value<usize>, Diagnostic> {
        let Value { value, span } = self.integer(quantity)?;
        let counted = usize::try_from(value).ok();
        let least_written = i64::try_from(least).unwrap_or(i64::MAX);
        match counted.filter(|count| (least..=most).contains(count)) {
            Some(value) => Ok(Value { value, span }),
            None => {
                let bound = if value < least_written {
                    format!("at least {least}")
                } else {
                    format!("at most {most}")
                };
                let message = format!("{} is {value}, but must be {bound}", quantity.what());
                Err(Diagnostic::new(span, message))
            }
        }
    }

    /// True or false on a record of its own.
    pub(super) fn logical(&mut self, quantity: &Quantity) -> Result<Value<bool>, Diagnostic> {
        self.single(quantity, logical)
    }

    /// The name of a file on a record of its own.
    pub(super) fn path(&mut self, quantity: &Quantity) -> Result<Value<&'a str>, Diagnostic> {
        let line = self.lines.expect_filled(&quantity.what())?;
        let rest = line.text.trim_start();
        check_label(quantity, &Items::new(line), 1)?;
        let hint = "write it in quotes: 'folder/sections.dat'";
        let Some(token) = line.first().filter(|token| !token.text.trim().is_empty()) else {
            let message = format!(
                "{} is expected here; found `{}`",
                quantity.what(),
                short(rest)
            );
            return Err(Diagnostic::new(line.span(), message).with_hint(hint));
        };
        let after = &line.text[token.span.end - line.start..];
        if !token.is_quoted && after.starts_with('/') {
            let message = format!("a `/` ends {} after `{}`", quantity.what(), token.text);
            return Err(Diagnostic::new(token.span, message).with_hint(hint));
        }
        let (value, span) = (token.text.trim(), token.span);
        Ok(Value { value, span })
    }

    /// So many numbers on any number of records.
    pub(super) fn numbers(
        &mut self,
        quantity: &Quantity,
        count: usize,
        after: After,
    ) -> Result<Vec<Value<f64>>, Diagnostic> {
        self.list(quantity, count, after, number)
    }

    /// So many whole numbers on any number of records.
    pub(super) fn integers(
        &mut self,
        quantity: &Quantity,
        count: usize,
        after: After,
    ) -> Result<Vec<Value<i64>>, Diagnostic> {
        self.list(quantity, count, after, integer)
    }

    /// The record that a list of no values takes.
    pub(super) fn skipped(&mut self, quantity: &Quantity) -> Result<(), Diagnostic> {
        let line = self.lines.expect(&quantity.what())?;
        check_label(quantity, &Items::new(line), 0)
    }

    /// A value on a record of its own.
    fn single<T: Copy>(
        &mut self,
        quantity: &Quantity,
        read: Read<T>,
    ) -> Result<Value<T>, Diagnostic> {
        let line = self.lines.clone().expect_filled(&quantity.what())?;
        check_label(quantity, &Items::new(line), 1)?;
        let mut values = self.list(quantity, 1, After::Anything, read)?;
        values
            .pop()
            .ok_or_else(|| self.lines.ended(&quantity.what()))
    }

    fn list<T: Copy>(
        &mut self,
        quantity: &Quantity,
        count: usize,
        after: After,
        read: Read<T>,
    ) -> Result<Vec<Value<T>>, Diagnostic> {
        let mut values: Vec<Value<T>> = Vec::new();
        let mut commas = 0;
        loop {
            let what = nth(quantity, values.len(), count);
            let line = self.lines.expect_filled(&what)?;
            let mut items = Items::new(line);
            take(&mut items, &mut values, &mut commas, quantity, count, read)?;
            if values.len() == count {
                check_rest(quantity, &items, count, after)?;
                return Ok(values);
            }
            if items.ends_by_slash() {
                let what = nth(quantity, values.len(), count);
                let message = format!("a `/` ends the values here, where {what} is expected");
                return Err(Diagnostic::new(line.span(), message).with_hint("remove it"));
            }
            commas += items.commas_left();
        }
    }
}

/// Takes values from a record until it ends or there are as many as are read; `commas` stand since
/// the last one.
fn take<T: Copy>(
    items: &mut Items<'_>,
    values: &mut Vec<Value<T>>,
    commas: &mut usize,
    quantity: &Quantity,
    count: usize,
    read: Read<T>,
) -> Result<(), Diagnostic> {
    while values.len() < count {
        let Some(item) = items.next_item()? else {
            break;
        };
        let what = nth(quantity, values.len(), count);
        if *commas + item.commas > usize::from(!values.is_empty()) {
            return Err(left_out(&what, item.token.span));
        }
        *commas = 0;
        let value = read(&item.token, &what).map_err(|m| explained(m, &item.token))?;
        let repeats = item.repeats.min(count - values.len());
        let span = item.token.span;
        values.extend((0..repeats).map(|_| Value {
            value,
            span: span.clone(),
        }));
    }
    Ok(())
}

/// A value of a list by its number, or the only one.
fn nth(quantity: &Quantity, index: usize, count: usize) -> String {
    match count {
        0 | 1 => quantity.what(),
        _ => format!("value {} of the {count} of {}", index + 1, quantity.what()),
    }
}

fn number(token: &Token<'_>, what: &str) -> Result<f64, Diagnostic> {
    token.number(what)
}

fn integer(token: &Token<'_>, what: &str) -> Result<i64, Diagnostic> {
    token.integer(what)
}

fn logical(token: &Token<'_>, what: &str) -> Result<bool, Diagnostic> {
    token.logical(what)
}

/// Whether a token could be the value of a record.
fn is_value(token: &Token<'_>) -> bool {
    let lower = token.text.to_ascii_lowercase();
    let is_logical = ["t", "f", "true", "false", ".true.", ".false."].contains(&lower.as_str());
    token.is_quoted || is_logical || is_number(token)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bmodes::quantity::{EL_LOC, HUB_RAD, RADIUS};

    fn numbers(text: &str, count: usize) -> Result<Vec<f64>, String> {
        let values = Reader::new(text).numbers(&EL_LOC, count, After::Text);
        let numbers = |values: Vec<Value<f64>>| values.iter().map(|v| v.value).collect();
        values.map(numbers).map_err(|mistake| mistake.message)
    }

    #[test]
    fn lists_go_on_over_records() {
        assert_eq!(
            numbers("\n0. 0.5,\n\n 3*1d0 end\n", 5),
            Ok(vec![0.0, 0.5, 1.0, 1.0, 1.0])
        );
        assert_eq!(numbers("1 2 3", 3), Ok(vec![1.0, 2.0, 3.0]));
        // A count of the file may be huge: only what stands there takes memory.
        assert!(numbers("1 2", 1_000_000_000_000).is_err_and(|m| m.contains("value 3 of the")));
    }

    #[test]
    fn what_fortran_would_leave_as_it_was_is_refused() {
        for wrong in ["1,,2", ",1 2", "1,\n,2", "1 / 2", "2*", "1 x"] {
            assert!(numbers(wrong, 2).is_err(), "{wrong}");
        }
        assert!(numbers("1 2 3", 2).is_err_and(|m| m.contains("1 more")));
    }

    #[test]
    fn a_line_that_says_it_is_another_is_refused() {
        let read = |text| Reader::new(text).number(&RADIUS).map(|value| value.value);
        assert_eq!(read("87.6 radius: of the rotor"), Ok(87.6));
        assert_eq!(read("\n  87.6\n"), Ok(87.6));
        let mistake = read("0. hub_rad: of the hub").expect_err("another quantity");
        assert!(
            mistake.message.contains("says it is `hub_rad`"),
            "{mistake}"
        );
        assert!(Reader::new("0. rroot").number(&HUB_RAD).is_ok());
        let mistake = read("3,5e5 radius").expect_err("a decimal comma");
        assert!(mistake.to_string().contains("decimal point"), "{mistake}");
    }

    #[test]
    fn a_value_is_no_comment() {
        assert!(Reader::new("--- General").comment("a heading").is_ok());
        assert!(Reader::new("2 towers").comment("a heading").is_ok());
        let mistake = Reader::new("2 beam_type")
            .comment("a heading")
            .expect_err("a value");
        assert!(mistake.message.contains("gives `beam_type`"), "{mistake}");
    }
}
