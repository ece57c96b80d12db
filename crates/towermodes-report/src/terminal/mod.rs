//! Pictures in characters, for terminals.

mod canvas;
mod panel;
mod shapes;

pub use shapes::{blade_shapes, shapes};
