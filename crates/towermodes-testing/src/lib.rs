//! Helpers for the tests of all crates: a tube for towers in tests, tables of cases as text, and
//! assertions on texts and numbers.

mod cases;
mod expected;
mod fields;
pub mod parts;
mod tubes;

pub use cases::{arguments, line_and_column, number, numbers, rows, words};
pub use expected::{Close, Says};
pub use tubes::{rna, rotor, stations, tube};
