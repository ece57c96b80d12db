//! Tables in CSV: separated by commas, semicolons or tabs.

use std::io::{self, BufReader, Read, Seek, SeekFrom};
use std::ops::Range;

use csv::{ByteRecord, ErrorKind, ReaderBuilder};
use towermodes::TowerDescription;

use super::error::{CellError, RowPlace, TableProblem};
use super::file::TableFile;
use super::header::Header;
use super::lines::{Lines, Wrong};

/// Number of rows between two stored positions.
const BLOCK: u64 = 1024;

/// A checked table in CSV.
#[derive(Debug)]
pub(super) struct CsvTable {
    separator: u8,
    /// Byte and line at which every [`BLOCK`]th row begins.
    blocks: Vec<Start>,
}

/// The position at which a row begins.
#[derive(Debug, Clone, Copy)]
struct Start {
    byte: u64,
    line: u64,
}

impl CsvTable {
    /// Reads the whole file and checks every cell.
    pub(super) fn check(
        file: &mut TableFile,
        base: &TowerDescription,
        ignore: &[String],
    ) -> Result<(Header, u64, Self), TableProblem> {
        let separator = separator(file)?;
        file.read_through(|reader| check_all(reader, separator, base, ignore))
    }

    /// Reads a range of rows.
    pub(super) fn read(
        &self,
        file: &TableFile,
        header: &Header,
        rows: Range<u64>,
    ) -> Result<Vec<f64>, TableProblem> {
        let mut values =
            Vec::with_capacity((rows.end - rows.start) as usize * header.columns.len());
        let Some(start) = self.blocks.get((rows.start / BLOCK) as usize) else {
            return Ok(values);
        };
        let mut file = file.lock();
        file.seek(SeekFrom::Start(start.byte))?;
        let mut records = Records::new(&mut *file, self.separator, start.line);
        let mut row = rows.start / BLOCK * BLOCK;
        while row < rows.end {
            if !records.next()? {
                return Err(TableProblem::Changed);
            }
            if row >= rows.start {
                records.numbers(header, &mut values)?;
            }
            row += 1;
        }
        Ok(values)
    }
}

/// Reads all records of a table.
fn check_all(
    reader: &mut dyn Read,
    separator: u8,
    base: &TowerDescription,
    ignore: &[String],
) -> Result<(Header, u64, CsvTable), TableProblem> {
    let mut records = Records::new(reader, separator, 1);
    if !records.next()? {
        return Err(TableProblem::NoColumns);
    }
    let header = Header::new(records.names()?, base, ignore)?;
    let (mut rows, mut blocks, mut values) = (0, Vec::new(), Vec::new());
    while records.next()? {
        if rows % BLOCK == 0 {
            blocks.push(records.start);
        }
        values.clear();
        if rows == 0 {
            records.refuse_units(&header)?;
        }
        records.numbers(&header, &mut values)?;
        rows += 1;
    }
    if let Some(line) = records.empty_line() {
        return Err(TableProblem::EmptyLine { line });
    }
    Ok((header, rows, CsvTable { separator, blocks }))
}

/// The separator of a table: a tab or a semicolon if the first line contains one, otherwise a
/// comma.
fn separator(file: &TableFile) -> Result<u8, TableProblem> {
    let mut file = file.lock();
    file.seek(SeekFrom::Start(0))?;
    let mut start = Vec::new();
    file.by_ref().take(1 << 20).read_to_end(&mut start)?;
    let first = start.split(|byte| matches!(byte, b'\n' | b'\r')).next();
    let first = first.unwrap_or_default();
    let has = |separator: &u8| first.contains(separator);
    Ok([b'\t', b';'].into_iter().find(has).unwrap_or(b','))
}

/// The records of a table, one after another.
struct Records<R> {
    reader: csv::Reader<BufReader<Lines<R>>>,
    record: ByteRecord,
    /// The position at which the record begins.
    start: Start,
    /// The line after the record.
    next_line: u64,
}

impl<R: Read> Records<R> {
    fn new(reader: R, separator: u8, line: u64) -> Self {
        let lines = Lines::new(reader, separator, line);
        let reader = BufReader::with_capacity(1 << 16, lines);
        Self {
            reader: ReaderBuilder::new()
                .delimiter(separator)
                .has_headers(false)
                .flexible(true)
                .from_reader(reader),
            record: ByteRecord::new(),
            start: Start { byte: 0, line },
            next_line: line,
        }
    }

