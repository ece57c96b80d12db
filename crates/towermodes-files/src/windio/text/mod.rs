//! The text of a windIO file: YAML as values with their places, the keys that are read, notes and
//! mistakes.

pub(super) mod airfoils;
pub(super) mod known_keys;
pub(super) mod outline;
pub(super) mod reading;
pub(super) mod values;
pub(super) mod yaml;
