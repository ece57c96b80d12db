//! A light tower whose frequencies are in given bands.
//!
//! Each file uses those before it: `problem`, what is chosen and what is required; `limits`, one
//! limit each, those of the shape as linear functions; `unmet`, limits that no tower found meets;
//! `error`; `check`, what contradicts itself; `towers`, mass, limits and all derivatives at values
//! of the variables; `optimality`, the first-order conditions of a minimum, by `nonnegative` least
//! squares; `minimum`, a local minimum by the library `slsqp`; `steps`, values in steps; `confirm`,
//! the tower found solved as any tower; `result`, which puts these together. `window` is the band
//! between multiples of the rotor speed.

mod check;
mod confirm;
mod error;
mod limits;
mod minimum;
mod nonnegative;
mod optimality;
mod problem;
mod result;
mod steps;
mod towers;
mod unmet;
mod window;

pub use confirm::{OtherHolder, Reached};
pub use error::DesignError;
pub use limits::Limit;
pub use problem::{DesignProblem, Goal, Side, Variable};
pub use result::{ActiveLimit, Design, Steps, design, design_while};
pub use unmet::{Conflict, Infeasible};
pub use window::{WindowError, window_hz};
