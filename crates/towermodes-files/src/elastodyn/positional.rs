//! Files that are read by position: headings, parameters, lines of tables.

use std::ops::Range;

use super::names::{is_named, is_ruler, named};
use super::record::{Kind, MAX_ROWS, Record};
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::records::{Line, Lines, Token};

/// The lines of a file that is read by position.
#[derive(Debug, Clone)]
pub(super) struct Positional<'a> {
    lines: Lines<'a>,
    /// The names of all parameters of the file.
    known: Vec<&'static str>,
}

impl<'a> Positional<'a> {
    pub(super) fn new<'r>(text: &'a str, records: impl IntoIterator<Item = &'r Record>) -> Self {
        let lines = Lines::new(text);
        let known = records.into_iter().map(|record| record.name).collect();
        Self { lines, known }
    }

    /// The two free lines at the beginning of a file. Files of FAST 7 begin with one more line, a
    /// ruler: then the heading and the first parameter, recognized by its name, are one line later.
    pub(super) fn header(&mut self, first: &Record) -> Result<[String; 2], Diagnostic> {
        let is_first = |line: Line<'a>| is_named(&line, first.name);
        if self.lines.clone().nth(4).is_some_and(is_first) {
            self.lines.next();
        }
        let first = self.lines.expect("the first header line")?;
        let second = self.lines.expect("the second header line")?;
        Ok([first, second].map(|line| line.text.to_owned()))
    }

    /// The next line, which is not consumed.
    pub(super) fn peek(&self) -> Option<Line<'a>> {
        self.lines.peek()
    }

    /// Whether the next line that is not blank has the name of a parameter.
    pub(super) fn is_next(&self, record: &Record) -> bool {
        let next = self.lines.clone().find(|line| !line.is_blank());
        next.is_some_and(|line| is_named(&line, record.name))
    }

    /// Skips blank lines.
    pub(super) fn skip_blank(&mut self) {
        while self.lines.peek().is_some_and(|line| line.is_blank()) {
            self.lines.next();
        }
    }

    /// The title of a section, or the names or units of columns: any line that is not a parameter
    /// or a row.
    pub(super) fn heading(&mut self, what: &str) -> Result<Line<'a>, Diagnostic> {
        let line = self.lines.expect(what)?;
        if let Some(name) = named(&line, &self.known) {
            return Err(misplaced(&line, what, name));
        }
        match line.first() {
            Some(token) if token.is_number() => {
                let found = format!("the number {}", token.text);
                let mistake = token.wrong(DiagnosticKind::misplaced(what, found));
                Err(mistake.with_hint("is there a row or a line too many?"))
            }
            _ => Ok(line),
        }
    }

    /// The line of a parameter, which begins with its value. A line with the name of another
    /// parameter is a mistake.
    pub(super) fn parameter(&mut self, record: &Record) -> Result<Parameter<'a>, Diagnostic> {
        let line = self.lines.expect_filled(&record.label())?;
        check_no_comment(&line, &record.label())?;
        match named(&line, &self.known) {
            Some(name) if name != record.name => Err(misplaced(&line, record.name, name)),
            _ => Parameter::of(&line, record),
        }
    }

    /// The line of a parameter whose name is not checked.
    pub(super) fn unnamed_parameter(
        &mut self,
        record: &Record,
    ) -> Result<Parameter<'a>, Diagnostic> {
        let line = self.lines.expect_filled(&record.label())?;
        check_no_comment(&line, &record.label())?;
        Parameter::of(&line, record)
    }

    /// The next row of a table, of which `so_far` of `count` rows have been read.
    pub(super) fn row(
        &mut self,
        table: &str,
        so_far: usize,
        count: &Parameter<'_>,
    ) -> Result<Line<'a>, Diagnostic> {
        let what = format!("row {} of {table}", so_far + 1);
        let line = self.lines.expect_filled(&what)?;
        check_no_comment(&line, &what)?;
        let first = line.first();
        if first.as_ref().is_some_and(Token::is_number) {
            line.check_commas(&format!("a number of {what}"))?;
            return Ok(line);
        }
        let (found, span) = match first {
            Some(token) => (quoted(token.text), token.span),
            None => ("a blank line".to_owned(), line.span()),
        };
        let (name, value) = (count.record.name, count.token.text);
        let hint = match so_far {
            0 if !is_ruler(&line) => {
                "two lines, names and units, are between the heading of the table and its rows"
                    .to_owned()
            }
            _ => format!("{name} is {value}, but there are {so_far} rows"),
        };
        Err(Diagnostic::new(span, DiagnosticKind::misplaced(what, found)).with_hint(hint))
    }
}

