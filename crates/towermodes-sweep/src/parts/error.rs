//! What can go wrong with a folder of results.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use super::{MAX_PARTS, MAX_ROWS_PER_PART, Shard};
use crate::run::RunError;
use crate::table::TableError;

/// What went wrong with a folder of results.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PartsError {
    /// A file or the folder cannot be read or written.
    #[error("{}: {error}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// The folder has the results of another sweep.
    #[error(
        "{} has the results of another sweep; choose another folder, or remove these results. Different: {}",
        folder.display(), differences.join("; ")
    )]
    OtherSweep {
        /// The folder.
        folder: PathBuf,
        /// What differs.
        differences: Vec<String>,
    },
    /// The plan in the folder cannot be read.
    #[error("{} is damaged: {detail}; remove the results in this folder or choose another", path.display())]
    Plan {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        detail: String,
    },
    /// A part that this sweep did not write.
    #[error("{} is not a part of this sweep: {reason}; choose another folder, or remove these results", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
        /// What is different.
        reason: String,
    },
    /// A file that would be read as a part and that no sweep has written, in a folder whose results
    /// are to be removed.
    #[error(
        "{} has the name of a part, but is not known to be a result of a sweep; choose another folder, or remove this file yourself",
        path.display()
    )]
    NotResults {
        /// The file.
        path: PathBuf,
    },
    /// Another run has removed the results, or has begun another sweep in the folder.
    #[error(
        "{} was removed or replaced by another run, so this sweep is ended; start it again in a folder of its own",
        path.display()
    )]
    Replaced {
        /// The plan.
        path: PathBuf,
    },
    /// A part that was there is not any more.
    #[error(
        "{} {reason}: another program has changed the folder; the same command computes this part again",
        path.display()
    )]
    Lost {
        /// The file.
        path: PathBuf,
        /// What it is now.
        reason: &'static str,
    },
    /// A part that the sweep does not have.
    #[error("part {part} does not exist; the sweep has {count}, numbered from 0")]
    NoSuchPart {
        /// The number of the part.
        part: u64,
        /// The number of parts.
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
    /// One of several shards would remove the results of the others.
    #[error(
        "--force removes the results of all shards, so it is not possible with --shard {shard}; remove the folder first, then start the shards"
    )]
    ForceOfShard {
        /// The shard.
        shard: Shard,
    },
    /// No rows in a part, or too many.
    #[error("the number of rows per part is {rows}; it must be from 1 to {MAX_ROWS_PER_PART}")]
    RowsPerPart {
        /// The number.
        rows: u64,
    },
    /// More parts than a folder can have.
    #[error(
        "{rows} rows in parts of {rows_per_part} are {} parts, but a folder has at most {MAX_PARTS}; use at least {least} rows per part",
        rows.div_ceil(*rows_per_part)
    )]
    ManyParts {
        /// The number of rows.
        rows: u64,
        /// The number of rows per part.
        rows_per_part: u64,
        /// The least number of rows per part.
        least: u64,
    },
    /// Parquet without the feature.
    #[error(
        "this build of the program does not write Parquet; write CSV, or build with \
         `cargo install --path crates/towermodes-cli --features parquet`"
    )]
    NoParquet,
    /// The table cannot be read any more.
    #[error(transparent)]
    Table(#[from] TableError),
    /// The watch ended it, or the memory is full.
    #[error(transparent)]
    Run(#[from] RunError),
    /// Parquet cannot hold the results.
    #[error("{}: {detail}", path.display())]
    Unwritable {
        /// The file.
        path: PathBuf,
        /// Why.
        detail: String,
    },
    /// A complete folder whose part cannot be read.
    #[error("{}: {detail}; run the sweep again to write this part anew", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        detail: String,
    },
}

impl PartsError {
    pub(super) fn io(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |error| Self::Io { path, error }
    }
}
