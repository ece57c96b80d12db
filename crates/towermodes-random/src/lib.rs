//! Random towers and turbines: coverage of the estimated errors, and jumps in the names of modes
//! along paths. For tests and studies; the program does not contain this crate.
//!
//! An error is *covered* if it is at most three times the estimate. The reference is the method
//! `spectral` with a degree increased by four and with the beam theory of the method: for BModes
//! without shear deformation and rotary inertia. `cargo run --release -p towermodes-random
//! --example random_study` prints the tables of the book.
//!
//! Turbines with a rotating rotor are compared with finer elements; `--example random_turbines`
//! prints their table. Frames, with and without a tower, are compared with elements of a higher
//! degree (`--example random_frames`). [`paths`] follows names along paths of towers (`--example
//! name_study`).

mod class;
mod features;
mod framed;
mod frames;
pub mod paths;
mod rotors;
mod sample;
mod seed;
mod table;
mod tally;
mod tubes;
mod turning;

pub use class::Class;
pub use framed::{frame_samples, samples_on_frame};
pub use frames::{Lattice, random_frame, tower_on};
pub use rotors::{RandomTurbine, TurbineClass};
pub use sample::{Fineness, Sample, samples};
pub use seed::Seed;
pub use table::{table, turbine_table};
pub use tally::Tally;
pub use turning::turbine_samples;
