//! The figures, one per file or folder, each computed from results of the library.

mod animation;
mod campbell;
pub(crate) mod chart;
pub(crate) mod convergence;
mod design;
mod enlargement;
mod error;
mod first_frequencies;
mod outline;
mod parts;
mod scene;
pub(crate) mod shapes;
mod soil;
mod sweep;
mod symbols;
mod title;
mod tornado;
mod tower;
mod whirl;

pub use animation::{AnimatedMode, AnimationData, animation_data};
pub use campbell::{campbell, coupled_campbell};
pub use convergence::convergence;
pub use design::{DesignedMode, design};
pub use error::error;
pub use first_frequencies::first_frequencies;
pub use scene::{Body, Form, Substance};
pub use shapes::shapes;
pub use soil::{scour, soil};
pub use sweep::{
    ModeColumn, SweepBand, SweepBands, SweepColumns, VariedColumn, ViolatedShare, sweep,
};
pub use title::{TitleWords, titled};
pub use tornado::tornado;
pub use tower::tower;
pub use whirl::{AnimatedHarmonic, AnimatedWhirl, WhirlAnimation, whirl, whirl_animation};
