//! Reads a deck record by record, each value with its place, and detects missing and surplus lines
//! early.

use std::iter::repeat_n;
use std::ops::Range;

use super::diagnose::{After, check_label, check_rest, explained, left_out};
use super::parameters::{Kind, Parameter};
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::records::{Items, Line, Lines, Token};

/// A value and its byte range in the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Value<T> {
    pub(crate) value: T,
    pub(crate) span: Range<usize>,
}

impl<T> Value<T> {
    /// A mistake about this value.
    pub(crate) fn wrong(&self, kind: DiagnosticKind) -> Diagnostic {
        Diagnostic::new(self.span.clone(), kind)
    }

    /// Another value at the same place.
    pub(crate) fn map<U>(self, convert: impl FnOnce(T) -> U) -> Value<U> {
        Value {
            value: convert(self.value),
            span: self.span,
        }
    }
}

/// The part of a file that is not yet read.
#[derive(Debug, Clone)]
pub(crate) struct Reader<'a> {
    pub(crate) lines: Lines<'a>,
}

impl<'a> Reader<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        let lines = Lines::new(text);
        Self { lines }
    }

    /// A comment record. A record that contains a parameter is a mistake.
    pub(crate) fn comment(&mut self, what: &str) -> Result<Line<'a>, Diagnostic> {
        let line = self.lines.expect(what)?;
        let mut items = Items::new(line);
        let Ok(Some(item)) = items.next_item() else {
            return Ok(line);
        };
        let first = item.token;
        if !is_value(&first) {
            return Ok(line);
        }
        let has_two = item.repeats > 1 || items.peek().is_some_and(|token| token.is_number());
        let found = if first.is_number() && has_two {
            "numbers".to_owned()
        } else {
            let label = items.label_after(0);
            let Some(parameter) = label.and_then(|label| Parameter::called(label.text)) else {
                return Ok(line);
            };
            format!("`{}`", parameter.name)
        };
        let mistake = first.wrong(DiagnosticKind::misplaced(what, found));
        Err(mistake.with_hint("is a line above missing?"))
    }

    /// The blank line and the heading between two blocks. If the blank line is missing, the values
    /// follow the first of two lines.
    pub(crate) fn heading(&mut self, heading: &str) -> Result<(), Diagnostic> {
        let first = self.comment(&format!("the (usually blank) line before {heading}"))?;
        if first.is_blank() || !self.value_follows() {
            self.comment(heading)?;
        }
        Ok(())
    }

    /// Whether the next record contains a parameter: its name, several numbers, or a single number.
    fn value_follows(&self) -> bool {
        let is_lone_number = |line: Line<'a>| {
            let mut tokens = line.tokens();
            tokens.next().is_some_and(|token| token.is_number()) && tokens.next().is_none()
        };
        let next = self.lines.peek();
        next.is_some_and(is_lone_number) || self.clone().comment("").is_err_and(|_| next.is_some())
    }

    /// Whether the next line is a heading instead of a value, followed by a value of a parameter.
    pub(super) fn block_follows(&self, heading: &str, first: &Parameter) -> bool {
        let mut rest = self.clone();
        !self.value_follows() && rest.heading(heading).is_ok() && rest.value(first).is_ok()
    }

    /// Whether any of the remaining lines begins with a number.
    pub(super) fn values_follow(&self) -> bool {
        let mut lines = self.lines.clone();
        lines.any(|line| line.first().is_some_and(|token| token.is_number()))
    }

    /// Whether the next line that is not blank begins with a number.
    pub(super) fn number_follows(&self) -> bool {
        let next = self.lines.clone().find(|line| !line.is_blank());
        let first = next.and_then(|line| line.first());
        first.is_some_and(|token| token.is_number())
    }

    /// The parameters of a block, one per record; flags are 0 or 1.
    pub(crate) fn block<const N: usize>(
        &mut self,
        parameters: [&Parameter; N],
    ) -> Result<[Value<f64>; N], Diagnostic> {
        let mut values = Vec::with_capacity(N);
        for parameter in parameters {
            values.push(self.value(parameter)?);
        }
        values.try_into().map_err(|_| self.lines.ended("a record"))
    }

    /// A parameter in its own record.
    pub(crate) fn value(&mut self, parameter: &Parameter) -> Result<Value<f64>, Diagnostic> {
        let line = self.lines.clone().expect_filled(&parameter.what())?;
        check_label(parameter, &Items::new(line), 1)?;
        let mut values = self.list(parameter, 1, After::Anything)?;
        let ended = || self.lines.ended(&parameter.what());
        values.pop().ok_or_else(ended)
    }

    /// A parameter that counts something.
    pub(crate) fn count(&mut self, parameter: &Parameter) -> Result<Value<usize>, Diagnostic> {
        Ok(self.value(parameter)?.map(|count| count as usize))
    }

    /// The name of a file in its own record.
    pub(crate) fn path(&mut self, parameter: &Parameter) -> Result<Value<&'a str>, Diagnostic> {
        let line = self.lines.expect_filled(&parameter.what())?;
        check_label(parameter, &Items::new(line), 1)?;
        let hint = "write it in quotes: 'folder/sections.dat'";
        let Some(token) = line.first().filter(|token| !token.text.trim().is_empty()) else {
            let found = quoted(line.text.trim_start());
            let kind = DiagnosticKind::wrong_type(parameter.what(), "a file name", found);
            return Err(Diagnostic::new(line.span(), kind).with_hint(hint));
        };
        let after = &line.text[token.span.end - line.start..];
        if !token.is_quoted && after.starts_with('/') {
            let kind = DiagnosticKind::NoValue {
                what: parameter.what(),
                reason: "a `/` ends the name",
            };
            return Err(token.wrong(kind).with_hint(hint));
        }
        let (value, span) = (token.text.trim(), token.span);
        Ok(Value { value, span })
    }

    /// Skips the record of an empty list.
    pub(crate) fn skipped(&mut self, parameter: &Parameter) -> Result<(), Diagnostic> {
        let line = self.lines.expect(&parameter.what())?;
        check_label(parameter, &Items::new(line), 0)
    }

    /// A number of values of a parameter in any number of records.
    pub(crate) fn list(
        &mut self,
        parameter: &Parameter,
        count: usize,
        after: After,
    ) -> Result<Vec<Value<f64>>, Diagnostic> {
        let mut list = List {
            parameter,
            count,
            values: Vec::new(),
            commas: 0,
        };
        loop {
            let line = self.lines.expect_filled(&list.next_name())?;
            let mut items = Items::new(line);
            list.take(&mut items)?;
            if list.values.len() == count {
                check_rest(parameter, &items, count, after)?;
                return Ok(list.values);
            }
            if items.ends_by_slash() {
                return Err(list.ended_by_slash(&line));
            }
            list.commas += items.commas_left();
        }
    }
}

