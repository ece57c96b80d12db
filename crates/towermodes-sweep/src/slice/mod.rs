//! Slices: the results of successive rows of a sweep as a table in CSV or Parquet.
//!
//! ```text
//! # towermodes 1.0.0 sweep, tower 01…, values 23…, options 45…, rows 0..50000 of 100000
//! row,rna.mass,mass_kg,certified,fore_aft_1_hz,fore_aft_1_error_hz,fore_aft_1_share,error
//! 0,350000.0,347374.41444767383,true,0.32146,…
//! ```
//!
//! The first line, in Parquet an entry of the footer, identifies the sweep and the range of rows. A
//! row is a function of the sweep and its number, so any process may write any slice, and a slice
//! always has the same bytes. [`Slices`] reads slices together: it refuses those of another sweep
//! and lists the missing rows.

mod column;
mod csv;
mod error;
mod header;
#[cfg(feature = "parquet")]
mod parquet;
mod part;
mod read;
mod slices;
mod write;

pub use error::SliceError;
pub use slices::Slices;
pub use write::{Slice, SliceFormat, Solved, rows_within};
