//! All tests of the sweeps.

mod memory;
mod towers;
