//! The lightest tower whose frequencies are in given bands.
//!
//! `problem` defines variables, goals and limits, `window` the band between multiples of the rotor
//! speed. `limits` are the limits of the shape, linear in the numbers of the tower; `point` is a
//! tower with mass, frequencies and all derivatives, which `minimum` gives to the optimizer.
//! `optimality` proves a minimum by its multipliers; `dive` brings its values into steps, a few at
//! a time, `steps` improves them by `moves`, `together` with variables that have no steps;
//! `confirm` solves the tower found as any tower, and `result` describes it.

mod confirm;
mod dive;
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

pub use confirm::{OtherHolder, Reached};
pub use error::DesignError;
pub use limits::Limit;
pub use problem::{DesignProblem, Goal, Side, Variable};
pub use result::{ActiveLimit, Conflict, Design, Infeasible, Steps, design};
pub use window::{WindowError, window_hz};
