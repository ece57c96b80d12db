//! All tests of the sweeps.

mod correlation;
mod first_order;
mod memory;
mod names;
mod slices;
mod summary;
#[cfg(feature = "parquet")]
mod table_parquet;
mod tables;
mod towers;
