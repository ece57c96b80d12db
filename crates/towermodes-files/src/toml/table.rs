//! A TOML table whose keys are known.

use std::ops::Range;

use serde_spanned::Spanned;
use toml::de::{DeTable, DeValue};

use super::Reading;
use crate::diagnostic::Diagnostic;

/// The keys a table may have.
pub(super) struct Keys {
    /// The keys that are read.
    pub(super) known: &'static [&'static str],
    /// Keys of the format that this version does not compute with; to ignore them would be a wrong answer.
    pub(super) planned: &'static [&'static str],
}

/// A table, where it stands, and what it is called in messages.
pub(super) struct Table<'a> {
    entries: &'a DeTable<'a>,
    pub(super) span: Range<usize>,
    name: String,
}

impl<'a> Table<'a> {
    /// The whole file.
    pub(super) fn root(entries: &'a DeTable<'a>, length: usize) -> Self {
        Self {
            entries,
            span: length..length,
            name: "the file".into(),
        }
    }

    /// A value that should be a table.
    pub(super) fn of(
        value: &'a Spanned<DeValue<'a>>,
        name: impl Into<String>,
        reading: &mut Reading,
    ) -> Option<Self> {
        let name = name.into();
        match value.get_ref() {
            DeValue::Table(entries) => Some(Self {
                entries,
                span: value.span(),
                name,
            }),
            other => {
                let message = format!("{name} must be a table, not {}", kind(other));
                reading.mistake(Diagnostic::new(value.span(), message));
                None
            }
        }
    }

    /// What it is called in messages.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Complains about keys that mean nothing, with the nearest one that does.
    pub(super) fn check_keys(&self, keys: &Keys, reading: &mut Reading) {
        for key in self.entries.keys() {
            let name: &str = key.get_ref();
            if keys.known.contains(&name) {
                continue;
            }
            let diagnostic = if keys.planned.contains(&name) {
                let message = format!("`{name}` is not computed with by this version");
                Diagnostic::new(key.span(), message).with_hint(format!(
                    "remove it to solve the tower without it; ignoring `{name}` silently would give a wrong answer"
                ))
            } else {
                let message = format!("`{name}` is not a key of {}", self.name);
                Diagnostic::new(key.span(), message).with_hint(suggestion(name, keys.known))
            };
            reading.mistake(diagnostic);
        }
    }

    /// A value that may be there.
    pub(super) fn get(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.entries.get(key)
    }

    /// A value that must be there.
    pub(super) fn require(
        &self,
        key: &str,
        hint: &str,
        reading: &mut Reading,
    ) -> Option<&'a Spanned<DeValue<'a>>> {
        let value = self.get(key);
        if value.is_none() {
            let message = format!("{} has no `{key}`", self.name);
            reading.mistake(Diagnostic::new(self.span.clone(), message).with_hint(hint));
        }
        value
    }

    /// All entries, in the order of their names.
    pub(super) fn entries(&self) -> impl Iterator<Item = (&'a str, &'a Spanned<DeValue<'a>>)> {
        self.entries
            .iter()
            .map(|(key, value)| (&**key.get_ref(), value))
    }
}

/// The nearest known key, or all of them.
pub(super) fn suggestion(name: &str, known: &[&str]) -> String {
    let distance = |key: &&&str| strsim::damerau_levenshtein(name, key);
    let nearest = known.iter().min_by_key(distance);
    match nearest.filter(|key| distance(key) <= 1 + key.len() / 3) {
        Some(nearest) => format!("did you mean `{nearest}`?"),
        None => format!("it may have {}", known.join(", ")),
    }
}

/// What a value is, in words.
pub(super) fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
