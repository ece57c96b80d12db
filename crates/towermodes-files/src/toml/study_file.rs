//! Reads a sweep study or a design file.

use ::toml::de::DeTable;

use super::schema::TableSchema;
use super::text::reading::Reading;
use super::text::syntax::syntax_mistake;
use super::text::table::Table;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::source::Source;

/// Reads a study by `read`, after `refuse` has checked whether the file is of another kind. For an
/// empty file the mistake states the minimum content `least`.
///
/// # Errors
/// [`ReadError::Mistakes`] with all mistakes that were found.
pub(super) fn read_study<S>(
    source: &Source,
    (least, schema): (&'static str, &'static TableSchema),
    refuse: impl FnOnce(&DeTable<'_>) -> Option<Diagnostic>,
    read: impl FnOnce(&Table<'_>, &mut Reading) -> Option<S>,
) -> Result<S, ReadError> {
    let mistakes = |mistakes| ReadError::mistakes(source, mistakes);
    let file = &source.text;
    if file.trim().is_empty() {
        let mistake = Diagnostic::new(0..0, DiagnosticKind::EmptyFile);
        return Err(mistakes(vec![mistake.with_hint(least)]));
    }
    let document = DeTable::parse(file);
    let document = document.map_err(|error| mistakes(vec![syntax_mistake(&error, file)]))?;
    let entries = document.get_ref();
    if let Some(mistake) = refuse(entries) {
        return Err(mistakes(vec![mistake]));
    }
    let mut reading = Reading::default();
    let root = Table::root(entries, file.len(), schema, &mut reading);
    let study = read(&root, &mut reading);
    reading.mistakes.sort_by_key(|mistake| mistake.span.start);
    match study {
        Some(study) if reading.mistakes.is_empty() => Ok(study),
        _ => Err(mistakes(reading.mistakes)),
    }
}
