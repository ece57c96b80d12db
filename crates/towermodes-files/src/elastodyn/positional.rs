//! Files that are read by position: headings, parameters, rows of numbers.

use std::ops::Range;

use super::names::{is_ruler, name_on, named, plain};
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::records::{Line, Lines, Token};

/// More rows than this are refused: real tables have tens, and a hostile file must not fill the
/// memory.
pub(super) const MAX_ROWS: usize = 100_000;

/// A parameter of a file: the row of the tables that reading, writing and messages go by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Record {
    /// Its name on the line.
    pub(super) name: &'static str,
    /// Its meaning, with its unit.
    pub(super) meaning: &'static str,
    kind: Kind,
}

/// The type of a parameter and the range of its values.
#[derive(Debug, Clone, Copy)]
pub(super) enum Kind {
    /// True or false, the name of a file, or a value that is not read.
    Other,
    /// A whole number from this one to [`MAX_ROWS`].
    Count(usize),
    /// A number in a range, and the range in words.
    Number(fn(f64) -> bool, &'static str),
}

pub(super) const ANY: Kind = Kind::Number(|_| true, "a number");
pub(super) const POSITIVE: Kind = Kind::Number(|value| value > 0.0, "greater than 0");
pub(super) const NON_NEGATIVE: Kind = Kind::Number(|value| value >= 0.0, "non-negative");
/// An angle of less than a right angle, degrees.
pub(super) const ACUTE: Kind =
    Kind::Number(|angle| angle.abs() < 90.0, "between -90 and 90 degrees");
/// An angle of at most half a turn, degrees.
pub(super) const HALF_TURN: Kind =
    Kind::Number(|angle| angle.abs() <= 180.0, "from -180 to 180 degrees");
/// A damping ratio, percent of critical.
pub(super) const PERCENT: Kind = Kind::Number(
    |value| (0.0..=100.0).contains(&value),
    "from 0 to 100 percent",
);

/// A row of a table of parameters.
pub(super) const fn record(name: &'static str, meaning: &'static str, kind: Kind) -> Record {
    Record {
        name,
        meaning,
        kind,
    }
}

impl Record {
    /// Whether a number is in its range, and the range.
    pub(super) fn check(&self, value: f64) -> (bool, &'static str) {
        match self.kind {
            Kind::Number(is_met, rule) => (is_met(value), rule),
            _ => (true, ""),
        }
    }

    /// Its name in messages.
    pub(super) fn label(&self) -> String {
        let meaning = self.meaning.trim_start_matches([' ', ',']);
        format!("{} ({meaning})", self.name)
    }
}

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

    /// The two free lines at the beginning of a file. Files of FAST 7 begin with one more, a ruler:
    /// there the heading and the first parameter, whose name shows it, come a line later.
    pub(super) fn header(&mut self, first: &Record) -> Result<[String; 2], Diagnostic> {
        let is_first = |line: Line<'a>| name_on(&line) == Some(plain(first.name));
        if self.lines.clone().nth(4).is_some_and(is_first) {
            self.lines.next();
        }
        let first = self.lines.expect("the first header line")?;
        let second = self.lines.expect("the second header line")?;
        Ok([first, second].map(|line| line.text.to_owned()))
    }

    /// The next line without reading past it.
    pub(super) fn peek(&self) -> Option<Line<'a>> {
        self.lines.peek()
    }

    /// Whether the next line that is not blank has the name of a parameter.
    pub(super) fn is_next(&self, record: &Record) -> bool {
        let next = self.lines.clone().find(|line| !line.is_blank());
        next.and_then(|line| name_on(&line)) == Some(plain(record.name))
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

    /// The line of a parameter, whose value comes first. A line with the name of another parameter
    /// is a mistake.
    pub(super) fn parameter(&mut self, record: &Record) -> Result<Parameter<'a>, Diagnostic> {
        let line = self.lines.expect_filled(&record.label())?;
        match named(&line, &self.known) {
            Some(name) if name != record.name => Err(misplaced(&line, record.name, name)),
            _ => Parameter::of(&line, record),
        }
    }

    /// The same where the name on the line is not checked.
    pub(super) fn unnamed_parameter(
        &mut self,
        record: &Record,
    ) -> Result<Parameter<'a>, Diagnostic> {
        let line = self.lines.expect_filled(&record.label())?;
        Parameter::of(&line, record)
    }

    /// The next row of a table, of which `so_far` of `count` rows are read.
    pub(super) fn row(
        &mut self,
        table: &str,
        so_far: usize,
        count: &Parameter<'_>,
    ) -> Result<Line<'a>, Diagnostic> {
        let what = format!("row {} of {table}", so_far + 1);
        let line = self.lines.expect_filled(&what)?;
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
        Err(
            Diagnostic::new(span, DiagnosticKind::misplaced(what, found))
                .with_hint(format!("{name} is {value}, but there are {so_far} rows")),
        )
    }
}

