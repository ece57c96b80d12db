//! The rows of a sweep, solved independently by several threads, and the results as columns.

pub(super) mod failed;
pub(super) mod results;
pub(super) mod row;
pub(super) mod run;
pub(super) mod run_error;
pub(super) mod stream;
pub(super) mod threads;
pub(super) mod warned;
