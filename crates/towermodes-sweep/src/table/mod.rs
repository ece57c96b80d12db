//! Tables of rows in files: a column for each change, CSV or Parquet.
//!
//! A table is read through once when it is opened: every mistake in it is found before the first
//! row is solved. Afterwards any range of rows is read in bounded memory.

mod csv;
mod error;
mod file;
mod header;
#[cfg(feature = "parquet")]
mod parquet;

pub use error::{CellError, RowPlace, TableError, TableProblem};

use std::ops::Range;
use std::path::Path;

use towermodes::{Change, TowerDescription};
use towermodes_files::MAX_ROWS;

use file::{Kind, TableFile};
use header::Header;

/// A table in a file: a column for each change, named by it (`rna.mass`,
/// `scale(stations[*].wall)`), and a row for each tower.
///
/// Every column must be a number of the base: a column with another name is refused, so that a
/// misspelled name never leaves a sweep unchanged. Columns that are no numbers of the tower are
/// left out if their names begin with `#` or are in a list of columns to ignore.
#[derive(Debug)]
pub struct Table {
    file: TableFile,
    header: Header,
    rows: u64,
    content: Content,
}

#[derive(Debug)]
enum Content {
    Csv(csv::CsvTable),
    #[cfg(feature = "parquet")]
    Parquet(Box<parquet::ParquetTable>),
}

impl Table {
    /// Opens a table for a base, and checks all of it.
    ///
    /// # Errors
    /// [`TableError`] with the line or row, the column, and what would be right.
    pub fn open(
        path: &Path,
        base: &TowerDescription,
        ignore: &[String],
    ) -> Result<Self, TableError> {
        let name = path.display().to_string();
        let problem = |problem| TableError::new(&name, problem);
        let mut file = TableFile::open(path).map_err(problem)?;
        let (header, rows, content) = match file.kind() {
            Kind::Csv => {
                let (header, rows, table) =
                    csv::CsvTable::check(&mut file, base, ignore).map_err(problem)?;
                (header, rows, Content::Csv(table))
            }
            #[cfg(feature = "parquet")]
            Kind::Parquet => {
                let (header, rows, table) =
                    parquet::ParquetTable::check(&mut file, base, ignore).map_err(problem)?;
                (header, rows, Content::Parquet(Box::new(table)))
            }
            #[cfg(not(feature = "parquet"))]
            Kind::Parquet => return Err(problem(TableProblem::NoParquet)),
        };
        match rows {
            0 => Err(problem(TableProblem::NoRows)),
            rows if rows > MAX_ROWS => Err(problem(TableProblem::TooManyRows { rows })),
            _ => Ok(Self {
                file,
                header,
                rows,
                content,
            }),
        }
    }

    /// The name of its file.
    pub fn name(&self) -> &str {
        self.file.name()
    }

    /// The changes of its columns.
    pub fn changes(&self) -> &[Change] {
        &self.header.changes
    }

    /// Number of rows.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// The SHA-256 of its file in hexadecimal digits.
    pub fn digest(&self) -> &str {
        self.file.digest()
    }

    /// Reads rows, numbered from 0: the values of each row side by side.
    ///
    /// # Errors
    /// [`TableError`] if the file has changed since it was opened, or cannot be read any more.
    ///
    /// # Panics
    /// If there are no such rows.
    pub fn read(&self, rows: Range<u64>) -> Result<Vec<f64>, TableError> {
        assert!(rows.start <= rows.end && rows.end <= self.rows);
        let values = match &self.content {
            Content::Csv(table) => table.read(&self.file, &self.header, rows),
            #[cfg(feature = "parquet")]
            Content::Parquet(table) => table.read(&self.file, &self.header, rows),
        };
        // A file that has changed explains any other problem.
        let values = self.file.check_unchanged().and(values);
        values.map_err(|problem| TableError::new(self.name(), problem))
    }
}
