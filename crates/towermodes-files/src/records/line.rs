//! The lines of a file.

use std::ops::Range;

use super::token::{Token, Tokens};
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};

/// A line of a file, without its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Line<'a> {
    /// The text.
    pub(crate) text: &'a str,
    /// The byte of the file at which it starts.
    pub(crate) start: usize,
}

impl<'a> Line<'a> {
    /// Its byte range in the file.
    pub(crate) fn span(&self) -> Range<usize> {
        self.start..self.start + self.text.len()
    }

    /// Its values: separated by blanks, tabs or commas, up to a `/`. Text in quotes is one value.
    pub(crate) fn tokens(&self) -> Tokens<'a> {
        Tokens::new(self.text, self.start)
    }

    /// Its first value.
    pub(crate) fn first(&self) -> Option<Token<'a>> {
        self.tokens().next()
    }

    /// The word after the first value if this value extends over the rest of the line: a path
    /// without quotes ends at its first slash, and an unclosed quote has no end.
    pub(crate) fn name_behind_path(&self) -> Option<&'a str> {
        let mut words = self.text.split_whitespace();
        let first = words.next()?;
        let is_open = |quote: char| first.starts_with(quote) && first.matches(quote).count() == 1;
        let is_cut = first.contains('/') && !first.starts_with(['"', '\'']);
        let is_cut = is_cut || is_open('"') || is_open('\'');
        words.next().filter(|_| is_cut)
    }

    /// The name of a file, which is its first value.
    ///
    /// # Errors
    /// An unclosed quote, or a name without quotes that ends at a slash: programs that read these
    /// files do not find such a file.
    pub(crate) fn file_name(&self, what: &str) -> Result<Option<Token<'a>>, Diagnostic> {
        let Some(token) = self.first() else {
            return Ok(None);
        };
        let rest = &self.text[token.span.end - self.start..];
        let is_open = token.is_quoted && token.span.len() != token.text.len() + 2;
        if !is_open && (token.is_quoted || !rest.starts_with('/')) {
            return Ok(Some(token));
        }
        let word = self.text.split_whitespace().next().unwrap_or_default();
        let found = quoted(word);
        let kind = DiagnosticKind::wrong_type(what, "a file name between two quotes", found);
        let from = token.span.start;
        let hint = match is_open {
            true => "close the quote behind the name",
            false => "without quotes a name ends at its first `/`",
        };
        Err(Diagnostic::new(from..from + word.len(), kind).with_hint(hint))
    }

    /// The number after a decimal comma, as in `87,6`: a comma between two numbers without a blank,
    /// if there are no other numbers or the others are separated by blanks. In Fortran the comma
    /// ends the number.
    fn decimal_comma(&self) -> Option<Token<'a>> {
        let numbers: Vec<Token<'a>> = self.tokens().take_while(Token::is_number).collect();
        let is_joined = |pair: &[Token<'a>]| {
            let gap = pair[0].span.end - self.start..pair[1].span.start - self.start;
            self.text.get(gap) == Some(",")
        };
        let joined = numbers.windows(2).filter(|pair| is_joined(pair)).count();
        let all = numbers.len().saturating_sub(1);
        if joined == 0 || (joined == all && all > 1) {
            return None;
        }
        let behind = numbers.windows(2).find(|pair| is_joined(pair));
        behind.map(|pair| pair[1].clone())
    }

    /// The mistake of a decimal comma, if there is one.
    pub(crate) fn check_commas(&self, what: &str) -> Result<(), Diagnostic> {
        match self.decimal_comma() {
            Some(rest) => Err(decimal_comma(what, &rest)),
            None => Ok(()),
        }
    }

    /// Whether the line is blank.
    pub(crate) fn is_blank(&self) -> bool {
        self.text.trim().is_empty()
    }
}

/// The mistake of a decimal comma in a quantity; `rest` is the number after the comma.
pub(crate) fn decimal_comma(what: &str, rest: &Token<'_>) -> Diagnostic {
    let kind = DiagnosticKind::Comma {
        what: what.into(),
        rest: rest.text.chars().take(40).collect(),
    };
    rest.wrong(kind).with_hint(
        "write a decimal point, for example 3.5, no comma between thousands, and a blank between values",
    )
}

/// The lines of a file one after another.
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

    /// The next line, which is not consumed.
    pub(crate) fn peek(&self) -> Option<Line<'a>> {
        self.clone().next()
    }

    /// The next line, or the mistake that `what` is missing.
    pub(crate) fn expect(&mut self, what: &str) -> Result<Line<'a>, Diagnostic> {
        self.next().ok_or_else(|| self.ended(what))
    }

    /// The next line that is not blank, or the mistake that `what` is missing.
    pub(crate) fn expect_filled(&mut self, what: &str) -> Result<Line<'a>, Diagnostic> {
        self.by_ref()
            .find(|line| !line.is_blank())
            .ok_or_else(|| self.ended(what))
    }

    /// The mistake that the file ends too early.
    pub(crate) fn ended(&self, expected: &str) -> Diagnostic {
        let end = self.text.trim_end().len();
        let expected = expected.to_owned();
        Diagnostic::new(end..end, DiagnosticKind::EndOfFile { expected })
            .with_hint("is the file complete?")
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
    fn decimal_commas_are_told_from_separators() {
        let behind = |text: &str| -> Option<String> {
            let line = super::Line { text, start: 0 };
            line.decimal_comma().map(|token| token.text.to_owned())
        };
        for (text, found) in [
            ("87,6 TowerHt", "6"),
            ("240,000 NacMass", "000"),
            ("0.1 5390,43 5.8E+11 5.8E+11", "43"),
        ] {
            assert_eq!(behind(text).as_deref(), Some(found), "{text}");
        }
        for text in [
            "0.1,5390,5.8E+11,5.8E+11",
            "5, 9 TwrGagNd",
            "1, 2, 3",
            "87.6 a,b",
            "1",
        ] {
            assert_eq!(behind(text), None, "{text}");
        }
    }

    #[test]
    fn file_names_are_whole() {
        let line = |text| super::Line { text, start: 0 };
        for text in [
            "\"a/b c.dat\" EDFile",
            "'a/b.dat' EDFile",
            "a.dat EDFile",
            "a\\b.dat x",
        ] {
            let found = line(text).file_name("EDFile").expect(text).expect(text);
            assert!(
                text.contains(found.text) && found.text.ends_with(".dat"),
                "{text}"
            );
        }
        for text in [
            "a/b.dat EDFile",
            "\"a/b.dat EDFile - x",
            "'a.dat EDFile",
            "../b.dat EDFile",
        ] {
            let mistake = line(text).file_name("EDFile").expect_err(text);
            assert_eq!(mistake.span, 0..text.find(' ').expect(text), "{text}");
            assert!(mistake.message().contains("between two quotes"), "{text}");
            assert_eq!(line(text).name_behind_path(), Some("EDFile"), "{text}");
        }
        assert_eq!(line("").file_name("EDFile").expect("nothing"), None);
        assert_eq!(line("1 2 3").name_behind_path(), None);
    }

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
