//! All tests of the sweeps.

mod memory;
mod parts;
mod summary;
#[cfg(feature = "parquet")]
mod table_parquet;
mod tables;
mod towers;
