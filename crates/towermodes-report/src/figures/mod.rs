//! The pictures, one a file: each from results of the library alone.

mod animation;
mod campbell;
mod convergence;
mod end_labels;
mod error;
pub(crate) mod error_axis;
mod legend;
mod outline;
mod quantity;
mod shapes;
mod slope;
mod symbols;
mod tower;

pub use animation::{AnimatedMode, AnimationData, animation_data};
pub use campbell::campbell;
pub use convergence::convergence;
pub use error::error;
pub use shapes::shapes;
pub use tower::tower;
