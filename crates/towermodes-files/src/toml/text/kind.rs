//! Tables of several kinds with different keys: the key `type` names the kind.

use towermodes::Place;

use super::super::schema::TableSchema;
use super::choice::{ChoiceWords, choices_hint, one_of};
use super::reading::Reading;
use super::table::Table;
use super::values::Value;

/// A kind of table.
pub(crate) trait TableKind {
    /// The table in messages: `[foundation]`.
    const TABLE: &str;
    /// The words for its type.
    const WORDS: ChoiceWords;

    /// Its name in the file.
    fn name(&self) -> &'static str;

    /// Its keys.
    fn schema(&self) -> &'static TableSchema;
}

/// The kind that a table names; without one its other keys are only compared with those of all
/// kinds.
pub(crate) fn kind_of<K: TableKind>(
    value: &Value<'_>,
    place: Place,
    kinds: &'static [K],
    reading: &mut Reading,
) -> Option<&'static K> {
    let has_type = value
        .get_ref()
        .as_table()
        .is_none_or(|table| table.contains_key("type"));
    let table = if has_type {
        Table::with_any_keys(value, K::TABLE, reading)?
    } else {
        let known = kinds.iter().flat_map(|kind| kind.schema().key_names());
        Table::with_known_keys(value, K::TABLE, known.collect(), |_| None, reading)?
    };
    let choices: Vec<(&'static str, &'static K)> =
        kinds.iter().map(|kind| (kind.name(), kind)).collect();
    let value = table.require("type", &choices_hint("type", &choices), reading)?;
    reading.remember(place, value.span());
    one_of(value, K::WORDS, &choices, reading)
}

/// The kinds to which a key belongs, for the hint in a table of another kind.
pub(crate) fn owners<K: TableKind>(key: &str, kinds: &[K]) -> Option<String> {
    let owners = kinds.iter().filter(|kind| kind.schema().key(key).is_some());
    let owners: Vec<String> = owners.map(|kind| format!("\"{}\"", kind.name())).collect();
    (!owners.is_empty()).then(|| format!("it belongs to type = {}", owners.join(" or ")))
}