/// A list of values that is being read.
struct List<'p> {
    parameter: &'p Parameter,
    count: usize,
    values: Vec<Value<f64>>,
    /// Number of commas since the last value.
    commas: usize,
}

impl List<'_> {
    /// The name of the next value in messages: with its number, unless it is the only one.
    fn next_name(&self) -> String {
        match self.count {
            0 | 1 => self.parameter.what(),
            count => format!(
                "value {} of the {count} of {}",
                self.values.len() + 1,
                self.parameter.what()
            ),
        }
    }

    fn ended_by_slash(&self, line: &Line<'_>) -> Diagnostic {
        let kind = DiagnosticKind::NoValue {
            what: self.next_name(),
            reason: "a `/` ends the values",
        };
        Diagnostic::new(line.span(), kind).with_hint("remove it")
    }

    /// Reads values from a record until it ends or the list is complete.
    fn take(&mut self, items: &mut Items<'_>) -> Result<(), Diagnostic> {
        while self.values.len() < self.count {
            let Some(item) = items.next_item()? else {
                break;
            };
            let what = self.next_name();
            if self.commas + item.commas > usize::from(!self.values.is_empty()) {
                return Err(left_out(&what, &item.token));
            }
            self.commas = 0;
            let value = value_of(&item.token, self.parameter, &what)?;
            let repeats = item.repeats.min(self.count - self.values.len());
            let span = item.token.span;
            self.values.extend(repeat_n(Value { value, span }, repeats));
        }
        Ok(())
    }
}

