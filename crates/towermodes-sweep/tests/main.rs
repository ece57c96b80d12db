//! All tests of the sweeps.

mod memory;
mod parts;
mod tables;
mod towers;
