//! The lines of a file.

use std::ops::Range;

use super::token::{Token, Tokens};
use crate::diagnostic::Diagnostic;

/// A line of a file, without its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Line<'a> {
    /// Its text.
    pub(crate) text: &'a str,
    /// Where it starts in the file, bytes.
    pub(crate) start: usize,
}

impl<'a> Line<'a> {
    /// The bytes of the file it takes.
    pub(crate) fn span(&self) -> Range<usize> {
        self.start..self.start + self.text.len()
    }

    /// Its values: separated by blanks, tabs or commas, up to a `/`; what is in quotes is one value.
    pub(crate) fn tokens(&self) -> Tokens<'a> {
        Tokens::new(self.text, self.start)
    }

    /// Its first value.
    pub(crate) fn first(&self) -> Option<Token<'a>> {
        self.tokens().next()
    }

    /// Whether there is nothing on it.
    pub(crate) fn is_blank(&self) -> bool {
        self.text.trim().is_empty()
    }
}

/// The lines of a file one after the other.
#[derive(Debug, Clone)]
pub(crate) struct Lines<'a> {
    text: &'a str,
    next: usize,
}

impl<'a> Lines<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        // A byte order mark is no text.
        let next = if text.starts_with('\u{feff}') { 3 } else { 0 };
        Self { text, next }
    }

    /// The next line without reading past it.
    pub(crate) fn peek(&self) -> Option<Line<'a>> {
        self.clone().next()
    }

    /// The next line, or what was expected there.
    pub(crate) fn expect(&mut self, what: &str) -> Result<Line<'a>, Diagnostic> {
        self.next().ok_or_else(|| self.ended(what))
    }

    /// The next line that is not blank, or what was expected there.
    pub(crate) fn expect_filled(&mut self, what: &str) -> Result<Line<'a>, Diagnostic> {
        self.by_ref()
            .find(|line| !line.is_blank())
            .ok_or_else(|| self.ended(what))
    }

    /// The mistake that the file ends before something.
    pub(crate) fn ended(&self, what: &str) -> Diagnostic {
        let end = self.text.trim_end().len();
        Diagnostic::new(end..end, format!("the file ends where {what} is expected"))
            .with_hint("is it complete?")
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        let rest = self.text.get(self.next..).filter(|rest| !rest.is_empty())?;
        let start = self.next;
        let length = rest.find('\n').unwrap_or(rest.len());
        self.next += (length + 1).min(rest.len());
        let text = rest[..length].strip_suffix('\r').unwrap_or(&rest[..length]);
        Some(Line { text, start })
    }
}

#[cfg(test)]
mod tests {
    use super::Lines;

    #[test]
    fn lines_have_no_ends_and_keep_their_places() {
        let text = "\u{feff}a b\r\n\nlast";
        let lines: Vec<_> = Lines::new(text).collect();
        let texts: Vec<_> = lines.iter().map(|line| line.text).collect();
        assert_eq!(texts, ["a b", "", "last"]);
        assert!(
            lines
                .iter()
                .all(|line| text[line.span()].starts_with(line.text))
        );
    }
}