/// The value of a token, with the type and the range of its parameter.
fn value_of(token: &Token<'_>, parameter: &Parameter, what: &str) -> Result<f64, Diagnostic> {
    let (value, rule) = match parameter.kind {
        Kind::Flag => (token.logical(what).map(|is| f64::from(u8::from(is))), None),
        Kind::Whole(rule) => (token.integer(what).map(|whole| whole as f64), Some(rule)),
        Kind::Number(rule) => (token.number(what), Some(rule)),
        Kind::File => (token.number(what), None),
    };
    let value = value.map_err(|mistake| explained(mistake, token))?;
    match rule.filter(|rule| !(rule.is_met)(value)) {
        None => Ok(value),
        Some(rule) => {
            let kind = DiagnosticKind::out_of_range(parameter.name, value, rule.words);
            Err(token.wrong(kind).with_hint(parameter.comment()))
        }
    }
}

/// Whether a token could be the value of a record.
fn is_value(token: &Token<'_>) -> bool {
    let lower = token.text.to_ascii_lowercase();
    let is_logical = ["t", "f", "true", "false", ".true.", ".false."].contains(&lower.as_str());
    token.is_quoted || is_logical || token.is_number()
}

#[cfg(test)]
mod tests {
    use super::super::parameters::{EL_LOC, HUB_RAD, RADIUS};
    use super::*;

    fn numbers(text: &str, count: usize) -> Result<Vec<f64>, String> {
        let values = Reader::new(text).list(&EL_LOC, count, After::Text);
        let numbers = |values: Vec<Value<f64>>| values.iter().map(|v| v.value).collect();
        values.map(numbers).map_err(|mistake| mistake.message())
    }

    #[test]
    fn lists_go_on_over_records() {
        assert_eq!(
            numbers("\n0. 0.5,\n\n 3*1d0 end\n", 5),
            Ok(vec![0.0, 0.5, 1.0, 1.0, 1.0])
        );
        assert_eq!(numbers("1 2 3", 3), Ok(vec![1.0, 2.0, 3.0]));
        // A count may be huge: only values that are there take memory.
        assert!(numbers("1 2", 1_000_000_000_000).is_err_and(|m| m.contains("value 3 of the")));
    }

    #[test]
    fn empty_values_are_refused() {
        for wrong in ["1,,2", ",1 2", "1,\n,2", "1 / 2", "2*", "1 x"] {
            assert!(numbers(wrong, 2).is_err(), "{wrong}");
        }
        assert!(numbers("1 2 3", 2).is_err_and(|m| m.contains("3 values instead of 2")));
    }

    #[test]
    fn a_line_with_the_name_of_another_parameter_is_refused() {
        let read = |text| Reader::new(text).value(&RADIUS).map(|value| value.value);
        assert_eq!(read("87.6 radius: of the rotor"), Ok(87.6));
        assert_eq!(read("\n  87.6\n"), Ok(87.6));
        let mistake = read("0. hub_rad: of the hub").expect_err("another quantity");
        assert!(mistake.message().contains("found `hub_rad`"), "{mistake}");
        assert!(Reader::new("0. rroot").value(&HUB_RAD).is_ok());
        let mistake = read("3,5e5 radius").expect_err("a decimal comma");
        assert!(mistake.to_string().contains("decimal point"), "{mistake}");
    }

    #[test]
    fn a_record_with_a_value_is_not_a_comment() {
        assert!(Reader::new("--- General").comment("a heading").is_ok());
        assert!(Reader::new("2 towers").comment("a heading").is_ok());
        let mistake = Reader::new("2 beam_type")
            .comment("a heading")
            .expect_err("a value");
        assert!(mistake.message().contains("found `beam_type`"), "{mistake}");
    }
}
