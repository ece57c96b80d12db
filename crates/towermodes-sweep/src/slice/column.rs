//! The columns of results.

use crate::sweep::Sweep;

/// A column of results.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Column {
    /// The number of the row, from 0.
    Row,
    /// The value of a change, by the index of the change.
    Input(usize),
    MassKg,
    Certified,
    /// The frequency of a mode, by the index of the mode.
    Hz(usize),
    /// The error of this frequency.
    ErrorHz(usize),
    /// The share of the energy of the mode in its type of motion.
    Share(usize),
    /// The error message of the row.
    Sentence,
}

/// The columns of the results of a sweep with their names, in the order of the files: `row`, the
/// changes, `mass_kg`, `certified`, `fore_aft_1_hz`, `fore_aft_1_error_hz`,
/// `fore_aft_1_share`, …, `error`.
pub(super) fn columns(sweep: &Sweep) -> Vec<(String, Column)> {
    let mut columns = vec![("row".to_owned(), Column::Row)];
    if sweep.has_inputs() {
        let changes = sweep.changes().iter().enumerate();
        columns.extend(changes.map(|(i, change)| (change.name().to_owned(), Column::Input(i))));
    }
    columns.push(("mass_kg".to_owned(), Column::MassKg));
    columns.push(("certified".to_owned(), Column::Certified));
    for (index, name) in sweep.modes().iter().enumerate() {
        let name = name.column();
        columns.push((format!("{name}_hz"), Column::Hz(index)));
        columns.push((format!("{name}_error_hz"), Column::ErrorHz(index)));
        columns.push((format!("{name}_share"), Column::Share(index)));
    }
    columns.push(("error".to_owned(), Column::Sentence));
    columns
}
