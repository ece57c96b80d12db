//! Errors of a table.

use std::fmt;

use thiserror::Error;
use towermodes::ParameterError;
use towermodes_files::MAX_ROWS;

use super::lines::{MAX_CELL_LINES, MAX_LINE_BYTES};

/// The largest number of columns.
pub(super) const MOST_COLUMNS: usize = 10_000;

/// An error of a table, with the name of the table.
#[derive(Debug, Error)]
#[error("{name}: {problem}")]
pub struct TableError {
    /// The name of the file.
    pub name: String,
    /// The problem.
    #[source]
    pub problem: Box<TableProblem>,
}

impl TableError {
    pub(super) fn new(name: &str, problem: TableProblem) -> Self {
        Self {
            name: name.to_owned(),
            problem: Box::new(problem),
        }
    }
}

/// The error of a table.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TableProblem {
    /// The file cannot be read.
    #[error("{0}")]
    Io(#[from] std::io::Error),
    /// The file is a folder, a pipe or a device.
    #[error(
        "is not a regular file; a table is read twice, so a pipe must be saved to a file first"
    )]
    NotAFile,
    /// The file has another format.
    #[error("is {kind}, not a table in CSV or Parquet; {remedy}")]
    OtherFormat {
        /// The kind of the file.
        kind: &'static str,
        /// How to make a table from it.
        remedy: &'static str,
    },
    /// A Parquet file in a build without the feature `parquet`.
    #[error(
        "is a Parquet file, which this build of the program does not read; write the table as CSV, or build with \
         `cargo install --path crates/towermodes-cli --features parquet`"
    )]
    NoParquet,
    /// The file changed while it was in use.
    #[error("has changed since the sweep began; begin again")]
    Changed,
    /// The first line contains no names.
    #[error(
        "has no columns; the first line must name the input values to change, as `towermodes parameters` lists them"
    )]
    NoColumns,
    /// The first line contains numbers.
    #[error(
        "the first line begins with the number `{text}`; it must name the input values to change, as `towermodes parameters` lists them"
    )]
    NoNames {
        /// The first cell.
        text: String,
    },
    /// More columns than the limit, which is larger than the number of input values of any tower.
    #[error(
        "has {columns} columns; the limit is {MOST_COLUMNS}: rows are towers, columns are input values of a tower"
    )]
    TooManyColumns {
        /// The number of columns.
        columns: usize,
    },
    /// A column without a name.
    #[error(
        "column {column} has no name; name the input value to change, or begin the name with # to skip the column"
    )]
    EmptyName {
        /// The column, from 1.
        column: usize,
    },
    /// Two columns with the same name.
    #[error("columns {first} and {second} have the same name `{name}`; remove one of them")]
    RepeatedName {
        /// The name.
        name: String,
        /// The first column, from 1.
        first: usize,
        /// The second column, from 1.
        second: usize,
    },
    /// A column whose name is not an input value of the base.
    #[error(
        "column {column}: {error}{}",
        and_others(*others)
    )]
    Unknown {
        /// The name.
        name: String,
        /// The column, from 1.
        column: usize,
        /// Number of other unknown columns.
        others: usize,
        /// Why it is not an input value of the base.
        error: ParameterError,
    },
    /// Two columns that change the same input value.
    #[error("{0}")]
    Contradiction(ParameterError),
    /// A column to be ignored does not exist.
    #[error("has no column `{name}` to ignore; its columns are {columns}")]
    NothingToIgnore {
        /// The name.
        name: String,
        /// The names of the columns.
        columns: String,
    },
    /// All columns are ignored.
    #[error("all columns are skipped; at least one must name an input value to change")]
    NothingVaried,
    /// A header without rows.
    #[error("has no rows below the names of its columns")]
    NoRows,
    /// More rows than a sweep may have.
    #[error("has {rows} rows; the limit is {MAX_ROWS}")]
    TooManyRows {
        /// The number of rows.
        rows: u64,
    },
    /// A second header line.
    #[error(
        "line {line} contains no number, only text such as `{text}`; if these are units, remove the line: the units are those of `towermodes parameters`"
    )]
    UnitRow {
        /// The line.
        line: u64,
        /// The first cell.
        text: String,
    },
    /// A line whose number of cells differs from the number of columns.
    #[error("line {line} has {found} cells, but the first line has {expected}")]
    Width {
        /// The line.
        line: u64,
        /// Its number of cells.
        found: usize,
        /// The number of columns.
        expected: usize,
    },
    /// An empty line between rows.
    #[error("line {line} is empty; remove it, or write the values of the row")]
    EmptyLine {
        /// The line.
        line: u64,
    },
    /// A line that is too long for a row of a table.
    #[error("line {line} is longer than {} MiB; this is not a table of numbers", MAX_LINE_BYTES >> 20)]
    LongLine {
        /// The line.
        line: u64,
    },
    /// A quotation mark that is not closed.
    #[error(
        "line {line}: a cell begins with a quotation mark that is not closed in the next {MAX_CELL_LINES} lines; \
         close it or remove it"
    )]
    OpenQuote {
        /// The line.
        line: u64,
    },
    /// Names that are not valid UTF-8.
    #[error("the names of the columns are not UTF-8; save the table as UTF-8")]
    NotUtf8,
    /// A cell that is not a number.
    #[error("{place}, column `{column}`: {error}")]
    Cell {
        /// The position of the row.
        place: RowPlace,
        /// The name of the column.
        column: String,
        /// The error of the cell.
        error: CellError,
    },
    /// A column of a type that is not numeric.
    #[error(
        "column `{column}` has the type {found}; numbers of the types DOUBLE, FLOAT, INT32 and INT64 are read"
    )]
    ColumnType {
        /// The name of the column.
        column: String,
        /// The type of the column.
        found: String,
    },
    /// A compression codec that this build does not support.
    #[error(
        "column `{column}` is compressed with {codec}; write the file with Snappy or ZSTD or without compression (compression=\"snappy\" in pandas and polars)"
    )]
    Compression {
        /// The name of the column.
        column: String,
        /// The codec.
        codec: String,
    },
    /// A Parquet file that is damaged.
    #[error("the Parquet file is damaged: {detail}")]
    Damaged {
        /// The error found by the reader.
        detail: String,
    },
}

