//! A value that is one of several names.

use super::reading::Reading;
use super::table::suggestion;
use super::values::{Value, text};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// The choice that a value names.
pub(super) fn chosen<T: Copy>(
    value: &Value<'_>,
    what: &'static str,
    choices: &[(&'static str, T)],
    reading: &mut Reading,
) -> Option<T> {
    let name = text(value, what, reading)?;
    if let Some((_, choice)) = choices.iter().find(|(known, _)| *known == name) {
        return Some(*choice);
    }
    let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
    let hint = suggestion(name, &names, "names:");
    let name = name.to_owned();
    let kind = DiagnosticKind::UnknownName { what, name };
    reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
}

/// `KEY = "a" or "b"`.
pub(super) fn choices_hint<T>(key: &str, choices: &[(&'static str, T)]) -> String {
    let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
    format!("{key} = \"{}\"", names.join("\" or \""))
}
