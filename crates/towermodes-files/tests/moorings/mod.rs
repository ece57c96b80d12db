//! The readers of MoorDyn and MAP++.

pub mod damaged;
mod layouts;
mod map;
mod notes;
mod public;
mod refused;
pub mod texts;