    /// Reads the next record; false at the end of the table.
    fn next(&mut self) -> Result<bool, TableProblem> {
        let read = self.reader.read_byte_record(&mut self.record);
        if !read.map_err(|error| self.problem(error))? {
            return Ok(false);
        }
        self.start = Start {
            byte: self.record.position().map_or(0, |position| position.byte()),
            line: self.next_line,
        };
        // The reader passes over empty lines.
        if let Some(line) = self.empty_line().filter(|line| *line <= self.next_line) {
            return Err(TableProblem::EmptyLine { line });
        }
        // A quoted cell may have several lines.
        self.next_line += 1 + self.record.iter().map(line_ends).sum::<u64>();
        Ok(true)
    }

    /// The first empty line that is followed by another line, in the text read so far.
    fn empty_line(&self) -> Option<u64> {
        self.reader.get_ref().get_ref().empty_line
    }

    fn problem(&self, error: csv::Error) -> TableProblem {
        let wrong = |error: &io::Error| error.get_ref()?.downcast_ref::<Wrong>().copied();
        match error.into_kind() {
            ErrorKind::Io(error) => match wrong(&error) {
                Some(Wrong::Long { line }) => TableProblem::LongLine { line },
                Some(Wrong::Open { line }) => TableProblem::OpenQuote { line },
                None => TableProblem::Io(error),
            },
            other => TableProblem::Io(io::Error::other(format!("{other:?}"))),
        }
    }

    /// The cells of the record as names of columns.
    fn names(&self) -> Result<Vec<String>, TableProblem> {
        let name = |cell: &[u8]| match std::str::from_utf8(cell) {
            Ok(text) => Ok(text.trim().to_owned()),
            Err(_) => Err(TableProblem::NotUtf8),
        };
        self.record.iter().map(name).collect()
    }

    /// Appends the values of the changes in the record.
    fn numbers(&self, header: &Header, values: &mut Vec<f64>) -> Result<(), TableProblem> {
        let line = self.start.line;
        if self.record.len() != header.names.len() {
            return Err(TableProblem::Width {
                line,
                found: self.record.len(),
                expected: header.names.len(),
            });
        }
        for &column in &header.columns {
            let number = number(&self.record[column]);
            values.push(number.map_err(|error| TableProblem::Cell {
                place: RowPlace::Line(line),
                column: header.names[column].clone(),
                error,
            })?);
        }
        Ok(())
    }

    /// Refuses a first row in which no cell is a number.
    fn refuse_units(&self, header: &Header) -> Result<(), TableProblem> {
        let mut cells = header.columns.iter().filter_map(|&i| self.record.get(i));
        let is_text = |cell: &[u8]| matches!(number(cell), Err(CellError::Text { .. }));
        let Some(text) = cells.clone().find(|cell| is_text(cell)) else {
            return Ok(());
        };
        match cells.any(|cell| number(cell).is_ok()) {
            true => Ok(()),
            false => Err(TableProblem::UnitRow {
                line: self.start.line,
                text: shown(text),
            }),
        }
    }
}

/// The number in a cell.
fn number(cell: &[u8]) -> Result<f64, CellError> {
    let text = std::str::from_utf8(cell).unwrap_or("\u{fffd}").trim();
    if text.is_empty() {
        return Err(CellError::Empty);
    }
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(value) => Err(CellError::NotFinite { value }),
        Err(_) if text.replacen(',', ".", 1).parse::<f64>().is_ok() => {
            let text = text.to_owned();
            Err(CellError::DecimalComma { text })
        }
        Err(_) => Err(CellError::Text { text: shown(cell) }),
    }
}

/// The number of line ends in a cell.
fn line_ends(cell: &[u8]) -> u64 {
    let is_end = |(index, byte): (usize, &u8)| match byte {
        b'\n' => true,
        b'\r' => cell.get(index + 1) != Some(&b'\n'),
        _ => false,
    };
    cell.iter().enumerate().filter(|pair| is_end(*pair)).count() as u64
}

/// The first 40 characters of a cell.
fn shown(cell: &[u8]) -> String {
    String::from_utf8_lossy(cell)
        .trim()
        .chars()
        .take(40)
        .collect()
}
