//! Results in a folder: parts of a fixed number of rows, each written whole or not at all.
//!
//! ```text
//! results/part-00000.parquet   rows 0 to 16383
//! results/part-00001.parquet   rows 16384 to 32767
//! results/_sweep.json          what is swept, in readable form, with its key
//! results/_SUCCESS             empty; all parts are there
//! ```
//!
//! The key is the SHA-256 of all that the results depend on; each part contains it, a part in CSV
//! in a file beside it, `_part-00000.csv.key`. A run solves
//! the parts that are not there, so the same command again continues a run that was killed, and
//! several processes may fill one folder. Parts have the same bytes whichever process of one build
//! writes them, so there is no lock: of two runs that solve one part, the later one replaces it by
//! the same.

mod block;
mod check;
mod claim;
mod content;
mod csv;
mod error;
mod folder;
mod names;
#[cfg(feature = "parquet")]
mod parquet;
mod part;
mod plan;
mod print;
mod run;
mod shard;
mod write;

pub use block::SourceBlock;
pub use error::PartsError;
pub use folder::Parts;
pub use part::PartFormat;
pub use plan::{PartOptions, SweepSource};
pub use print::results_csv;
pub use run::PartsProgress;
pub use shard::{Shard, ShardError};

/// Number of rows of a part if it is not given: a second of work, about a megabyte.
pub const DEFAULT_ROWS_PER_PART: u64 = 16_384;

/// The largest number of rows of a part, which is in memory when it is written.
pub const MAX_ROWS_PER_PART: u64 = 1 << 20;
/// The most parts of a sweep: listing a folder of more takes minutes.
pub const MAX_PARTS: u64 = 1_000_000;
