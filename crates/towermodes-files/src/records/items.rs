//! The values of a record as in a list-directed read of Fortran: repeats, empty values, an early
//! end.

use super::line::Line;
use super::token::Token;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Largest length of a list in a deck.
pub(crate) const MAX_COUNT: usize = 100_000;
/// Largest number of values that are read from a line, because a line may be as long as a file.
const MAX_TOKENS: usize = 2 * MAX_COUNT;

/// A value of a record, its repeats, and the commas between it and the previous value.
#[derive(Debug, Clone)]
pub(crate) struct Item<'a> {
    /// The value.
    pub(crate) token: Token<'a>,
    /// Number of repetitions: `3*0.0` is three zeros.
    pub(crate) repeats: usize,
    /// Number of commas since the previous value, or since the start of the record.
    pub(crate) commas: usize,
}

/// The values of a record one after another, with the text between them.
#[derive(Debug)]
pub(crate) struct Items<'a> {
    line: Line<'a>,
    tokens: Vec<Token<'a>>,
    next: usize,
}

impl<'a> Items<'a> {
    pub(crate) fn new(line: Line<'a>) -> Self {
        let tokens = line.tokens().take(MAX_TOKENS).collect();
        let next = 0;
        Self { line, tokens, next }
    }

    /// The next value, if there is one before the record's end or a `/`.
    pub(crate) fn next_item(&mut self) -> Result<Option<Item<'a>>, Diagnostic> {
        let Some(token) = self.tokens.get(self.next).cloned() else {
            return Ok(None);
        };
        let gap = self.gap_before(self.next);
        self.next += 1;
        let (repeats, token) = repeated(token)?;
        Ok(Some(Item {
            token,
            repeats,
            commas: commas(gap),
        }))
    }

    /// The next value, which is not consumed.
    pub(crate) fn peek(&self) -> Option<&Token<'a>> {
        self.tokens.get(self.next)
    }

    /// The first word that is not a number after the next `values` values.
    pub(crate) fn label_after(&self, values: usize) -> Option<&Token<'a>> {
        let from = (self.next + values).min(self.tokens.len());
        let mut rest = self.tokens[from..].iter();
        rest.find(|token| token.text.contains(char::is_alphanumeric) && !token.is_number())
    }

    /// Whether the next value is a number after a comma without blanks.
    pub(crate) fn is_joined_number_next(&self) -> bool {
        let is_number = self.peek().is_some_and(|token| token.is_number());
        self.next > 0 && is_number && self.gap_before(self.next) == ","
    }

    /// Number of remaining values before other content.
    pub(crate) fn numbers_left(&self) -> usize {
        let rest = self.tokens[self.next.min(self.tokens.len())..].iter();
        rest.take_while(|token| token.is_number()).count()
    }

    /// Number of commas after the last value.
    pub(crate) fn commas_left(&self) -> usize {
        commas(
            self.gap_before(self.tokens.len())
                .split('/')
                .next()
                .unwrap_or_default(),
        )
    }

    /// Whether a `/` ends the values.
    pub(crate) fn ends_by_slash(&self) -> bool {
        let gap = self.gap_before(self.tokens.len());
        gap.trim_start_matches(|c: char| c.is_whitespace() || c == ',')
            .starts_with('/')
    }

    /// The text between a value, or the end of the record, and the previous value.
    fn gap_before(&self, index: usize) -> &'a str {
        let base = self.line.start;
        let from = match index.checked_sub(1) {
            Some(before) => self.tokens[before].span.end - base,
            None => 0,
        };
        let to = match self.tokens.get(index) {
            Some(token) => token.span.start - base,
            None => self.line.text.len(),
        };
        self.line.text.get(from..to).unwrap_or_default()
    }
}

fn commas(gap: &str) -> usize {
    gap.matches(',').count()
}

/// `r*c` as r and c.
fn repeated(token: Token<'_>) -> Result<(usize, Token<'_>), Diagnostic> {
    let Some((count, value)) = token.text.split_once('*').filter(|_| !token.is_quoted) else {
        return Ok((1, token));
    };
    let Some(repeats) = count.parse::<usize>().ok().filter(|&repeats| repeats > 0) else {
        return Ok((1, token));
    };
    if value.is_empty() {
        let kind = DiagnosticKind::NoValue {
            what: format!("`{}`", token.text),
            reason: "there is no number after the `*`",
        };
        return Err(token.wrong(kind).with_hint("write each value"));
    }
    let start = token.span.end - value.len();
    let value = Token {
        text: value,
        span: start..token.span.end,
        is_quoted: false,
    };
    Ok((repeats, value))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn items(text: &str) -> Vec<(String, usize, usize)> {
        let mut items = Items::new(Line { text, start: 7 });
        std::iter::from_fn(|| items.next_item().ok().flatten())
            .map(|item| (item.token.text.to_owned(), item.repeats, item.commas))
            .collect()
    }

    #[test]
    fn repeats_and_commas_are_seen() {
        let expected = [("1.0", 1, 0), ("0.5", 3, 1), ("2", 1, 2)];
        let expected = expected.map(|(text, repeats, commas)| (text.to_owned(), repeats, commas));
        assert_eq!(items("1.0, 3*0.5,,2 / rest"), expected);
        assert!(
            Items::new(Line {
                text: "4*",
                start: 0
            })
            .next_item()
            .is_err()
        );
    }

    #[test]
    fn a_slash_ends_the_values() {
        let mut values = Items::new(Line {
            text: "1 , / 2",
            start: 0,
        });
        assert!(values.next_item().is_ok());
        assert!(values.ends_by_slash());
        assert_eq!(values.commas_left(), 1);
        assert!(
            !Items::new(Line {
                text: "1 2",
                start: 0
            })
            .ends_by_slash()
        );
    }

    #[test]
    fn a_decimal_comma_is_seen() {
        let mut items = Items::new(Line {
            text: "3,5e5 tip_mass",
            start: 0,
        });
        assert!(items.next_item().is_ok());
        assert!(items.is_joined_number_next());
    }
}
