//! The rows of a text and their cells, each with its place, which CSV libraries do not provide.
//!
//! Source of the syntax: RFC 4180 (Shafranovich, 2005), with the separators and the byte order mark
//! of spreadsheets.

use std::borrow::Cow;
use std::ops::Range;

use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// A cell: its text without quotation marks and blanks around it, and its byte range in the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Cell<'a> {
    pub(crate) text: Cow<'a, str>,
    pub(crate) span: Range<usize>,
}

/// A row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Record<'a> {
    pub(crate) cells: Vec<Cell<'a>>,
    pub(crate) span: Range<usize>,
}

/// The rows of a text one after another, without empty rows and comments, which begin with `#`.
#[derive(Debug, Clone)]
pub(crate) struct Records<'a> {
    text: &'a str,
    next: usize,
    delimiter: char,
}

impl<'a> Records<'a> {
    /// Finds the column separator: that of `sep=` in the first line, otherwise the semicolon, the
    /// tab or the comma of the header.
    pub(crate) fn new(text: &'a str) -> Self {
        let next = if text.starts_with('\u{feff}') { 3 } else { 0 };
        let mut records = Self {
            text,
            next,
            delimiter: ',',
        };
        records.skip_empty();
        let line = records.line();
        let said = line.trim_end().strip_prefix("sep=");
        let said = said.and_then(|said| said.chars().next().or(Some('\t')));
        if let Some(delimiter) = said {
            records.delimiter = delimiter;
            records.next = (records.next + line.len() + 1).min(text.len());
            return records;
        }
        let outside = |c: char| line.split('"').step_by(2).any(|part| part.contains(c));
        let found = [';', '\t'].into_iter().find(|c| outside(*c));
        records.delimiter = found.unwrap_or(',');
        records
    }

    /// The column separator.
    pub(crate) fn delimiter(&self) -> char {
        self.delimiter
    }

    /// The rest of the line, without its end.
    fn line(&self) -> &'a str {
        let rest = &self.text[self.next..];
        rest.split('\n').next().unwrap_or_default()
    }

    /// Skips empty lines and comments.
    fn skip_empty(&mut self) {
        while self.next < self.text.len() {
            let line = self.line();
            let is_gap = |c: char| c.is_whitespace() || c == self.delimiter;
            if !line.trim_start().starts_with('#') && !line.chars().all(is_gap) {
                return;
            }
            self.next = (self.next + line.len() + 1).min(self.text.len());
        }
    }

    /// The cell at the next byte, and whether it is the last of its row.
    fn cell(&mut self) -> Result<(Cell<'a>, bool), Diagnostic> {
        let rest = &self.text[self.next..];
        let is_blank = |c: char| c != self.delimiter && c != '\n' && c.is_whitespace();
        let start = self.next + (rest.len() - rest.trim_start_matches(is_blank).len());
        let (text, end) = match self.text[start..].starts_with('"') {
            true => self.quoted(start)?,
            false => self.plain(start),
        };
        let rest = &self.text[end..];
        let after = end + (rest.len() - rest.trim_start_matches(is_blank).len());
        let next = self.text[after..].chars().next();
        match next {
            None => self.next = self.text.len(),
            Some(c) if c == '\n' || c == self.delimiter => self.next = after + c.len_utf8(),
            Some(c) => {
                let kind = syntax("text follows the closing quotation mark of a cell");
                let hint = "write a quotation mark within a cell twice";
                let span = after..after + c.len_utf8();
                return Err(Diagnostic::new(span, kind).with_hint(hint));
            }
        }
        let span = start..end;
        Ok((Cell { text, span }, next != Some(self.delimiter)))
    }

    /// The text of a cell without quotation marks that begins at a byte, and its end.
    fn plain(&self, start: usize) -> (Cow<'a, str>, usize) {
        let rest = &self.text[start..];
        let length = rest.find([self.delimiter, '\n']).unwrap_or(rest.len());
        let text = rest[..length].trim_end();
        (Cow::Borrowed(text), start + text.len())
    }

    /// The text of a cell whose opening quotation mark is at a byte, and the end of its closing
    /// one.
    fn quoted(&self, start: usize) -> Result<(Cow<'a, str>, usize), Diagnostic> {
        let inner = &self.text[start + 1..];
        let mut from = 0;
        let mut is_doubled = false;
        while let Some(at) = inner[from..].find('"') {
            let close = from + at;
            if !inner[close + 1..].starts_with('"') {
                let text = &inner[..close];
                let text = match is_doubled {
                    true => Cow::Owned(text.replace("\"\"", "\"").trim().to_owned()),
                    false => Cow::Borrowed(text.trim()),
                };
                return Ok((text, start + close + 2));
            }
            is_doubled = true;
            from = close + 2;
        }
        let kind = syntax("this quotation mark is not closed");
        Err(Diagnostic::new(start..start + 1, kind))
    }
}

