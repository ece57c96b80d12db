//! What is said about a mistake in a file.

use std::fmt;
use std::ops::Range;

/// A mistake in a file: where, what, and what would be right.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// What is wrong, with the numbers.
    pub message: String,
    /// The bytes of the file it is about.
    pub span: Range<usize>,
    /// What would be right.
    pub hint: Option<String>,
}

impl Diagnostic {
    /// A mistake at a place.
    pub fn new(span: Range<usize>, message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            span,
            hint: None,
        }
    }

    /// The same with what would be right.
    #[must_use]
    pub fn with_hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// Line and column, both from 1 and the column in characters, of the mistake in its file's
    /// text.
    pub fn line_and_column(&self, text: &str) -> (usize, usize) {
        let mut start = self.span.start.min(text.len());
        while !text.is_char_boundary(start) {
            start -= 1;
        }
        let before = &text[..start];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = before.matches('\n').count() + 1;
        (line, before[line_start..].chars().count() + 1)
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)?;
        match &self.hint {
            Some(hint) => write!(f, " ({hint})"),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Diagnostic;

    #[test]
    fn columns_count_characters() {
        let text = "a = 1\nβ = \"ü\" # x\n";
        let at = |needle: &str| {
            let start = text.find(needle).expect("in the text");
            Diagnostic::new(start..start + 1, "").line_and_column(text)
        };
        assert_eq!(at("a"), (1, 1));
        assert_eq!(at("#"), (2, 9));
        assert_eq!(Diagnostic::new(999..1000, "").line_and_column(text), (3, 1));
    }
}
