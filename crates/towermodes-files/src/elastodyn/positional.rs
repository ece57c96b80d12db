//! Files whose lines mean what their places say: headings, parameters, rows of numbers.

use std::ops::Range;

use super::names::{is_ruler, name_on, plain, said};
use crate::diagnostic::Diagnostic;
use crate::records::{Line, Lines, Token};

/// More rows than this are refused: real tables have tens, and a hostile file must not fill the
/// memory.
pub(super) const MAX_ROWS: usize = 100_000;

/// The lines of a file that is read by position.
#[derive(Debug, Clone)]
pub(super) struct Positional<'a> {
    lines: Lines<'a>,
    /// The names of all parameters that the file has.
    known: &'static [&'static str],
}

impl<'a> Positional<'a> {
    pub(super) fn new(text: &'a str, known: &'static [&'static str]) -> Self {
        let lines = Lines::new(text);
        Self { lines, known }
    }

    /// The two free lines that a file begins with. Files of FAST 7 begin with one more, a ruler:
    /// there the heading and the first parameter, by whose name that is seen, come a line later.
    pub(super) fn header(&mut self, first_key: &str) -> Result<[String; 2], Diagnostic> {
        let is_first_key = |line: Line<'a>| name_on(&line) == Some(plain(first_key));
        if self.lines.clone().nth(4).is_some_and(is_first_key) {
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

    /// The next line that is not blank without reading past it.
    pub(super) fn peek_filled(&self) -> Option<Line<'a>> {
        self.lines.clone().find(|line| !line.is_blank())
    }

    /// Leaves out blank lines.
    pub(super) fn skip_blank(&mut self) {
        while self.lines.peek().is_some_and(|line| line.is_blank()) {
            self.lines.next();
        }
    }

    /// The title of a section, or the names or units of columns: any line that is not a parameter
    /// or a row.
    pub(super) fn heading(&mut self, what: &str) -> Result<Line<'a>, Diagnostic> {
        let line = self.lines.expect(what)?;
        if let Some(name) = said(&line, self.known) {
            return Err(misplaced(&line, what, name));
        }
        match line.first() {
            Some(token) if token.number("").is_ok() => {
                let message = format!("{what} is expected here, no number");
                Err(token
                    .wrong(message)
                    .with_hint("is there a row or a line too many?"))
            }
            _ => Ok(line),
        }
    }

    /// The line of a parameter, which has the value first; its name is compared if it is that of
    /// another parameter.
    pub(super) fn parameter(
        &mut self,
        key: &'static str,
        what: &'static str,
    ) -> Result<Parameter<'a>, Diagnostic> {
        let line = self.lines.expect_filled(&format!("{key} ({what})"))?;
        match said(&line, self.known) {
            Some(name) if name != key => Err(misplaced(&line, key, name)),
            _ => Parameter::of(&line, key, what),
        }
    }

    /// The same where names are not to be relied on.
    pub(super) fn unnamed_parameter(
        &mut self,
        key: &'static str,
        what: &'static str,
    ) -> Result<Parameter<'a>, Diagnostic> {
        let line = self.lines.expect_filled(&format!("{key} ({what})"))?;
        Parameter::of(&line, key, what)
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
        let hint = || {
            let (key, said) = (count.key, count.token.text);
            format!("{key} is {said}; {so_far} rows are there")
        };
        match line.first() {
            Some(token) if token.number("").is_ok() => {
                line.check_commas(&format!("a number of {what}"))?;
                Ok(line)
            }
            Some(token) => Err(token
                .wrong(format!("{what} is expected here"))
                .with_hint(hint())),
            None => Err(
                Diagnostic::new(line.span(), format!("{what} is expected here")).with_hint(hint()),
            ),
        }
    }
}

/// The mistake that a line says another name than its place.
pub(super) fn misplaced(line: &Line<'_>, expected: &str, said: &str) -> Diagnostic {
    let span = line.tokens().nth(1).map_or(line.span(), |token| token.span);
    let message = format!("expected {expected} here, but the line says {said}");
    Diagnostic::new(span, message).with_hint("is a line missing or too many above?")
}

/// A parameter: what it is called, what it is, and its value.
#[derive(Debug, Clone)]
pub(super) struct Parameter<'a> {
    pub(super) key: &'static str,
    what: &'static str,
    pub(super) token: Token<'a>,
}

impl<'a> Parameter<'a> {
    /// The parameter on a line, whose first value is its.
    pub(super) fn of(
        line: &Line<'a>,
        key: &'static str,
        what: &'static str,
    ) -> Result<Self, Diagnostic> {
        if is_ruler(line) {
            let message = format!("{key} ({what}) is expected here, but this is a heading");
            return Err(Diagnostic::new(line.span(), message).with_hint("is a line missing above?"));
        }
        line.check_commas(&format!("{key} ({what})"))?;
        match line.first() {
            Some(token) => Ok(Self { key, what, token }),
            None => Err(Diagnostic::new(
                line.span(),
                format!("{key} ({what}) is expected here"),
            )),
        }
    }

