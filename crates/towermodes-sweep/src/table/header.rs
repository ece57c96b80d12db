//! The names of the columns of a table.

use std::collections::HashMap;

use towermodes::{Change, TowerDescription};

use super::error::{MOST_COLUMNS, TableProblem};
use crate::first::first;

/// The changes that the columns of a table name.
#[derive(Debug)]
pub(super) struct Header {
    /// The names of all columns.
    pub(super) names: Vec<String>,
    /// The changes.
    pub(super) changes: Vec<Change>,
    /// The column of each change.
    pub(super) columns: Vec<usize>,
}

impl Header {
    /// Finds the changes by the names of the columns.
    pub(super) fn new(
        names: Vec<String>,
        base: &TowerDescription,
        ignore: &[String],
    ) -> Result<Self, TableProblem> {
        check(&names)?;
        if let Some(name) = ignore.iter().find(|name| !names.contains(name)) {
            return Err(TableProblem::NothingToIgnore {
                name: name.clone(),
                columns: first(&names.iter().map(|n| format!("`{n}`")).collect::<Vec<_>>()),
            });
        }
        let is_left_out = |name: &String| name.starts_with('#') || ignore.contains(name);
        let columns = (0..names.len()).filter(|column| !is_left_out(&names[*column]));
        let columns: Vec<usize> = columns.collect();
        if columns.is_empty() {
            return Err(TableProblem::NothingVaried);
        }
        let parsed = columns.iter().map(|&i| (i, Change::parse(&names[i], base)));
        let mut unknown = parsed.filter_map(|(column, parsed)| Some((column, parsed.err()?)));
        if let Some((column, error)) = unknown.next() {
            return Err(TableProblem::Unknown {
                name: names[column].clone(),
                column: column + 1,
                others: unknown.count(),
                error,
            });
        }
        let written = columns.iter().map(|&column| names[column].as_str());
        let changes = Change::parse_all(written, base).map_err(TableProblem::Contradiction)?;
        Ok(Self {
            names,
            changes,
            columns,
        })
    }
}

/// Refuses names that a table of changes cannot have.
fn check(names: &[String]) -> Result<(), TableProblem> {
    if names.is_empty() || names.iter().all(|name| name.is_empty()) {
        return Err(TableProblem::NoColumns);
    }
    if names.len() > MOST_COLUMNS {
        let columns = names.len();
        return Err(TableProblem::TooManyColumns { columns });
    }
    if names[0].parse::<f64>().is_ok() {
        let text = names[0].clone();
        return Err(TableProblem::NoNames { text });
    }
    let mut seen = HashMap::new();
    for (index, name) in names.iter().enumerate() {
        if name.is_empty() {
            return Err(TableProblem::EmptyName { column: index + 1 });
        }
        if let Some(first) = seen.insert(name, index) {
            return Err(TableProblem::RepeatedName {
                name: name.clone(),
                first: first + 1,
                second: index + 1,
            });
        }
    }
    Ok(())
}
