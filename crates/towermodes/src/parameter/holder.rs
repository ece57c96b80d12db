//! A group of input values: a part that lists them, or a table that describes them.

use super::number::Number;
use super::part::{Indices, Part};
use super::table::{Table, TableNumber};
use crate::tower::TowerDescription;

/// A group of input values.
#[derive(Clone, Copy)]
pub(super) enum Holder {
    /// A part that lists its input values.
    Part(&'static Part),
    /// A table of the tower file whose fields describe its input values, and these values.
    Table(&'static Table, &'static [TableNumber]),
}

impl Holder {
    /// A table with its input values, which are listed once, for as long as the program runs.
    pub(super) fn table(table: &'static Table) -> Self {
        Self::Table(table, table.numbers().leak())
    }

    /// Its name in the tower file with `[]` for each index.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Part(part) => part.name,
            Self::Table(table, _) => table.name,
        }
    }

    /// Whether it is this part.
    pub(super) fn is(self, other: &'static Part) -> bool {
        matches!(self, Self::Part(part) if std::ptr::eq(part, other))
    }

    /// Its name in messages.
    pub(super) fn noun(self) -> &'static str {
        match self {
            Self::Part(part) => part.noun,
            Self::Table(table, _) => table.noun,
        }
    }

    /// Number of such groups in the description.
    pub(super) fn count(self, description: &TowerDescription) -> usize {
        match self {
            Self::Part(part) => (part.count)(description),
            Self::Table(table, _) => table.count(description),
        }
    }

    /// Number of rows of one group; 1 without rows.
    pub(super) fn rows(self, description: &TowerDescription, index: usize) -> usize {
        match self {
            Self::Part(part) => (part.rows)(description, index),
            Self::Table(_, _) => 1,
        }
    }

    /// Whether it is a list of lists, whose rows have a second index.
    pub(super) fn has_rows(self) -> bool {
        self.name().matches("[]").count() == 2
    }

    /// Whether its two indices may be exchanged: the entries of a symmetric matrix.
    pub(super) fn is_symmetric(self) -> bool {
        match self {
            Self::Part(part) => part.is_symmetric,
            Self::Table(_, _) => false,
        }
    }

    /// The input values that it can have.
    pub(super) fn numbers(self) -> Vec<Number> {
        match self {
            Self::Part(part) => part.keys.iter().map(Number::Listed).collect(),
            Self::Table(table, numbers) => {
                let numbers = numbers.iter();
                numbers
                    .map(|number| Number::Described(table, number))
                    .collect()
            }
        }
    }

    /// The indices of all its rows.
    pub(super) fn every(self, description: &TowerDescription) -> impl Iterator<Item = Indices> {
        let rows =
            move |first| (0..self.rows(description, first)).map(move |second| [first, second]);
        (0..self.count(description)).flat_map(rows)
    }

    /// The name of an input value with `[]` for each index.
    pub(super) fn pattern(self, number: Number) -> String {
        match number.name() {
            "" => self.name().to_owned(),
            name => format!("{}.{name}", self.name()),
        }
    }
}
