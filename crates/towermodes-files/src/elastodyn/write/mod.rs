//! ElastoDyn tower files as text: newly written, or with new coefficients in the existing text.

pub(super) mod columns;
pub(super) mod diff;
pub(super) mod make;
pub(super) mod patch;
pub(super) mod writer;
