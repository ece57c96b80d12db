//! A value that is one of several names.

use towermodes::inputs::Named;

use super::reading::Reading;
use super::table::suggestion;
use super::values::{Value, text};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// The words for a choice in messages.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ChoiceWords {
    /// The words for the value: "the foundation's type is a number, not a text".
    pub(crate) of_value: &'static str,
    /// The words for an unknown name: "there is no foundation of type `x`".
    pub(crate) unknown: &'static str,
    /// The words before the list of names: "types:".
    pub(crate) known: &'static str,
}

impl ChoiceWords {
    /// The words for a choice with the same noun for the value and for an unknown name.
    pub(crate) const fn of(what: &'static str) -> Self {
        Self {
            of_value: what,
            unknown: what,
            known: "names:",
        }
    }
}

/// The choices of a type with their names.
pub(crate) fn choices<T: Named>() -> Vec<(&'static str, T)> {
    let names = T::NAMES.iter().copied();
    names.zip(T::CHOICES.iter().copied()).collect()
}

/// The choice that a value names.
pub(crate) fn chosen<T: Copy>(
    value: &Value<'_>,
    what: &'static str,
    choices: &[(&'static str, T)],
    reading: &mut Reading,
) -> Option<T> {
    one_of(value, ChoiceWords::of(what), choices, reading)
}

/// The choice that a value names, with its own words.
pub(crate) fn one_of<T: Copy>(
    value: &Value<'_>,
    words: ChoiceWords,
    choices: &[(&'static str, T)],
    reading: &mut Reading,
) -> Option<T> {
    let name = text(value, words.of_value, reading)?;
    if let Some((_, choice)) = choices.iter().find(|(known, _)| *known == name) {
        return Some(*choice);
    }
    let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
    let hint = suggestion(name, &names, words.known);
    let (what, name) = (words.unknown, name.to_owned());
    let kind = DiagnosticKind::UnknownName { what, name };
    reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
}

/// `KEY = "a" or "b"`.
pub(crate) fn choices_hint<T>(key: &str, choices: &[(&'static str, T)]) -> String {
    let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
    format!("{key} = \"{}\"", names.join("\" or \""))
}