fn and_others(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => " (and 1 other column is not an input value either)".to_owned(),
        count => format!(" (and {count} other columns are not either)"),
    }
}

/// The position of a row in a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RowPlace {
    /// In a text: the line, from 1.
    Line(u64),
    /// In a Parquet file: the row, from 0.
    Row(u64),
}

impl fmt::Display for RowPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Row(row) => write!(f, "row {row} (counted from 0)"),
        }
    }
}

/// Why a cell is not a number.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum CellError {
    /// The cell is empty.
    #[error("the cell is empty; it must be a number")]
    Empty,
    /// The cell is null.
    #[error("the cell is null; it must be a number")]
    Null,
    /// The number is not finite.
    #[error("the value is {value}; it must be a finite number")]
    NotFinite {
        /// The value.
        value: f64,
    },
    /// The cell has a decimal comma, or a comma that separates thousands.
    #[error("`{text}` has {}", without_comma(text))]
    DecimalComma {
        /// The text.
        text: String,
    },
    /// The cell contains text.
    #[error("`{text}` is not a number")]
    Text {
        /// The text, at most 40 characters.
        text: String,
    },
}

/// The possible meanings of the comma, and the number to write instead. A comma before exactly
/// three digits may separate thousands.
fn without_comma(text: &str) -> String {
    let point = text.replace(',', ".");
    let is_group = |digits: &str| digits.len() == 3 && digits.bytes().all(|b| b.is_ascii_digit());
    match text.split_once(',') {
        Some((_, digits)) if is_group(digits) => format!(
            "a comma; write `{}` if it separates thousands, `{point}` if it is a decimal comma",
            text.replace(',', "")
        ),
        _ => format!("a decimal comma; write `{point}`"),
    }
}
