//! Rotors of equal blades in multiblade coordinates.

mod error;
mod multiblade;

pub use error::RotorError;
pub use multiblade::{Multiblade, TurningBody};
