//! The verification manual: towers and beams with known frequencies, compared with the solver.
//!
//! ```
//! let case = &towermodes_verify::manual()[0];
//! let rows = case.run();
//! assert!(rows.iter().all(|row| row.passes()));
//! assert_eq!(rows[0].expected.value, 0.8905);
//! ```
//!
//! A [`Case`] is a tower with reference values, their source, and the methods that must reproduce
//! them. The tolerance is the rounding of the last given digit plus an allowance for the method or
//! the reference ([`Run::allowance`]).

mod case;
mod chapter;
mod expected;
mod found;
mod manual;
mod markdown;
mod misprint;
mod row;
#[cfg(feature = "serde")]
mod row_keys;
mod subject;
pub mod towers;
mod turning;

pub use case::{Case, Run, Unit, Value};
pub use chapter::Chapter;
pub use expected::{Digits, Expected, Hanging, Quantity};
pub use manual::{CHAPTERS, manual};
pub use markdown::markdown;
pub use misprint::Misprint;
pub use row::{Row, Verdict, Verification, summary};
pub use subject::Subject;
pub use turning::Turning;

/// The JSON schema of a [`Verification`] (draft 2020-12), indented, with a newline at the end. A
/// test compares it with the type.
pub const SCHEMA: &str = include_str!("../schema.json");
