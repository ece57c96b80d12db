//! Why rows are not solved to their end.

use thiserror::Error;

/// Why the rows of a sweep are not solved to their end.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum RunError {
    /// The [`Watch`](crate::Watch) stopped it.
    #[error("the sweep was stopped")]
    Stopped,
    /// The number of values of a row differs from the number of changes of the sweep.
    #[error(
        "the rows have {values} values, but the sweep has {changes} changes; give one value for each change"
    )]
    Width {
        /// Number of values of a row.
        values: usize,
        /// Number of changes.
        changes: usize,
    },
    /// The results need more memory than is available.
    #[error("the results of {rows} rows do not fit into memory; solve fewer rows at a time")]
    Memory {
        /// Number of rows.
        rows: u64,
    },
}
