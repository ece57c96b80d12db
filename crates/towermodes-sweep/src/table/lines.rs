//! Checks of the lines of a CSV table while it is read: empty lines, lines that are too long, and
//! quotation marks that are not closed.

use std::io::{self, Read};

/// A longer row is refused, so that it does not use up the memory.
pub(super) const MAX_LINE_BYTES: u64 = 64 << 20;

/// In a quoted cell with more lines than this, the second quotation mark is missing: the CSV reader
/// would read the following rows as its text.
pub(super) const MAX_CELL_LINES: u64 = 100;

/// A reader that fails at a row that is too long or not closed, and finds empty lines.
pub(super) struct Lines<R> {
    reader: R,
    separator: u8,
    /// The line of the next byte, from 1.
    line: u64,
    /// Number of bytes of the row so far, which may have several lines.
    row_bytes: u64,
    cell: Cell,
    /// The line in which the quoted cell begins.
    cell_line: u64,
    /// Whether the last byte was a carriage return, which may be followed by its line feed.
    is_returned: bool,
    /// An empty line that may be at the end of the file.
    last_empty: Option<u64>,
    /// The first empty line that is followed by another line.
    pub(super) empty_line: Option<u64>,
    /// The error; the rows before it are read first.
    wrong: Option<Wrong>,
}

/// The state of the reader within a cell, by the rules of RFC 4180.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Cell {
    /// Before the first byte, where a quotation mark opens a quoted cell.
    Start,
    /// In plain text, where a quotation mark is part of the text.
    Plain,
    /// Between quotation marks.
    Quoted,
    /// After a quotation mark that closes the cell or is the first of two.
    Closed,
}

/// The error of [`Lines`], with the line in which the row or the cell begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub(super) enum Wrong {
    #[error("line {line} is too long")]
    Long { line: u64 },
    #[error("line {line} has a quotation mark that is not closed")]
    Open { line: u64 },
}

impl<R> Lines<R> {
    /// A reader of a table, or of its rows from a line on.
    pub(super) fn new(reader: R, separator: u8, line: u64) -> Self {
        Self {
            reader,
            separator,
            line,
            row_bytes: 0,
            cell: Cell::Start,
            cell_line: line,
            // The byte of a row below the first may be the line feed that ends the row above.
            is_returned: line > 1,
            last_empty: None,
            empty_line: None,
            wrong: None,
        }
    }

    /// Reads a whole row at once if it contains no quotation mark and no carriage return, as nearly
    /// all rows do. For any other text returns false and reads nothing.
    fn pass_plain(&mut self, line: &[u8]) -> bool {
        let is_at_start = self.row_bytes == 0 && self.cell == Cell::Start && !self.is_returned;
        let is_row = is_at_start && matches!(line, [_, .., b'\n']);
        // Without an early end, so that many bytes are compared at once.
        let is_special = |found: bool, byte: &u8| found | (*byte == b'"') | (*byte == b'\r');
        if !is_row || line.iter().fold(false, is_special) {
            return false;
        }
        if let Some(line) = self.last_empty.take() {
            self.empty_line.get_or_insert(line);
        }
        self.line += 1;
        self.cell_line = self.line;
        true
    }

    fn pass(&mut self, byte: u8) {
        let is_second = byte == b'\n' && self.is_returned;
        self.is_returned = byte == b'\r';
        let is_end = matches!(byte, b'\n' | b'\r');
        self.line += u64::from(is_end && !is_second);
        if self.cell != Cell::Quoted && is_end {
            if !is_second {
                self.end_row();
            }
            return;
        }
        self.row_bytes += 1;
        if let Some(line) = self.last_empty.take() {
            self.empty_line.get_or_insert(line);
        }
        self.cell = self.cell.behind(byte, self.separator);
        match self.cell {
            Cell::Quoted if self.line > self.cell_line + MAX_CELL_LINES => {
                let line = self.cell_line;
                self.wrong.get_or_insert(Wrong::Open { line });
            }
            Cell::Quoted => {}
            _ => self.cell_line = self.line,
        }
        if self.row_bytes > MAX_LINE_BYTES {
            let line = self.cell_line;
            self.wrong.get_or_insert(Wrong::Long { line });
        }
    }

    /// Ends a row; `line` already is the next line.
    fn end_row(&mut self) {
        if self.row_bytes == 0 {
            self.last_empty.get_or_insert(self.line - 1);
        }
        self.row_bytes = 0;
        self.cell = Cell::Start;
        self.cell_line = self.line;
    }
}

impl Cell {
    fn behind(self, byte: u8, separator: u8) -> Self {
        match (self, byte) {
            (Self::Start | Self::Closed, b'"') => Self::Quoted,
            (Self::Quoted, b'"') => Self::Closed,
            (Self::Quoted, _) => Self::Quoted,
            // The byte order mark of a file is before its first cell.
            (Self::Start, 0xef | 0xbb | 0xbf) => Self::Start,
            (_, byte) if byte == separator => Self::Start,
            _ => Self::Plain,
        }
    }
}

impl<R: Read> Read for Lines<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if let Some(wrong) = self.wrong {
            return Err(io::Error::other(wrong));
        }
        let count = self.reader.read(buffer)?;
        for line in buffer[..count].split_inclusive(|byte| *byte == b'\n') {
            if !self.pass_plain(line) {
                line.iter().for_each(|byte| self.pass(*byte));
            }
        }
        if count == 0 && self.cell == Cell::Quoted {
            let line = self.cell_line;
            return Err(io::Error::other(Wrong::Open { line }));
        }
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::Lines;
    use std::io::Read;

    /// The result of reading a text in pieces of this many bytes: number of lines, the empty line,
    /// the error.
    fn found(text: &str, piece: usize) -> (u64, Option<u64>, Option<String>) {
        let mut lines = Lines::new(text.as_bytes(), b',', 1);
        let mut buffer = vec![0; piece];
        loop {
            match lines.read(&mut buffer) {
                Ok(0) => return (lines.line, lines.empty_line, None),
                Ok(_) => {}
                Err(wrong) => return (lines.line, lines.empty_line, Some(wrong.to_string())),
            }
        }
    }

    #[test]
    fn findings_do_not_depend_on_the_pieces_in_which_a_text_arrives() {
        let open = Some("line 2 has a quotation mark that is not closed".to_owned());
        let cases = [
            ("a,b\n1,2\n3,4\n", (4, None, None)),
            ("a,b\r\n1,2\r\n\r\n3,4\r\n", (5, Some(3), None)),
            ("a,b\n\n1,2\n\n", (5, Some(2), None)),
            ("a,b\n1,2\n\n\n", (5, None, None)),
            ("a,b\n\"1\n\n\",2\n3,4\n", (6, None, None)),
            ("a,b\n1,\"2\n3,4\n", (4, None, open)),
            ("\u{feff}a,b\n1,2", (2, None, None)),
            ("a,b\r1,2\r\r3,4\n", (5, Some(3), None)),
        ];
        for (text, expected) in cases {
            for piece in [1, 2, 3, 5, 7, 64] {
                assert_eq!(
                    found(text, piece),
                    expected,
                    "{text:?} in pieces of {piece}"
                );
            }
        }
    }
}
