//! What is asked of a solve: options, their checks and limits, and the cost before it begins.

pub(super) mod added_mass;
pub(super) mod checks;
pub(super) mod cost;
pub(super) mod limits;
pub(super) mod options;
