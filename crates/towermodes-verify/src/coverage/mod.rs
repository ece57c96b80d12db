//! How often the errors that are claimed hold: random towers of many classes by every method,
//! against the beam itself.
//!
//! An error is *covered* if it is at most three times the claimed one. The reference is the
//! spectral beam with its degree raised by four, of the physics of the method: without shear
//! deformation and rotary inertia for BModes.
//! `cargo run --release -p towermodes-verify --example random_study` prints the tables of the book.

mod class;
mod features;
mod sample;
mod seed;
mod table;
mod tally;

pub use class::Class;
pub use sample::{Fineness, Sample, samples};
pub use seed::Seed;
pub use table::table;
pub use tally::Tally;
