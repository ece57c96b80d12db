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
    /// A range of rows that the sweep does not have.
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
    /// The values belong to other changes than those of the sweep.
    #[error("the values are those of {}, but the sweep changes {}", found.join(", "), expected.join(", "))]
    OtherChanges {
        /// The changes of the values.
        found: Vec<String>,
        /// The changes of the sweep.
        expected: Vec<String>,
    },
    /// A Parquet file in a build without the feature `parquet`.
    #[error(
        "this build of the program has no Parquet; use CSV, or build with \
         `cargo install --path crates/towermodes-cli --features parquet`"
    )]
    NoParquet,
    /// The table can no longer be read.
    #[error(transparent)]
    Table(#[from] TableError),
    /// The watch stopped the run, or the memory is not sufficient.
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
        /// The reason.
        error: io::Error,
    },
    /// A file that is not a slice.
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
    /// Two slices that contain the same rows.
    #[error("{} and {} both have the rows {}..{}; omit one of them", paths[0].display(), paths[1].display(), rows.start, rows.end)]
    Overlap {
        /// The files.
        paths: [PathBuf; 2],
        /// The rows.
        rows: Range<u64>,
    },
    /// A slice that is incomplete or damaged.
    #[error("{} is incomplete: {detail}; write it again with --rows {}..{}", path.display(), rows.start, rows.end)]
    Damaged {
        /// The file.
        path: PathBuf,
        /// The rows that it should contain.
        rows: Range<u64>,
        /// The error as text.
        detail: String,
    },
}

impl SliceError {
    pub(super) fn io(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |error| Self::Io { path, error }
    }
}
