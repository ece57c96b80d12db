//! The lines of a file by the names after their values.

use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::records::{Line, Lines, Token};

/// The first line with each name: values, then the name.
#[derive(Debug)]
pub(super) struct Values<'a> {
    pub(super) text: &'a str,
    lines: HashMap<String, Line<'a>>,
}

/// The name on a line, after one or more values.
fn name_of<'a>(line: &Line<'a>) -> Option<&'a str> {
    let mut tokens = line.tokens();
    tokens.next()?;
    let behind = tokens.find(|token| !token.is_number() && !token.is_quoted);
    behind
        .map(|token| token.text)
        .or_else(|| line.name_behind_path())
}

impl<'a> Values<'a> {
    pub(super) fn of(text: &'a str) -> Self {
        let mut lines = HashMap::new();
        for line in Lines::new(text) {
            if let Some(name) = name_of(&line) {
                let name = name.to_ascii_lowercase();
                lines.entry(name).or_insert(line);
            }
        }
        Self { text, lines }
    }

    /// The line with a name.
    pub(super) fn line(&self, name: &str) -> Option<Line<'a>> {
        self.lines.get(&name.to_ascii_lowercase()).copied()
    }

    /// The first value on the line with a name.
    pub(super) fn token(&self, name: &str) -> Option<Token<'a>> {
        self.line(name)?.first()
    }

    /// The first value on the line with a name that must exist.
    pub(super) fn expect(&self, name: &str) -> Result<Token<'a>, Diagnostic> {
        let missing = || {
            let kind = DiagnosticKind::missing_key("the HydroDyn file", name);
            Diagnostic::new(0..0, kind).with_hint("a value is written before its name on a line")
        };
        self.token(name).ok_or_else(missing)
    }

    /// A number that must exist.
    pub(super) fn number(&self, name: &str) -> Result<f64, Diagnostic> {
        let token = self.expect(name)?;
        self.check_commas(name)?;
        token.number(name)
    }

    /// A number that may be missing.
    pub(super) fn number_or(&self, name: &str, default: f64) -> Result<f64, Diagnostic> {
        match self.token(name) {
            Some(_) => self.number(name),
            None => Ok(default),
        }
    }

    /// A positive number.
    pub(super) fn positive(&self, name: &str) -> Result<f64, Diagnostic> {
        let value = self.number(name)?;
        match value > 0.0 {
            true => Ok(value),
            false => {
                let kind = DiagnosticKind::out_of_range(name, value, "positive");
                Err(self.expect(name)?.wrong(kind))
            }
        }
    }

    fn check_commas(&self, name: &str) -> Result<(), Diagnostic> {
        self.line(name)
            .map_or(Ok(()), |line| line.check_commas(name))
    }
}
