//! All tests of the sweeps.

mod memory;
mod parts;
mod summary;
mod tables;
mod towers;
