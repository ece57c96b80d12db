//! The lightest tower whose frequencies are in given bands.
//!
//! `problem` defines variables, goals and limits, `window` the band between multiples of the rotor
//! speed. `limits` are the limits of the shape, linear in the numbers of the tower; `point` is a
//! tower with mass, frequencies and all derivatives, which `minimum` gives to the optimizer.
//! `optimality` proves a minimum by its multipliers, `steps` rounds it to plate thicknesses by
//! `moves`, `together` with variables that have no steps, and `result` checks and describes the
//! tower found.

mod error;
mod limits;
mod minimum;
mod moves;
mod nonnegative;
mod optimality;
mod point;
mod problem;
mod result;
mod scaled;
mod steps;
mod together;
mod window;

pub use error::DesignError;
pub use limits::Limit;
pub use problem::{DesignProblem, Goal, Side, Variable};
pub use result::{ActiveLimit, Conflict, Design, Infeasible, Reached, design};
pub use window::{WindowError, window_hz};