    pub(super) fn span(&self) -> Range<usize> {
        self.token.span.clone()
    }

    fn label(&self) -> String {
        format!("{} ({})", self.key, self.what)
    }

    pub(super) fn number(&self) -> Result<f64, Diagnostic> {
        self.token.number(&self.label())
    }

    /// A number that a rule holds for; else the mistake that it does not, with what would be right.
    pub(super) fn number_if(
        &self,
        rule: impl Fn(f64) -> bool,
        right: &str,
    ) -> Result<f64, Diagnostic> {
        let value = self.number()?;
        if rule(value) {
            return Ok(value);
        }
        Err(self.wrong(&format!("is {}", self.token.text), right))
    }

    pub(super) fn positive(&self) -> Result<f64, Diagnostic> {
        self.number_if(|value| value > 0.0, "it must be greater than 0")
    }

    pub(super) fn not_negative(&self) -> Result<f64, Diagnostic> {
        self.number_if(|value| value >= 0.0, "it must not be negative")
    }

    /// A whole number from `least` to [`MAX_ROWS`].
    pub(super) fn count(&self, least: usize) -> Result<usize, Diagnostic> {
        let value = self.token.integer(&self.label())?;
        match usize::try_from(value) {
            Ok(count) if (least..=MAX_ROWS).contains(&count) => Ok(count),
            _ => {
                let right = format!("it must be from {least} to {MAX_ROWS}");
                Err(self.wrong(&format!("is {value}"), &right))
            }
        }
    }

    pub(super) fn logical(&self) -> Result<bool, Diagnostic> {
        self.token.logical(&self.label())
    }

    /// The name of a file.
    pub(super) fn file(&self) -> Result<String, Diagnostic> {
        let path = self.token.text.trim();
        if path.is_empty() {
            return Err(self.wrong("is empty", "a file name in quotes is expected"));
        }
        Ok(path.to_owned())
    }

    /// A mistake in the value, with what would be right.
    pub(super) fn wrong(&self, is: &str, right: &str) -> Diagnostic {
        Diagnostic::new(self.span(), format!("{} {is}", self.label())).with_hint(right)
    }
}

/// As many numbers as there are names of columns, from the beginning of a row; more are left out.
pub(super) fn numbers<'a, const N: usize>(
    line: &Line<'a>,
    row: &str,
    columns: [&str; N],
) -> Result<[(f64, Token<'a>); N], Diagnostic> {
    let mut tokens = line.tokens();
    let mut read = Vec::with_capacity(N);
    for column in columns {
        let Some(token) = tokens.next() else {
            let message = format!("{row} has {} numbers; {column} is missing", read.len());
            let hint = format!("a row has {}", columns.join(", "));
            return Err(Diagnostic::new(line.span(), message).with_hint(hint));
        };
        read.push((token.number(&format!("{column} of {row}"))?, token));
    }
    let ended = || Diagnostic::new(line.span(), format!("{row} is too short"));
    read.try_into().map_err(|_| ended())
}

/// Whether two shares of a length agree as well as OpenFAST wants in double precision.
fn is_share(value: f64, wanted: f64) -> bool {
    (value - wanted).abs() <= 1e-14
}

/// Checks a row's share of the length, which begins at 0 and rises, and gives it.
pub(super) fn next_fraction(
    value: f64,
    token: &Token<'_>,
    previous: Option<f64>,
    column: &str,
) -> Result<f64, Diagnostic> {
    let wrong = |message: String, right: &str| {
        Err(Diagnostic::new(token.span.clone(), message).with_hint(right))
    };
    match previous {
        None if is_share(value, 0.0) => Ok(0.0),
        None => wrong(
            format!("{column} of the first row is {}", token.text),
            "it must be 0",
        ),
        Some(previous) if value > previous => Ok(value),
        Some(previous) => wrong(
            format!("{column} is {} after {previous}", token.text),
            "it must rise from row to row; a step is two rows close together, such as 0.1 and 0.100001",
        ),
    }
}

/// Checks that the last row's share of the length is 1, and gives it.
pub(super) fn last_fraction(
    value: f64,
    span: Range<usize>,
    column: &str,
) -> Result<f64, Diagnostic> {
    if is_share(value, 1.0) {
        return Ok(1.0);
    }
    let message = format!("{column} of the last row is {value}");
    Err(Diagnostic::new(span, message).with_hint("it must be 1"))
}
