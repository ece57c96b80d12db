//! The verification manual: towers and beams with known answers, and whether they come out.
//!
//! ```
//! let case = &towermodes_verify::manual()[0];
//! let rows = case.run();
//! assert!(rows.iter().all(|row| row.passes()));
//! assert_eq!(rows[0].expected.value, 0.8905);
//! ```
//!
//! A [`Case`] is a tower, where its answers are from, and what each method should give. A tolerance
//! is what the last digit given leaves open, and an allowance for the method or the reference
//! ([`Run::allowance`]).

mod case;
pub mod coverage;
mod expected;
mod manual;
mod markdown;
mod row;
#[cfg(feature = "serde")]
mod row_keys;
pub mod towers;

pub use case::{Case, Run, Unit, Value};
pub use expected::{Digits, Expected, Quantity};
pub use manual::{CHAPTERS, Chapter, manual};
pub use markdown::markdown;
pub use row::{Row, Verification};
