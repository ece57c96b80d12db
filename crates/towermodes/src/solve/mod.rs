//! The entry points: compute the modes of a tower or a blade.
//!
//! In the order of use: [`options`](Options) and limits → cost → model (the assembled subsystems) →
//! spectrum → stability → naming and solution → one mesh → error estimates → warnings →
//! [`Solver`], whose methods are in `tower`, `certain`, `until`, `without_shapes` and `blade`.

mod alignment;
mod blade;
mod certain;
mod checks;
mod cost;
mod cut;
mod energy_parts;
mod error;
mod estimate;
mod frequencies;
mod frozen;
mod guesses;
mod limits;
mod listing;
#[cfg(feature = "serde")]
mod mode_keys;
mod model;
mod naming;
mod one_mesh;
mod options;
mod p_refinement;
mod pairing;
mod progress;
mod reference;
mod solution;
mod solver;
mod spectral_cut;
mod spectrum;
mod stability;
mod tower;
mod tracking;
mod until;
mod warnings;
mod without_shapes;
mod workspace;

pub use blade::{BladeFamily, BladeMode, BladeSolution};
pub use error::SolveError;
pub use frequencies::{Frequencies, ModeFrequency};
pub(crate) use frozen::FrozenModes;
pub use limits::{
    DEFAULT_MODES, DEFAULT_POINTS, DEFAULT_SEGMENTS, MAX_BYTES, MAX_DEGREE, MAX_POINTS,
    MAX_SECONDS, MAX_SEGMENTS, MAX_SPECTRAL_ELEMENTS,
};
pub use options::Options;
pub use progress::{Progress, Stage};
pub use solution::{Certificate, ErrorBasis, Mode, Solution};
pub use solver::Solver;
pub use spectrum::ModeKey;
pub use tower::solve;
pub use until::TooManyModes;
