//! Values of a TOML text with their places and mistakes.

pub(super) mod choice;
pub(super) mod entry;
pub(super) mod kind;
pub(super) mod names;
pub(super) mod numbers;
pub(super) mod reading;
pub(super) mod rewrite;
pub(super) mod syntax;
pub(super) mod table;
pub(super) mod values;
