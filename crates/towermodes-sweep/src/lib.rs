//! Sweeps: one tower with changed input values, solved for each row of a table or a sample.
//!
//! | item | step |
//! |---|---|
//! | [`Base`] | the tower that is changed, and how its file prescribes to solve it |
//! | [`Sweep`] | the [changes](towermodes::Change) of each row, and the modes with columns |
//! | [`Columns`], [`Draw`], [`Table`] | the values: in memory, drawn, from a file |
//! | [`run()`], [`Results`] | all rows in memory |
//! | [`Slice`], [`Slices`] | any rows into a file as they are solved; files of one sweep together |
//! | [`FirstOrder`] | mean and deviation of frequencies from derivatives, without rows |
//! | [`Summary`] | statistics, failures, violated resonance margins |
//!
//! A row that fails contains the error message and does not end the sweep. The columns of modes are
//! named by [family and order](towermodes::ModeName), so a mode stays in its column where
//! frequencies cross. Results are equal bit by bit for any number of threads and any division into
//! slices with the same build; builds for other systems may differ in the last digits.
//!
//! Each frequency is extrapolated, by default from meshes around [`DEFAULT_SWEEP_SEGMENTS`]
//! segments. Parquet needs the feature `parquet`.

mod base;
mod digest;
mod first;
mod first_order;
mod lowest;
mod remedy;
mod rows;
mod sampling;
mod slice;
mod source;
mod summary;
mod sweep;
mod sweep_source;
mod table;

pub use base::{Base, DEFAULT_SWEEP_SEGMENTS};
pub use first_order::{FirstOrder, FirstOrderError, InputScatter, ModeScatter, NoScatter, Scatter};
pub use remedy::Remedy;
pub use rows::failed::FailedRows;
pub use rows::results::Results;
pub use rows::row::{MORE_MODES, named, number_at};
pub use rows::run::run;
pub use rows::run_error::RunError;
pub use rows::threads::Watch;
pub use rows::warned::RowRemarks;
pub use sampling::Draw;
pub use slice::{Slice, SliceError, SliceFormat, Slices, Solved, rows_within};
pub use source::{Columns, LengthsDiffer, RowSource, SourceBlock};
pub use summary::{
    FailureKind, MarginCheck, MarginCounts, MarginSummary, ModeSummary, QUANTILES, Statistics,
    Summary,
};
pub use sweep::{MOST_MODES, Sweep, SweepError};
pub use sweep_source::SweepSource;
pub use table::{CellError, RowPlace, Table, TableError, TableProblem};
