//! Lines of values as Fortran programs read them, with the place of each value.

mod items;
mod line;
mod token;

pub(crate) use items::{Items, MAX_COUNT};
pub(crate) use line::{Line, Lines, decimal_comma};
pub(crate) use token::Token;