fn syntax(reason: &str) -> DiagnosticKind {
    DiagnosticKind::Syntax {
        format: "CSV",
        reason: reason.to_owned(),
    }
}

impl<'a> Iterator for Records<'a> {
    type Item = Result<Record<'a>, Diagnostic>;

    fn next(&mut self) -> Option<Self::Item> {
        self.skip_empty();
        let start = self.next;
        if start >= self.text.len() {
            return None;
        }
        let mut cells: Vec<Cell<'a>> = Vec::new();
        loop {
            match self.cell() {
                Ok((cell, is_last)) => {
                    cells.push(cell);
                    if is_last {
                        break;
                    }
                }
                Err(mistake) => {
                    // The rest cannot be read.
                    self.next = self.text.len();
                    return Some(Err(mistake));
                }
            }
        }
        let end = cells.last().map_or(start, |cell| cell.span.end);
        let start = cells.first().map_or(start, |cell| cell.span.start);
        let span = start..end.max(start);
        Some(Ok(Record { cells, span }))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::Records;

    fn cells(text: &str) -> Vec<Vec<String>> {
        let records = Records::new(text);
        let texts =
            |cells: Vec<super::Cell<'_>>| cells.iter().map(|c| c.text.to_string()).collect();
        records
            .map(|record| texts(record.expect("a row").cells))
            .collect()
    }

    #[test]
    fn separators_are_found_in_the_header() {
        for text in [
            "a,b,c\n1,2,3",
            "\u{feff}a;b;c\r\n1;2;3\r\n",
            "a\tb\tc\n\n1\t2\t3\n",
            "sep=;\na;b;c\n1;2;3\n",
            "sep=|\na|b|c\n1|2|3\n",
            "# cans\n\n\"a\" , \"b\", c \n;\n 1 , 2 , 3 \n , , \n",
        ] {
            let rows = cells(text).into_iter().filter(|row| row.len() == 3);
            assert_eq!(
                rows.collect::<Vec<_>>(),
                [["a", "b", "c"], ["1", "2", "3"]],
                "{text}"
            );
        }
        assert_eq!(cells("\"a;x\",b\n1,\n"), [["a;x", "b"], ["1", ""]]);
        assert_eq!(cells("a\n\"x \"\"y\"\"\nz\"\n"), [["a"], ["x \"y\"\nz"]]);
    }

    #[test]
    fn cells_know_their_places() {
        let text = "\u{feff}height [m] ; \"wall\"\r\n 1,5;\"27\"\r\n";
        let records: Vec<_> = Records::new(text).map(|r| r.expect("a row")).collect();
        for (cell, expected) in
            records
                .iter()
                .flat_map(|r| &r.cells)
                .zip(["height [m]", "\"wall\"", "1,5", "\"27\""])
        {
            assert_eq!(&text[cell.span.clone()], expected);
        }
        assert_eq!(&text[records[1].span.clone()], "1,5;\"27\"");
    }

    #[test]
    fn broken_quotation_marks_end_the_reading_at_their_place() {
        let mistake = |text: &str| {
            let mut records = Records::new(text);
            let mistake = records.find_map(Result::err).expect("a mistake");
            assert!(records.next().is_none());
            mistake.line_and_column(text)
        };
        assert_eq!(mistake("a,b\n1,\"2\n3,4\n"), (2, 3));
        assert_eq!(mistake("a,b\n1,\"2\"x\n"), (2, 6));
    }

    proptest! {
        #[test]
        fn rows_are_those_of_the_csv_library(
            rows in prop::collection::vec(prop::collection::vec("[a-z0-9 ,.\"\n]{0,6}", 2..4), 1..6),
        ) {
            let mut writer = csv::WriterBuilder::new().flexible(true).from_writer(Vec::new());
            for row in &rows {
                writer.write_record(row).expect("written");
            }
            let bytes = writer.into_inner().expect("written");
            let text = String::from_utf8(bytes).expect("text");
            let expected: Vec<Vec<String>> = csv::ReaderBuilder::new()
                .has_headers(false)
                .flexible(true)
                .from_reader(text.as_bytes())
                .records()
                .map(|row| row.expect("a row").iter().map(|cell| cell.trim().to_owned()).collect())
                .filter(|row: &Vec<String>| row.iter().any(|cell| !cell.is_empty()))
                .collect();
            let found: Vec<Vec<String>> = cells(&text)
                .into_iter()
                .filter(|row| row.iter().any(|cell| !cell.is_empty()))
                .collect();
            prop_assert_eq!(found, expected);
        }
    }
}
