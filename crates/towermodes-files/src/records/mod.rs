//! Lines of values as Fortran programs read them, with the place of each value.

mod line;
mod token;

pub(crate) use line::{Line, Lines};
pub(crate) use token::Token;