/// The mistake of a line with the name of another parameter than expected.
pub(super) fn misplaced(line: &Line<'_>, expected: &str, found: &str) -> Diagnostic {
    let span = line.tokens().nth(1).map_or(line.span(), |token| token.span);
    Diagnostic::new(span, DiagnosticKind::misplaced(expected, found))
        .with_hint("is a line above missing, or one too many?")
}

/// A parameter of a file with its value.
#[derive(Debug, Clone)]
pub(super) struct Parameter<'a> {
    record: Record,
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
        let path = self.token.text.trim();
        if path.is_empty() {
            let what = self.record.label();
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

/// The numbers at the beginning of a row, one for each column; further ones are not read.
pub(super) fn numbers<'a, const N: usize>(
    line: &Line<'a>,
    row: &str,
    columns: [&str; N],
) -> Result<[(f64, Token<'a>); N], Diagnostic> {
    let too_few = |found: usize| {
        let kind = DiagnosticKind::wrong_count_of("numbers", row, found, N);
        let (missing, all) = (columns[found.min(N - 1)], columns.join(", "));
        Diagnostic::new(line.span(), kind)
            .with_hint(format!("{missing} is missing; a row has {all}"))
    };
    let mut tokens = line.tokens();
    let mut read = Vec::with_capacity(N);
    for column in columns {
        let token = tokens.next().ok_or_else(|| too_few(read.len()))?;
        read.push((token.number(&format!("{column} of {row}"))?, token));
    }
    read.try_into().map_err(|_| too_few(0))
}

/// Checks a number of a row.
pub(super) fn check_cell(
    token: &Token<'_>,
    what: String,
    value: f64,
    kind: Kind,
) -> Result<(), Diagnostic> {
    match kind {
        Kind::Number(is_met, rule) if !is_met(value) => {
            Err(token.wrong(DiagnosticKind::out_of_range(what, value, rule)))
        }
        _ => Ok(()),
    }
}

/// Whether two fractions of a length agree as well as OpenFAST requires in double precision.
fn is_fraction(value: f64, wanted: f64) -> bool {
    (value - wanted).abs() <= 1e-14
}

/// Checks the fraction of the length of a row: 0 in the first row, increasing from row to row.
pub(super) fn next_fraction(
    value: f64,
    token: &Token<'_>,
    previous: Option<f64>,
    column: &str,
) -> Result<f64, Diagnostic> {
    match previous {
        None if is_fraction(value, 0.0) => Ok(0.0),
        None => {
            let what = format!("{column} of the first row");
            Err(token.wrong(DiagnosticKind::out_of_range(what, value, "0")))
        }
        Some(previous) if value > previous => Ok(value),
        Some(previous) => Err(token
            .wrong(DiagnosticKind::not_rising(column, value, previous, ""))
            .with_hint(
                "it must increase from row to row; a step is two rows close together, such as 0.1 and 0.100001",
            )),
    }
}

/// Checks that the fraction of the length of the last row is 1, and returns it.
pub(super) fn last_fraction(
    value: f64,
    span: Range<usize>,
    column: &str,
) -> Result<f64, Diagnostic> {
    if is_fraction(value, 1.0) {
        return Ok(1.0);
    }
    let what = format!("{column} of the last row");
    Err(Diagnostic::new(
        span,
        DiagnosticKind::out_of_range(what, value, "1"),
    ))
}
