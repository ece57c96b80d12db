//! The values of a line.

use std::ops::Range;

use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};

/// One value of a line, as written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Token<'a> {
    /// The text, without quotes.
    pub(crate) text: &'a str,
    /// Its byte range in the file, including quotes.
    pub(crate) span: Range<usize>,
    /// Whether it is in quotes.
    pub(crate) is_quoted: bool,
}

impl Token<'_> {
    /// The finite number; as in Fortran, exponents may be written with d or, if they have three
    /// digits, without a letter.
    pub(crate) fn number(&self, what: &str) -> Result<f64, Diagnostic> {
        let with_e = || self.text.replace(['d', 'D'], "e").parse::<f64>().ok();
        let parsed = match self.is_quoted {
            true => None,
            false => {
                let plain = self.text.parse().ok();
                plain.or_else(with_e).or_else(|| without_letter(self.text))
            }
        };
        match parsed {
            Some(value) if value.is_finite() => Ok(value),
            Some(value) => Err(self.wrong(DiagnosticKind::not_finite(what, value))),
            None => Err(self.wrong_type(what, "a number")),
        }
    }

    /// Whether it is a finite number.
    pub(crate) fn is_number(&self) -> bool {
        self.number("").is_ok()
    }

    /// The whole number.
    pub(crate) fn integer(&self, what: &str) -> Result<i64, Diagnostic> {
        let parsed = match self.is_quoted {
            true => None,
            false => self.text.parse().ok(),
        };
        parsed.ok_or_else(|| self.wrong_type(what, "a whole number"))
    }

    /// The logical value: anything that begins with T or F, or with a point and one of these.
    pub(crate) fn logical(&self, what: &str) -> Result<bool, Diagnostic> {
        let letters = self.text.strip_prefix('.').unwrap_or(self.text);
        match letters.chars().next().filter(|_| !self.is_quoted) {
            Some('t' | 'T') => Ok(true),
            Some('f' | 'F') => Ok(false),
            _ => Err(self.wrong_type(what, "true or false")),
        }
    }

    /// A mistake at this value.
    pub(crate) fn wrong(&self, kind: DiagnosticKind) -> Diagnostic {
        Diagnostic::new(self.span.clone(), kind)
    }

    /// The mistake of a value of another type.
    fn wrong_type(&self, what: &str, expected: &str) -> Diagnostic {
        self.wrong(DiagnosticKind::wrong_type(
            what,
            expected,
            quoted(self.text),
        ))
    }
}

/// A number such as `1.5-101`: Fortran omits the letter before an exponent of three digits.
fn without_letter(text: &str) -> Option<f64> {
    let sign = text
        .len()
        .checked_sub(4)
        .filter(|&at| text.is_char_boundary(at))?;
    let (mantissa, exponent) = text.split_at(sign);
    let has_sign = exponent.starts_with(['+', '-']);
    let is_exponent = has_sign && exponent[1..].bytes().all(|byte| byte.is_ascii_digit());
    let is_mantissa = mantissa.contains('.') && mantissa.ends_with(|c: char| c.is_ascii_digit());
    match is_exponent && is_mantissa {
        true => format!("{mantissa}e{exponent}").parse().ok(),
        false => None,
    }
}

/// The values of a line, one after another.
#[derive(Debug, Clone)]
pub(crate) struct Tokens<'a> {
    text: &'a str,
    start: usize,
    next: usize,
}

impl<'a> Tokens<'a> {
    pub(super) fn new(text: &'a str, start: usize) -> Self {
        let next = 0;
        Self { text, start, next }
    }
}

/// Whether a character separates values.
fn is_gap(c: char) -> bool {
    c.is_whitespace() || c == ','
}

/// Number of bytes before the next value. Almost all gaps are a few spaces, which need no decoding.
fn gap_length(text: &str) -> usize {
    let spaces = text.bytes().take_while(|byte| *byte == b' ').count();
    let rest = &text[spaces..];
    match rest.as_bytes().first() {
        Some(byte) if byte.is_ascii_graphic() && *byte != b',' => spaces,
        _ => spaces + rest.find(|c| !is_gap(c)).unwrap_or(rest.len()),
    }
}

/// Number of bytes of the value at the beginning of a text: up to the next gap or slash.
fn value_length(text: &str) -> usize {
    let is_inside = |byte: &u8| byte.is_ascii_graphic() && !matches!(*byte, b',' | b'/');
    let plain = text.bytes().take_while(is_inside).count();
    let rest = &text[plain..];
    let end = rest.find(|c| is_gap(c) || c == '/');
    plain + end.unwrap_or(rest.len())
}

impl<'a> Iterator for Tokens<'a> {
    type Item = Token<'a>;

    fn next(&mut self) -> Option<Token<'a>> {
        let rest = self.text.get(self.next..)?;
        let from = self.next + gap_length(rest);
        let rest = &self.text[from..];
        let first = rest.chars().next().filter(|c| *c != '/')?;
        let is_quote = first == '"' || first == '\'';
        let (inner, length) = if is_quote {
            let inner = rest[1..].split(first).next().unwrap_or_default();
            (inner, (inner.len() + 2).min(rest.len()))
        } else {
            let length = value_length(rest);
            (&rest[..length], length)
        };
        self.next = from + length;
        let span = self.start + from..self.start + from + length;
        Some(Token {
            text: inner,
            span,
            is_quoted: is_quote,
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::records::{Line, Token};

    fn tokens(text: &str) -> Vec<Token<'_>> {
        Line { text, start: 0 }.tokens().collect()
    }

    #[test]
    fn values_end_at_blanks_commas_and_slashes() {
        let texts = |text| -> Vec<String> {
            tokens(text)
                .iter()
                .map(|token| token.text.to_owned())
                .collect()
        };
        assert_eq!(texts(" 1.0,2\t 3 / 4"), ["1.0", "2", "3"]);
        assert_eq!(texts("'a b/c, d' rest"), ["a b/c, d", "rest"]);
        assert_eq!(texts("\"open"), ["open"]);
        assert!(texts("/ nothing").is_empty());
        assert!(texts("").is_empty());
    }

    #[test]
    fn numbers_are_those_of_fortran() {
        let number = |text| tokens(text)[0].number("it");
        assert_eq!(number("1.5d3"), Ok(1500.0));
        assert_eq!(number("1.D0"), Ok(1.0));
        assert_eq!(number(".5E-1"), Ok(0.05));
        assert_eq!(number("1.5+003"), Ok(1500.0));
        assert_eq!(number("-2.5-101"), Ok(-2.5e-101));
        for wrong in [
            "nan", "inf", "1e999", "350000kg", "'1'", "x", "d", "1-003", "1.5+03", "1e5-003",
        ] {
            assert!(number(wrong).is_err(), "{wrong}");
        }
    }
}
