//! The rotating blade: sections with twist and offsets, rotor speed, a body at the tip;
//! validated once, constant afterwards.

#[allow(clippy::module_inception, reason = "the file is about the type")]
mod blade;
mod description;
mod error;

pub use blade::Blade;
pub use description::{BladeDescription, BladeSection};
pub use error::BladeError;
