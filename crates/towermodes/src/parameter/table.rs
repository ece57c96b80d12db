//! Parts whose input values are described beside their fields.

use super::part::Indices;
use crate::inputs::{Given, Input, Inputs, Limit, Nature};
use crate::tower::{Place, TowerDescription};

/// Finds the table of a kind in a description.
type Get = for<'d> fn(&'d TowerDescription, Indices, &'static str) -> Option<&'d dyn Inputs>;
/// Finds this table for a change.
type GetMut =
    for<'d> fn(&'d mut TowerDescription, Indices, &'static str) -> Option<&'d mut dyn Inputs>;

/// A part of a tower that is a table of the tower file.
pub(super) struct Table {
    /// Its name in the tower file with `[]` for an index.
    pub(super) name: &'static str,
    /// Its name in messages.
    pub(super) noun: &'static str,
    /// The kind of the table, if there are several kinds; otherwise empty.
    pub(super) kind: &'static str,
    /// The table of a kind, if the description has it.
    pub(super) get: Get,
    /// Finds this table for a change.
    pub(super) get_mut: GetMut,
    /// The keys of a kind.
    pub(super) every: fn(&'static str) -> Vec<(&'static Input, Given)>,
    /// The place of a key for errors.
    pub(super) place: fn(Indices, &'static str) -> Place,
    /// The value of an optional number that the file does not give.
    pub(super) absent: fn(&TowerDescription) -> Option<f64>,
}

/// An input value of a table: a value, one end of a pair, or one of three coordinates.
pub(super) struct TableNumber {
    pub(super) input: &'static Input,
    /// 0 for the top of a layer and 1 for its bottom, 0 to 2 for x to z; none for a value that is
    /// one number.
    pub(super) end: Option<usize>,
    /// Its name in the table.
    pub(super) name: String,
    /// Its meaning in words.
    pub(super) meaning: String,
}

impl TableNumber {
    fn new(input: &'static Input, end: Option<usize>, what: &str) -> Self {
        let (key, meaning) = (input.key, input.meaning());
        let name = end.map_or_else(|| key.to_owned(), |end| format!("{key}[{end}]"));
        let meaning = format!("{meaning}{what}");
        Self {
            input,
            end,
            name,
            meaning,
        }
    }

    /// The key of its place: errors in an inertia are reported for the whole tensor.
    pub(super) fn place_key(&self) -> &'static str {
        match self.input.limit {
            Limit::Inertia | Limit::Elsewhere => self.input.outer_key(),
            _ => self.input.key,
        }
    }

    /// The kind of the value.
    pub(super) fn nature(&self) -> Nature {
        match (self.input.limit.nature(), self.end) {
            // A strength or stiffness can begin with zero at one end of a layer.
            (Nature::Size, Some(_)) => Nature::Amount,
            (nature, _) => nature,
        }
    }

    /// The input values of a field.
    fn of((input, given): (&'static Input, Given)) -> Vec<Self> {
        let several: &[&str] = match given {
            Given::Number(_) | Given::Optional(_) => return vec![Self::new(input, None, "")],
            Given::Pair(_) => &[" at the top", " at the bottom"],
            Given::Triple(_) => &[", downwind", ", side-side", ", up"],
            Given::Count(_) | Given::Flag(_) | Given::Name(..) => &[],
        };
        let ends = several.iter().enumerate();
        ends.map(|(end, what)| Self::new(input, Some(end), what))
            .collect()
    }
}

impl Table {
    /// Number of such tables in the description.
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

    /// The input values that it can have.
    pub(super) fn numbers(&self) -> Vec<TableNumber> {
        let every = (self.every)(self.kind).into_iter();
        every.flat_map(TableNumber::of).collect()
    }

    /// An input value that is given in the table.
    pub(super) fn given(
        &self,
        number: &TableNumber,
        description: &TowerDescription,
        indices: Indices,
    ) -> Option<f64> {
        self.number(number, description, indices)?
    }

    /// An input value of the table, given or default.
    pub(super) fn value(
        &self,
        number: &TableNumber,
        description: &TowerDescription,
        indices: Indices,
    ) -> Option<f64> {
        let number = self.number(number, description, indices)?;
        number.or_else(|| (self.absent)(description))
    }

    fn number(
        &self,
        number: &TableNumber,
        description: &TowerDescription,
        indices: Indices,
    ) -> Option<Option<f64>> {
        let mut found = None;
        self.of(description, indices)?.visit(&mut |input, given| {
            if input.key == number.input.key {
                found = Some(given.at(number.end));
            }
        });
        found
    }

    /// Sets an input value of the table.
    pub(super) fn set(
        &self,
        number: &TableNumber,
        description: &mut TowerDescription,
        indices: Indices,
        value: f64,
    ) -> Option<()> {
        let mut done = None;
        let inputs = (self.get_mut)(description, indices, self.kind)?;
        inputs.update(&mut |input, given| {
            if input.key != number.input.key {
                return given;
            }
            done = Some(());
            given.with(number.end, value)
        });
        done
    }
}
