//! Rotors of equal blades in multiblade coordinates.

mod error;
mod harmonics;
mod multiblade;

pub use error::RotorError;
pub use harmonics::RotorFactors;
pub use multiblade::{Multiblade, Reactionless, TurningBody, reactionless};
