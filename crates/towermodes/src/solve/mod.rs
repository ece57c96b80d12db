//! The entry points: compute the modes of a tower or a blade.
//!
//! In the order of use: [`options`](Options) and limits → cost → model (the assembled subsystems) →
//! spectrum → stability → naming and solution → one mesh → error estimates → warnings →
//! [`Solver`], whose methods are in `tower`, `certain`, `until`, `without_shapes` and `blade`.

mod attached;
mod blade;
mod by_frequency;
mod certain;
mod error;
mod errors;
mod frozen;
mod on_mesh;
mod progress;
mod request;
mod results;
mod solver;
mod tower;
mod until;
mod without_shapes;
mod workspace;

pub use blade::{BladeFamily, BladeMode, BladeSolution};
pub(crate) use by_frequency::slopes;
pub use error::SolveError;
pub(crate) use frozen::FrozenModes;
pub use on_mesh::spectrum::ModeKey;
pub use progress::{Progress, Stage};
pub use request::added_mass::AddedMassAt;
pub use request::limits::{
    DEFAULT_MODES, DEFAULT_POINTS, DEFAULT_SEGMENTS, MAX_BYTES, MAX_DEGREE, MAX_POINTS,
    MAX_SECONDS, MAX_SEGMENTS, MAX_SPECTRAL_ELEMENTS,
};
pub use request::options::Options;
pub use results::frequencies::{Frequencies, ModeFrequency};
pub use results::solution::{Certificate, ErrorBasis, Mode, Solution};
pub use solver::Solver;
pub use tower::solve;
pub use until::TooManyModes;
