//! A key whose value is one of several names.

use super::at;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::toml::reading::Reading;
use crate::toml::table::{Table, suggestion};
use crate::toml::values::text;

/// The choice that a required key names.
pub(super) fn choice<T: Copy>(
    table: &Table<'_>,
    key: &'static str,
    what: &'static str,
    choices: &[(&'static str, T)],
    reading: &mut Reading,
) -> Option<T> {
    let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
    let hint = format!("{key} = \"{}\"", names.join("\" or \""));
    let value = table.require(key, &hint, reading)?;
    reading.remember(at(key), value.span());
    let name = text(value, what, reading)?;
    if let Some((_, choice)) = choices.iter().find(|(known, _)| *known == name) {
        return Some(*choice);
    }
    let hint = suggestion(name, &names, "names:");
    let name = name.to_owned();
    let kind = DiagnosticKind::UnknownName { what, name };
    reading.refuse(Diagnostic::new(value.span(), kind).with_hint(hint))
}