/// Refuses a comment in place of a value: OpenFAST would read its first word as the value.
pub(super) fn check_no_comment(line: &Line<'_>, expected: &str) -> Result<(), Diagnostic> {
    let text = line.text.trim_start();
    if !text.starts_with(['!', '#', '%']) {
        return Ok(());
    }
    let start = line.start + line.text.len() - text.len();
    let kind = DiagnosticKind::misplaced(expected, "a comment");
    let hint = "OpenFAST reads these lines by position: write comments after the values";
    Err(Diagnostic::new(start..start + text.trim_end().len(), kind).with_hint(hint))
}

/// The mistake of a line with the name of another parameter than the expected one.
pub(super) fn misplaced(line: &Line<'_>, expected: &str, found: &str) -> Diagnostic {
    let span = line.tokens().nth(1).map_or(line.span(), |token| token.span);
    Diagnostic::new(span, DiagnosticKind::misplaced(expected, found))
        .with_hint("is a line missing above, or is there an extra line?")
}

/// A parameter of a file with its value.
#[derive(Debug, Clone)]
pub(super) struct Parameter<'a> {
    record: Record,
    line: Line<'a>,
    pub(super) token: Token<'a>,
}

impl<'a> Parameter<'a> {
    /// The parameter on a line, whose first value is its value.
    pub(super) fn of(line: &Line<'a>, record: &Record) -> Result<Self, Diagnostic> {
        let label = record.label();
        if is_ruler(line) {
            let kind = DiagnosticKind::misplaced(label, "a heading");
            return Err(Diagnostic::new(line.span(), kind).with_hint("is a line above missing?"));
        }
        line.check_commas(&label)?;
        match line.first() {
            Some(token) => Ok(Self {
                record: *record,
                line: *line,
                token,
            }),
            None => {
                let kind = DiagnosticKind::Missing { what: label };
                Err(Diagnostic::new(line.span(), kind))
            }
        }
    }

    pub(super) fn span(&self) -> Range<usize> {
        self.token.span.clone()
    }

    /// The number, in the range of the parameter.
    pub(super) fn number(&self) -> Result<f64, Diagnostic> {
        let value = self.token.number(&self.record.label())?;
        match self.record.check(value) {
            (true, _) => Ok(value),
            (false, rule) => Err(self.out_of_range(value, rule)),
        }
    }

    /// The whole number, in the range of the parameter.
    pub(super) fn count(&self) -> Result<usize, Diagnostic> {
        let value = self.token.integer(&self.record.label())?;
        let least = match self.record.kind {
            Kind::Count(least) => least,
            _ => 0,
        };
        match usize::try_from(value) {
            Ok(count) if (least..=MAX_ROWS).contains(&count) => Ok(count),
            _ => {
                let rule = format!("from {least} to {MAX_ROWS}");
                Err(self.out_of_range(value as f64, rule))
            }
        }
    }

    pub(super) fn logical(&self) -> Result<bool, Diagnostic> {
        self.token.logical(&self.record.label())
    }

    /// The name of a file.
    pub(super) fn file(&self) -> Result<String, Diagnostic> {
        let what = self.record.label();
        self.line.file_name(&what)?;
        let path = self.token.text.trim();
        if path.is_empty() {
            let kind = DiagnosticKind::wrong_type(what, "a file name in quotes", "an empty text");
            return Err(self.token.wrong(kind));
        }
        Ok(path.to_owned())
    }

    /// The mistake of a value outside its range.
    pub(super) fn out_of_range(&self, value: f64, rule: impl Into<String>) -> Diagnostic {
        let what = self.record.label();
        let kind = DiagnosticKind::out_of_range(what, value, rule);
        self.token.wrong(kind)
    }
}
