//! The readers of MoorDyn and MAP++.

mod damaged;
mod layouts;
mod map;
mod notes;
mod public;
mod refused;
mod texts;
