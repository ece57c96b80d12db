//! Sweeps: one tower with changed numbers, solved for each row of a table or a sample.
//!
//! | item | step |
//! |---|---|
//! | [`Base`] | the tower that is changed, and how its file prescribes to solve it |
//! | [`Sweep`] | the [changes](towermodes::Change) of each row, and the modes with columns |
//! | [`Columns`], [`Draw`], [`Table`] | the values: in memory, drawn, from a file |
//! | [`run()`], [`Results`] | all rows in memory |
//! | [`Parts`], [`Shard`] | all rows into a folder, continued after a kill, shared by processes |
//! | [`FirstOrder`] | mean and deviation of frequencies from derivatives, without rows |
//! | [`Summary`] | statistics, failures, violated resonance margins |
//!
//! A row that fails is a row with the sentence that says why, never the end of the sweep. The
//! columns of modes are named by [family and order](towermodes::ModeName), so they stay with the
//! mode where frequencies cross. Results have the same bits whatever the number of threads and
//! whoever computes them with the same build; builds for other systems may differ in the last
//! digits.
//!
//! Each frequency is the extrapolated one, on [`DEFAULT_SWEEP_SEGMENTS`] segments by default.
//! Parquet needs the feature `parquet`.

mod base;
mod digest;
mod failed;
mod first;
mod first_order;
mod lowest;
mod parts;
mod remedy;
mod results;
mod row;
mod run;
mod sampling;
mod source;
mod summary;
mod sweep;
mod table;
mod threads;
mod warned;

pub use base::{Base, DEFAULT_SWEEP_SEGMENTS};
pub use failed::FailedRows;
pub use first_order::{FirstOrder, FirstOrderError, InputScatter, ModeScatter, NoScatter, Scatter};
pub use parts::{
    DEFAULT_ROWS_PER_PART, MAX_ROWS_PER_PART, PartFormat, PartOptions, Parts, PartsError,
    PartsProgress, Shard, ShardError, SourceBlock, SweepSource, results_csv,
};
pub use remedy::Remedy;
pub use results::Results;
pub use row::{MORE_MODES, named, number_at};
pub use run::{RunError, run};
pub use sampling::Draw;
pub use source::{Columns, LengthsDiffer, RowSource};
pub use summary::{
    FailureKind, MarginCheck, MarginCounts, MarginSummary, ModeSummary, QUANTILES, Statistics,
    Summary,
};
pub use sweep::{MOST_MODES, Sweep, SweepError};
pub use table::{CellError, RowPlace, Table, TableError, TableProblem};
pub use threads::Watch;
pub use warned::RowRemarks;
