//! `missing_parts`: what the source of the tower has and the file lacks.

use towermodes::MissingPart;

use super::choice::chosen;
use super::reading::Reading;
use super::table::Table;
use super::values::{every_row, list};

/// The parts; none without the key.
pub(super) fn missing_parts(root: &Table<'_>, reading: &mut Reading) -> Option<Vec<MissingPart>> {
    let Some(value) = root.get("missing_parts") else {
        return Some(Vec::new());
    };
    let choices = MissingPart::ALL.map(|part| (part.name(), part));
    let parts = list(value, "missing_parts", reading)?;
    every_row(parts, |_, part| {
        chosen(part, "missing part", &choices, reading)
    })
}
