//! The places of the values of a turbine, for the checks of the library.

use std::collections::HashMap;
use std::ops::Range;

use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, number, number_or_infinity};

/// The place of each value by its name, such as `hub.mass`, and in a list its index.
#[derive(Debug)]
pub(super) struct Spans {
    table: Range<usize>,
    all: HashMap<(&'static str, Option<usize>), Range<usize>>,
}

impl Spans {
    /// The places of a turbine whose table is here.
    pub(super) fn of(table: Range<usize>) -> Self {
        let all = HashMap::new();
        Self { table, all }
    }

    pub(super) fn remember(&mut self, name: &'static str, span: Range<usize>) {
        self.all.insert((name, None), span);
    }

    /// Stores the place of an entry of a list.
    pub(super) fn remember_entry(&mut self, name: &'static str, index: usize, span: Range<usize>) {
        self.all.insert((name, Some(index)), span);
    }

    /// The place of a value; if the file does not have it, that of its list, of its table, or of
    /// the turbine.
    pub(super) fn find(&self, name: &'static str, index: Option<usize>) -> Range<usize> {
        let part = name.split('.').next().unwrap_or(name);
        let mut keys = [(name, index), (name, None), (part, None)].into_iter();
        let found = keys.find_map(|key| self.all.get(&key));
        found.unwrap_or(&self.table).clone()
    }

    /// The value of a key, the last part of a name.
    pub(super) fn get<'a>(
        &mut self,
        table: &Table<'a>,
        name: &'static str,
    ) -> Option<&'a Value<'a>> {
        let value = table.get(key(name))?;
        self.remember(name, value.span());
        Some(value)
    }

    /// A required number.
    pub(super) fn required(
        &mut self,
        table: &Table<'_>,
        name: &'static str,
        hint: &str,
        reading: &mut Reading,
    ) -> Option<f64> {
        let value = table.require(key(name), hint, reading)?;
        self.remember(name, value.span());
        number(value, key(name), reading)
    }

    /// A number with a default.
    pub(super) fn number_or(
        &mut self,
        default: f64,
        table: &Table<'_>,
        name: &'static str,
        reading: &mut Reading,
    ) -> Option<f64> {
        match self.get(table, name) {
            Some(value) => number(value, key(name), reading),
            None => Some(default),
        }
    }

    /// A stiffness that may be infinite, and is infinite if the file does not contain it.
    pub(super) fn stiffness_or_rigid(
        &mut self,
        table: &Table<'_>,
        name: &'static str,
        reading: &mut Reading,
    ) -> Option<f64> {
        match self.get(table, name) {
            Some(value) => number_or_infinity(value, key(name), reading),
            None => Some(f64::INFINITY),
        }
    }
}

/// The key of a name.
pub(super) fn key(name: &'static str) -> &'static str {
    name.rsplit('.').next().unwrap_or(name)
}
