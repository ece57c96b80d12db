//! Tower files of ElastoDyn as text: written anew, or with new coefficients in the text that is
//! there.

pub(super) mod columns;
pub(super) mod diff;
pub(super) mod make;
pub(super) mod patch;
pub(super) mod writer;
