//! A mistake in a file: its place, its kind with the numbers, and a suggestion.

mod kind;

use std::fmt;
use std::ops::Range;

pub use kind::{DiagnosticKind, Exact};

/// A mistake in a file: its place, the problem, and a suggestion.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnostic {
    /// The problem, with its numbers.
    pub kind: DiagnosticKind,
    /// The byte range of the mistake in the file.
    pub span: Range<usize>,
    /// A suggestion.
    pub hint: Option<String>,
}

impl Diagnostic {
    /// A mistake at a place.
    pub fn new(span: Range<usize>, kind: DiagnosticKind) -> Self {
        let hint = None;
        Self { kind, span, hint }
    }

    /// The mistake with a suggestion.
    #[must_use]
    pub fn with_hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// The problem as a message.
    pub fn message(&self) -> String {
        self.kind.to_string()
    }

    /// Line and column, both from 1 and the column in characters, of the mistake in its file's
    /// text.
    pub fn line_and_column(&self, text: &str) -> (usize, usize) {
        line_and_column(text, self.span.start)
    }
}

/// Line and column, both from 1 and the column in characters, of a byte of a text.
pub(crate) fn line_and_column(text: &str, byte: usize) -> (usize, usize) {
    let mut start = byte.min(text.len());
    while !text.is_char_boundary(start) {
        start -= 1;
    }
    let before = &text[..start];
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = before.matches('\n').count() + 1;
    (line, before[line_start..].chars().count() + 1)
}

/// The first 40 characters of a text, in backquotes: the content found in a file.
pub(crate) fn quoted(text: &str) -> String {
    let start: String = text.chars().take(40).collect();
    format!("`{start}`")
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.kind)?;
        match &self.hint {
            Some(hint) => write!(f, " ({hint})"),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::line_and_column;

    #[test]
    fn columns_count_characters() {
        let text = "a = 1\nβ = \"ü\" # x\n";
        let at = |needle: &str| line_and_column(text, text.find(needle).expect("in the text"));
        assert_eq!(at("a"), (1, 1));
        assert_eq!(at("#"), (2, 9));
        assert_eq!(line_and_column(text, 999), (3, 1));
    }
}
