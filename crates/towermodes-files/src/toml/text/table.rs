//! A TOML table whose keys are known.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use super::super::schema::TableSchema;
use super::super::synonyms::meant;
use super::reading::Reading;
use super::values::{Value, every_row, wrong_kind};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// A table with its place, its name in messages and its schema.
pub(crate) struct Table<'a> {
    entries: &'a DeTable<'a>,
    pub(crate) span: Range<usize>,
    name: String,
    /// Its known keys; empty if its keys are names.
    known: Vec<&'static str>,
}

impl<'a> Table<'a> {
    /// The table of the whole file; reports unknown keys.
    pub(crate) fn root(
        entries: &'a DeTable<'a>,
        length: usize,
        schema: &'static TableSchema,
        reading: &mut Reading,
    ) -> Self {
        let table = Self {
            entries,
            span: length..length,
            name: schema.name.into(),
            known: schema.key_names().collect(),
        };
        table.check_keys(|_| None, reading);
        table
    }

    /// A value that should be a table with the keys of a schema; reports other keys.
    pub(crate) fn of(
        value: &'a Value<'a>,
        name: impl Into<String>,
        schema: &'static TableSchema,
        reading: &mut Reading,
    ) -> Option<Self> {
        Self::with_elsewhere(value, name, schema, |_| None, reading)
    }

    /// A value that should be a table with the keys of a schema; an unknown key may belong to
    /// another table, which `elsewhere` names.
    pub(crate) fn with_elsewhere(
        value: &'a Value<'a>,
        name: impl Into<String>,
        schema: &'static TableSchema,
        elsewhere: impl Fn(&str) -> Option<String>,
        reading: &mut Reading,
    ) -> Option<Self> {
        Self::with_known_keys(
            value,
            name,
            schema.key_names().collect(),
            elsewhere,
            reading,
        )
    }

    /// A value that should be a table with a list of known keys.
    pub(crate) fn with_known_keys(
        value: &'a Value<'a>,
        name: impl Into<String>,
        known: Vec<&'static str>,
        elsewhere: impl Fn(&str) -> Option<String>,
        reading: &mut Reading,
    ) -> Option<Self> {
        let name = name.into();
        if let (Some(number), Some(key)) = (as_number(value), known.first()) {
            let hint = format!("write {}", table_with(&name, key, number));
            return reading.refuse(wrong_kind(value, &name, "a table").with_hint(hint));
        }
        if is_list_of_numbers(value) && !name.starts_with('[') {
            let keys: Vec<String> = known
                .iter()
                .take(3)
                .map(|key| format!("{key} = ..."))
                .collect();
            let hint = format!("write {name} = {{ {} }}", keys.join(", "));
            return reading.refuse(wrong_kind(value, &name, "a table").with_hint(hint));
        }
        let mut table = Self::with_any_keys(value, name, reading)?;
        table.known = known;
        table.check_keys(elsewhere, reading);
        Some(table)
    }

    /// A value that should be a table whose keys are names.
    pub(crate) fn with_any_keys(
        value: &'a Value<'a>,
        name: impl Into<String>,
        reading: &mut Reading,
    ) -> Option<Self> {
        let name = name.into();
        match value.get_ref() {
            DeValue::Table(entries) => Some(Self {
                entries,
                span: value.span(),
                name,
                known: Vec::new(),
            }),
            _ => reading.refuse(wrong_kind(value, &name, "a table")),
        }
    }

    /// Its name in messages.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Reports unknown keys, with the table where they belong or the nearest known key.
    fn check_keys(&self, elsewhere: impl Fn(&str) -> Option<String>, reading: &mut Reading) {
        for key in self.entries.keys() {
            if reading.is_full() {
                return;
            }
            let name: &str = key.get_ref();
            if self.known.contains(&name) {
                continue;
            }
            let suggested = || suggestion(name, &self.known, "valid keys:");
            let hint = elsewhere(name).unwrap_or_else(suggested);
            let (key, table, span) = (name.to_owned(), self.name.clone(), key.span());
            let kind = DiagnosticKind::UnknownKey { key, table };
            reading.mistake(Diagnostic::new(span, kind).with_hint(hint));
        }
    }

    /// An optional value.
    pub(crate) fn get(&self, key: &str) -> Option<&'a Value<'a>> {
        self.entries.get(key)
    }

    /// Whether a key is a known key of the table.
    pub(crate) fn knows(&self, key: &str) -> bool {
        self.known.contains(&key)
    }

