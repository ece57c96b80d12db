//! Parts whose numbers are described beside their fields.

use super::part::Indices;
use crate::inputs::{Given, Input, Inputs};
use crate::tower::{Place, TowerDescription};

/// Finds the table of a kind in a description.
type Get = for<'d> fn(&'d TowerDescription, Indices, &'static str) -> Option<&'d dyn Inputs>;
/// The same to change it.
type GetMut =
    for<'d> fn(&'d mut TowerDescription, Indices, &'static str) -> Option<&'d mut dyn Inputs>;

/// A part of a tower that is a table of the tower file.
pub(super) struct Table {
    /// Its name in the tower file with `[]` for an index.
    pub(super) name: &'static str,
    /// What it is in messages.
    pub(super) noun: &'static str,
    /// Which of several kinds the table is; empty if there is one kind.
    pub(super) kind: &'static str,
    /// The table of a kind, if the description has it.
    pub(super) get: Get,
    /// The same to change it.
    pub(super) get_mut: GetMut,
    /// The keys of a kind.
    pub(super) every: fn(&'static str) -> Vec<(&'static Input, Given)>,
    /// The place of a key for errors.
    pub(super) place: fn(Indices, &'static str) -> Place,
    /// The value of an optional number that the file does not give.
    pub(super) absent: fn(&TowerDescription) -> Option<f64>,
}

impl Table {
    /// How many such tables a description has.
    pub(super) fn count(&self, description: &TowerDescription) -> usize {
        let has = |index: &usize| self.of(description, [*index, 0]).is_some();
        (0..).take_while(has).count()
    }

    fn of<'d>(
        &self,
        description: &'d TowerDescription,
        indices: Indices,
    ) -> Option<&'d dyn Inputs> {
        (self.get)(description, indices, self.kind)
    }

    /// A number that the table gives.
    pub(super) fn given(
        &self,
        input: &'static Input,
        description: &TowerDescription,
        indices: Indices,
    ) -> Option<f64> {
        self.number(input, description, indices)?
    }

    /// A number that the table has, given or not.
    pub(super) fn value(
        &self,
        input: &'static Input,
        description: &TowerDescription,
        indices: Indices,
    ) -> Option<f64> {
        let number = self.number(input, description, indices)?;
        number.or_else(|| (self.absent)(description))
    }

    fn number(
        &self,
        input: &'static Input,
        description: &TowerDescription,
        indices: Indices,
    ) -> Option<Option<f64>> {
        let mut found = None;
        self.of(description, indices)?.visit(&mut |other, given| {
            if std::ptr::eq(other, input) {
                found = Some(given.number());
            }
        });
        found
    }

    /// Sets a number that the table has.
    pub(super) fn set(
        &self,
        input: &'static Input,
        description: &mut TowerDescription,
        indices: Indices,
        value: f64,
    ) -> Option<()> {
        let mut done = None;
        let inputs = (self.get_mut)(description, indices, self.kind)?;
        inputs.update(&mut |other, given| {
            if !std::ptr::eq(other, input) {
                return given;
            }
            done = Some(());
            given.with_number(value)
        });
        done
    }
}
