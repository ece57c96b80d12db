//! Lines of values in the format that Fortran programs read, with the place of each value.

mod items;
mod line;
mod token;

pub(crate) use items::{Items, MAX_COUNT};
pub(crate) use line::{Line, Lines, decimal_comma};
pub(crate) use token::Token;
