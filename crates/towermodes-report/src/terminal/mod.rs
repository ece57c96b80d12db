//! Text graphics for terminals.

mod canvas;
mod chart;
mod convergence;
mod panel;
mod shapes;

pub use convergence::convergence;
pub use shapes::{blade_shapes, shapes};
