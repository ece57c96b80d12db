//! The request of a solve: options, their checks and limits, and the estimated cost.

pub(super) mod added_mass;
pub(super) mod checks;
pub(super) mod cost;
pub(super) mod limits;
pub(super) mod options;
