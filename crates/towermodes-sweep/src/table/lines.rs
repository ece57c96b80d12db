//! The lines of a table in CSV as they are read: empty ones, ones that are too long, and quotation
//! marks that are not closed.

use std::io::{self, Read};

/// A longer row is refused before it fills the memory.
pub(super) const MAX_LINE_BYTES: u64 = 64 << 20;

/// A cell in quotation marks with more lines is one whose second quotation mark is missing: the
/// reader of CSV would take the rows below for its text.
pub(super) const MAX_CELL_LINES: u64 = 100;

/// A reader that fails at a row that no table has, and finds empty lines.
pub(super) struct Lines<R> {
    reader: R,
    separator: u8,
    /// The line of the next byte, from 1.
    line: u64,
    /// Bytes of the row, which may have several lines.
    row_bytes: u64,
    cell: Cell,
    /// The line in which the quoted cell begins.
    cell_line: u64,
    /// Whether the last byte was a carriage return, to which a line feed belongs.
    is_returned: bool,
    /// An empty line that may be at the end of the file.
    last_empty: Option<u64>,
    /// The first empty line that is before another one.
    pub(super) empty_line: Option<u64>,
    /// What is wrong; the rows before it are read first.
    wrong: Option<Wrong>,
}

/// Where in a cell the reader is, by the rules of RFC 4180.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Cell {
    /// Before its first byte, where a quotation mark opens it.
    Start,
    /// In plain text, where a quotation mark is one.
    Plain,
    /// Between quotation marks.
    Quoted,
    /// Behind a quotation mark that closes the cell or is doubled.
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

    /// `line` is the next one already.
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
        for byte in &buffer[..count] {
            self.pass(*byte);
        }
        if count == 0 && self.cell == Cell::Quoted {
            let line = self.cell_line;
            return Err(io::Error::other(Wrong::Open { line }));
        }
        Ok(count)
    }
}
