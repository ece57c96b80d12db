//! What a rotating blade is.

mod description;

pub use description::{BladeDescription, BladeSection};
