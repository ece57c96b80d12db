//! One part: its columns, its file.

use crate::results::Results;
use crate::source::RowSource;
use crate::sweep::Sweep;

/// The format of the files of results.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PartFormat {
    /// Text with a line of names; an empty cell is a number that was not computed.
    #[default]
    Csv,
    /// Apache Parquet, with null for a number that was not computed; needs the feature `parquet`.
    Parquet,
}

impl PartFormat {
    /// Its name, and the ending of its files: `csv`, `parquet`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Parquet => "parquet",
        }
    }
}

/// The content of a part.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Part {
    /// The values of the changes, row by row; empty if they are not columns.
    pub(super) inputs: Vec<f64>,
    pub(super) results: Results,
}

impl Part {
    /// Results with the values of their rows, which are those of a source from its row `first` on.
    pub(super) fn new(sweep: &Sweep, source: &dyn RowSource, first: u64, results: Results) -> Self {
        let changes = sweep.changes().len();
        let mut inputs = Vec::new();
        if sweep.has_inputs() {
            inputs = vec![0.0; results.rows() * changes];
            for (row, values) in (first..).zip(inputs.chunks_exact_mut(changes)) {
                source.row(row, values);
            }
        }
        Self { inputs, results }
    }
}

/// The columns of results.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Column {
    /// The number of the row, from 0.
    Row,
    /// The value of a change, by its place.
    Input(usize),
    MassKg,
    Certified,
    /// The frequency of a mode, by its place.
    Hz(usize),
    /// Its error.
    ErrorHz(usize),
    /// The share of its family in its energy.
    Share(usize),
    /// What failed.
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
