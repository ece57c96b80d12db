//! How often the estimated errors hold: random towers of many classes, each method compared with
//! the reference solution.
//!
//! An error is *covered* if it is at most three times the estimated one. The reference is the
//! method spectral with a degree increased by four and the beam theory of the method: without shear
//! deformation and rotary inertia for BModes.
//! `cargo run --release -p towermodes-verify --example random_study` prints the tables of the book.

mod class;
mod features;
mod sample;
mod seed;
mod table;
mod tally;
mod tubes;

pub use class::Class;
pub use sample::{Fineness, Sample, samples};
pub use seed::Seed;
pub use table::table;
pub use tally::Tally;
