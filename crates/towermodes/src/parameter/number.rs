//! An input value of a part of a tower.

use std::hash::{Hash, Hasher};

use super::part::{Indices, Key};
use super::table::{Table, TableNumber};
use crate::inputs::Nature;
use crate::tower::{Place, TowerDescription};

/// An input value of a part of a tower.
#[derive(Clone, Copy)]
pub(super) enum Number {
    /// An input value of a part that lists its values.
    Listed(&'static Key),
    /// An input value of a table, which describes its values.
    Described(&'static Table, &'static TableNumber),
}

impl Number {
    /// Its name in the part; empty if the part is the number.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Listed(key) => key.name,
            Self::Described(_, number) => &number.name,
        }
    }

    /// Its unit.
    pub(super) fn unit(self) -> &'static str {
        match self {
            Self::Listed(key) => key.unit,
            Self::Described(_, number) => number.input.unit(),
        }
    }

    /// Its meaning in words.
    pub(super) fn meaning(self) -> &'static str {
        match self {
            Self::Listed(key) => key.meaning,
            Self::Described(_, number) => &number.meaning,
        }
    }

    /// Its place for errors.
    pub(super) fn place(self, indices: Indices) -> Place {
        match self {
            Self::Listed(key) => (key.place)(indices),
            Self::Described(table, number) => (table.place)(indices, number.place_key()),
        }
    }

    /// Its value, if the description has it.
    pub(super) fn get(self, description: &TowerDescription, indices: Indices) -> Option<f64> {
        match self {
            Self::Listed(key) => (key.get)(description, indices),
            Self::Described(table, number) => table.value(number, description, indices),
        }
    }

    /// Sets its value, if the description has it.
    pub(super) fn set(
        self,
        description: &mut TowerDescription,
        indices: Indices,
        value: f64,
    ) -> Option<()> {
        match self {
            Self::Listed(key) => (key.set)(description, indices, value),
            Self::Described(table, number) => table.set(number, description, indices, value),
        }
    }

    /// Whether it is in the list of all input values; other values can only be named.
    pub(super) fn is_listed(self, description: &TowerDescription, indices: Indices) -> bool {
        match self {
            Self::Listed(key) => (key.is_listed)(description, indices),
            Self::Described(table, number) => table.given(number, description, indices).is_some(),
        }
    }

    /// The kind of the value.
    pub(super) fn nature(self) -> Nature {
        match self {
            Self::Listed(key) => key.nature,
            Self::Described(_, number) => number.nature(),
        }
    }

    /// The address of its description; no two numbers have the same.
    fn address(self) -> *const () {
        match self {
            Self::Listed(key) => std::ptr::from_ref(key).cast(),
            Self::Described(_, number) => std::ptr::from_ref(number).cast(),
        }
    }
}

impl std::fmt::Debug for Number {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.address() == other.address()
    }
}

impl Eq for Number {}

impl Hash for Number {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.address().hash(state);
    }
}
