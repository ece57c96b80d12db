//! The figures, one per file or folder, each computed from results of the library.

mod animation;
mod campbell;
pub(crate) mod chart;
pub(crate) mod convergence;
mod design;
mod enlargement;
mod error;
mod first_frequencies;
mod lines;
mod mooring;
mod outline;
mod parts;
mod scene;
mod scour;
pub(crate) mod shapes;
mod soil;
mod structure;
mod substructure;
mod sweep;
mod symbols;
mod title;
mod tornado;
mod tower;
mod whirl;

pub use animation::{AnimatedFrame, AnimatedMember, AnimatedMode, AnimationData, animation_data};
pub use campbell::{campbell, coupled_campbell};
pub(crate) use campbell::{campbell_beside_conclusion, coupled_campbell_beside_conclusion};
pub use convergence::convergence;
pub use design::{DesignedMode, design};
pub use error::error;
pub use first_frequencies::first_frequencies;
pub(crate) use lines::{LinesAtRest, lines_at_rest};
pub use mooring::mooring;
pub use scene::{Body, Form, Substance};
pub use shapes::shapes;
pub use soil::{Excitations, scour, soil};
pub use structure::structure;
pub use sweep::{
    ModeColumn, SweepBand, SweepBands, SweepColumns, VariedColumn, ViolatedShare, sweep,
};
pub use title::{TitleWords, titled};
pub use tornado::tornado;
pub use tower::tower;
pub use whirl::{AnimatedHarmonic, AnimatedWhirl, WhirlAnimation, whirl, whirl_animation};
