//! The values of a tower file: each is described beside the field that contains it.
//!
//! A struct that is a table of the tower file derives [`Inputs`]; the attribute of a field is an
//! [`Input`], the facts about its value. The checks of the tower, the names of its numbers, the
//! reader, the writer and the schema of the tower file, and the report visit the values and have
//! no lists of their own. Facts about two values are in the checks of the struct that has both.

mod dimension;
mod given;
mod input;
mod limit;
mod quantity;
mod value;

pub use dimension::Dimension;
pub use given::Given;
pub use input::Input;
pub use limit::{Limit, Nature};
pub use quantity::Quantity;
pub(crate) use towermodes_derive::Inputs;
pub(crate) use value::names;
pub use value::{Named, Value};

/// A table of the tower file, or a part of one.
///
/// A part whose values depend on one of them, the choice of a formula, implements it by hand: each
/// value that it has is visited, and [`idle`](Self::idle) lists the others.
pub trait Inputs {
    /// A value of the type with the default of each optional key, and NaN for each required number.
    fn blank() -> Self
    where
        Self: Sized;

    /// Visits each value in the order of the tower file.
    fn visit(&self, each: &mut dyn FnMut(&'static Input, Given));

    /// Replaces each value, in the same order, by one of the same type.
    fn update(&mut self, each: &mut dyn FnMut(&'static Input, Given) -> Given);

    /// Visits the values that other kinds of this table have and this kind does not have.
    fn idle(&self, each: &mut dyn FnMut(&'static Input, Given));
}

/// An optional table: all its values are given, or none.
impl<T: Inputs> Inputs for Option<T> {
    fn blank() -> Self {
        None
    }

    fn visit(&self, each: &mut dyn FnMut(&'static Input, Given)) {
        if let Some(own) = self {
            own.visit(each);
        }
    }

    fn update(&mut self, each: &mut dyn FnMut(&'static Input, Given) -> Given) {
        if let Some(own) = self {
            own.update(each);
        }
    }

    fn idle(&self, each: &mut dyn FnMut(&'static Input, Given)) {
        match self {
            Some(own) => own.idle(each),
            None => T::blank().visit(each),
        }
    }
}

/// All keys of the table with their descriptions: values that this struct has, and values that it
/// has not.
pub fn every_input(inputs: &dyn Inputs) -> Vec<(&'static Input, Given)> {
    let mut all = given_inputs(inputs);
    inputs.idle(&mut |input, given| all.push((input, given)));
    all
}

/// Its values, in the order of the tower file.
pub fn given_inputs(inputs: &dyn Inputs) -> Vec<(&'static Input, Given)> {
    let mut all = Vec::new();
    inputs.visit(&mut |input, given| all.push((input, given)));
    all
}

/// The given values without effect because the one that each needs is absent: its description, the
/// needed key and what to do.
pub(crate) fn without_needed(
    inputs: &dyn Inputs,
) -> Vec<(&'static Input, &'static str, &'static str)> {
    let mut all = Vec::new();
    inputs.visit(&mut |input, given| {
        if let Some((needed, remedy)) = input.needs.filter(|_| !input.is_default(given)) {
            all.push((input, needed, remedy));
        }
    });
    all.retain(|(_, needed, _)| !has_value(inputs, needed));
    all
}

/// Whether the value of a key is given.
fn has_value(inputs: &dyn Inputs, key: &str) -> bool {
    let mut is_there = false;
    inputs.visit(&mut |input, given| {
        is_there |= input.key == key
            && match given {
                Given::Name(place, _) => place.is_some(),
                other => !input.is_default(other),
            };
    });
    is_there
}

/// Multiplies the values that are proportional to the stiffness of the soil.
pub fn multiply_soil(inputs: &mut dyn Inputs, factor: f64) {
    inputs.update(&mut |input, given| match given.number() {
        Some(value) if input.is_of_soil => given.with_number(factor * value),
        _ => given,
    });
}
