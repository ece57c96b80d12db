//! A key of a foundation whose value is one of several names.

use super::at;
use crate::toml::choice::{choices_hint, chosen};
use crate::toml::reading::Reading;
use crate::toml::table::Table;

/// The choice that a required key names.
pub(super) fn choice<T: Copy>(
    table: &Table<'_>,
    key: &'static str,
    what: &'static str,
    choices: &[(&'static str, T)],
    reading: &mut Reading,
) -> Option<T> {
    let value = table.require(key, &choices_hint(key, choices), reading)?;
    reading.remember(at(key), value.span());
    chosen(value, what, choices, reading)
}
