//! The frequencies of a turbine, each between two eigenvalue counts.

pub(super) mod approach;
pub(super) mod falling;
pub(super) mod frequencies;
pub(super) mod recount;
pub(super) mod search;
mod water;
