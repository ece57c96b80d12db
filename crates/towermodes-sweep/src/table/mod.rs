//! Tables of rows in files: a column for each change, CSV or Parquet.
//!
//! A table is read completely when it is opened: every mistake in it is found before the first row
//! is solved. Afterwards any range of rows is read with bounded memory.

mod csv;
mod error;
mod file;
mod header;
mod lines;
#[cfg(feature = "parquet")]
mod parquet;

pub use error::{CellError, RowPlace, TableError, TableProblem};

use std::ops::Range;
use std::path::Path;

use towermodes::{Change, TowerDescription};
use towermodes_files::MAX_ROWS;

use file::{Kind, TableFile};
use header::Header;

/// A table in a file: a column for each change, with the name of the change (`rna.mass`,
/// `scale(stations[*].wall)`), and a row for each tower.
///
/// Every column must be an input value of the base: a column with another name is refused, so that
/// a misspelled name is never ignored silently. Other columns are skipped if their names begin with
/// `#` or are in a list of columns to ignore.
///
/// CSV is separated by commas, semicolons or tabs and has decimal points; a name with a comma is in
/// double quotes. Parquet has columns of the types DOUBLE, FLOAT, INT32 or INT64, compressed with
/// Snappy or ZSTD, or uncompressed.
///
/// # Example
/// ```
/// use towermodes::{Material, Rna, Station, TowerDescription};
/// use towermodes_sweep::Table;
///
/// let base = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// };
/// let path = std::env::temp_dir().join(format!("towers-{}.csv", std::process::id()));
/// std::fs::write(&path, "#site,rna.mass,scale(stations[*].wall)\nA,3.3e5,1.02\nB,3.4e5,0.98\n")?;
/// let table = Table::open(&path, &base, &[])?;
/// assert_eq!(table.read(1..2)?, [3.4e5, 0.98]);
///
/// std::fs::write(&path, "rna.mas\n3.3e5\n")?;
/// let error = Table::open(&path, &base, &[]).expect_err("a misspelled name");
/// assert!(error.to_string().contains("did you mean `rna.mass`?"));
/// # std::fs::remove_file(path)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
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
    /// Opens a table for a base, and checks all its cells.
    ///
    /// # Errors
    /// [`TableError`] with the line or row, the column, and a suggestion.
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

    /// Reads rows, numbered from 0: the values row by row.
    ///
    /// # Errors
    /// [`TableError`] if the file has changed since it was opened, or can no longer be read.
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