    /// Whether the table has a key, possibly misspelled.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.get(key).is_some() || self.has_misspelled(key)
    }

    /// A required value. A misspelled key is reported only as unknown.
    pub(crate) fn require(
        &self,
        key: &str,
        hint: &str,
        reading: &mut Reading,
    ) -> Option<&'a Value<'a>> {
        let value = self.get(key);
        if value.is_none() && !self.has_misspelled(key) {
            let kind = DiagnosticKind::missing_key(&self.name, key);
            reading.mistake(Diagnostic::new(self.span.clone(), kind).with_hint(hint));
        }
        value
    }

    /// Reports a key that has no effect, if the table has it; its value is not used.
    pub(crate) fn refuse_unused(
        &self,
        key: &str,
        because: impl Into<String>,
        hint: &str,
        reading: &mut Reading,
    ) -> Option<()> {
        let Some(value) = self.get(key) else {
            return Some(());
        };
        let (key, because) = (key.to_owned(), because.into());
        let kind = DiagnosticKind::UnusedKey { key, because };
        reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
    }

    /// Whether an unknown key looks like this one.
    pub(crate) fn has_misspelled(&self, key: &str) -> bool {
        let known = &self.known;
        let mut names = self.entries.keys().map(|name| &**name.get_ref());
        names.any(|name| !known.contains(&name) && nearest(name, known) == Some(key))
    }

    /// All entries with the places of their keys.
    pub(crate) fn placed_entries(
        &self,
    ) -> impl Iterator<Item = (&'a str, Range<usize>, &'a Value<'a>)> {
        self.entries
            .iter()
            .map(|(key, value)| (&**key.get_ref(), key.span(), value))
    }

    /// All entries, in the order of their names.
    pub(crate) fn entries(&self) -> impl Iterator<Item = (&'a str, &'a Value<'a>)> {
        self.entries
            .iter()
            .map(|(key, value)| (&**key.get_ref(), value))
    }
}

/// Every `[[key]]` of a file, made by `read` from its index and value; there may be none.
pub(crate) fn every_table<T>(
    root: &Table<'_>,
    key: &str,
    one: &str,
    reading: &mut Reading,
    mut read: impl FnMut(usize, &Value<'_>, &mut Reading) -> Option<T>,
) -> Option<Vec<T>> {
    let Some(value) = root.get(key) else {
        return Some(Vec::new());
    };
    let Some(rows) = value.get_ref().as_array() else {
        let hint = format!("write [[{key}]] in double brackets, once for each {one}");
        return reading.refuse(wrong_kind(value, key, "a list of tables").with_hint(hint));
    };
    every_row(rows, |index, row| read(index, row, reading))
}

/// The values of [`every_table`] and their names; no names if all are empty.
pub(crate) fn with_names<T>(named: Option<Vec<(T, String)>>) -> Option<(Vec<T>, Vec<String>)> {
    let (values, names): (Vec<T>, Vec<String>) = named?.into_iter().unzip();
    Some((values, all_but_empty(names)))
}

/// The names; no names if all are empty.
pub(crate) fn all_but_empty(mut names: Vec<String>) -> Vec<String> {
    if names.iter().all(String::is_empty) {
        names.clear();
    }
    names
}

/// If there are more names than this, only the first are listed and compared, because a file may
/// have any number.
const MAX_NAMES: usize = 100;
/// Longer names are not compared, because the time is proportional to the product of both lengths;
/// no key of the format is half as long.
const MAX_COMPARED_BYTES: usize = 80;

/// The nearest of the known names, or all of them after the text `there_are`.
pub(crate) fn suggestion(name: &str, known: &[&str], there_are: &str) -> String {
    let listed = listed(known);
    match nearest(name, &listed) {
        Some(nearest) => format!("did you mean `{nearest}`?"),
        None if listed.len() < known.len() => format!("{there_are} {}, …", listed.join(", ")),
        None => format!("{there_are} {}", listed.join(", ")),
    }
}

/// The names that messages list.
pub(crate) fn listed<'k>(known: &[&'k str]) -> Vec<&'k str> {
    let short = known.iter().copied().filter(is_short);
    short.take(MAX_NAMES).collect()
}

fn is_short(name: &&str) -> bool {
    name.len() <= MAX_COMPARED_BYTES
}

/// The known key that a name was probably meant to be: a synonym, or the one with the most similar
/// spelling.
fn nearest<'k>(name: &str, known: &[&'k str]) -> Option<&'k str> {
    if !is_short(&name) {
        return None;
    }
    let distance = |key: &&str| strsim::damerau_levenshtein(&name.to_lowercase(), key);
    let compared = known.iter().copied().filter(is_short);
    let nearest = compared.min_by_key(distance)?;
    // One letter is a typing error in a long word; in `xx` it may be another word.
    if nearest.len() >= 4 && distance(&nearest) <= 1 {
        return Some(nearest);
    }
    let is_near = distance(&nearest) <= 1 + nearest.len() / 3;
    meant(name, known).or(is_near.then_some(nearest))
}

/// A number given instead of a table, as written.
fn as_number<'v>(value: &'v Value<'_>) -> Option<&'v str> {
    match value.get_ref() {
        DeValue::Integer(number) => Some(number.as_str()),
        DeValue::Float(number) => Some(number.as_str()),
        DeValue::String(_)
        | DeValue::Boolean(_)
        | DeValue::Datetime(_)
        | DeValue::Array(_)
        | DeValue::Table(_) => None,
    }
}

/// Whether a list has only numbers, at least one.
fn is_list_of_numbers(value: &Value<'_>) -> bool {
    let list = value.get_ref().as_array();
    list.is_some_and(|list| !list.is_empty() && list.iter().all(|one| as_number(one).is_some()))
}

/// The table that a number probably stands for: "[gravity] with acceleration = 9.81", "scour = {
/// general = 8.0 }".
fn table_with(name: &str, key: &str, number: &str) -> String {
    match name.starts_with('[') {
        true => format!("{name} with {key} = {number}"),
        false => format!("{name} = {{ {key} = {number} }}"),
    }
}
