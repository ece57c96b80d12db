//! Errors of slices.

use std::io;
use std::ops::Range;
use std::path::PathBuf;

use thiserror::Error;

use crate::rows::run_error::RunError;
use crate::table::TableError;

/// Why a slice cannot be written, or slices cannot be read together.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SliceError {
    /// Rows that the sweep does not have.
    #[error(
        "the sweep has {count} rows, numbered from 0; there are no rows {}..{}",
        rows.start, rows.end
    )]
    NoSuchRows {
        /// The rows.
        rows: Range<u64>,
        /// Number of rows of the sweep.
        count: u64,
    },
    /// The values are those of other changes than the sweep has.
    #[error("the values are those of {}, but the sweep changes {}", found.join(", "), expected.join(", "))]
    OtherChanges {
        /// The changes of the values.
        found: Vec<String>,
        /// The changes of the sweep.
        expected: Vec<String>,
    },
    /// Parquet without the feature.
    #[error(
        "this build of the program has no Parquet; use CSV, or build with \
         `cargo install --path crates/towermodes-cli --features parquet`"
    )]
    NoParquet,
    /// The table cannot be read any more.
    #[error(transparent)]
    Table(#[from] TableError),
    /// The watch ended it, or the memory is full.
    #[error(transparent)]
    Run(#[from] RunError),
    /// The results cannot be written.
    #[error("the results cannot be written: {0}")]
    Output(io::Error),
    /// A slice cannot be read.
    #[error("{}: {error}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// A file that is no slice.
    #[error(
        "{} is not a slice of a sweep: it does not begin with the line `# towermodes … sweep, …` (Parquet: an entry of the footer)",
        path.display()
    )]
    NoSlice {
        /// The file.
        path: PathBuf,
    },
    /// A slice of another sweep.
    #[error("{} is a slice of another sweep: {}", path.display(), differences.join("; "))]
    OtherSweep {
        /// The file.
        path: PathBuf,
        /// The differences.
        differences: Vec<String>,
    },
    /// Two slices with the same rows.
    #[error("{} and {} both have the rows {}..{}; omit one of them", paths[0].display(), paths[1].display(), rows.start, rows.end)]
    Overlap {
        /// The files.
        paths: [PathBuf; 2],
        /// The rows.
        rows: Range<u64>,
    },
    /// A slice that is not whole.
    #[error("{} is incomplete: {detail}; write it again with --rows {}..{}", path.display(), rows.start, rows.end)]
    Damaged {
        /// The file.
        path: PathBuf,
        /// The rows that it should have.
        rows: Range<u64>,
        /// The error in words.
        detail: String,
    },
}

impl SliceError {
    pub(super) fn io(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |error| Self::Io { path, error }
    }
}
