//! A light tower whose frequencies are in given bands.
//!
//! Each file uses those before it: `problem`, the variables and requirements; `limits`, single
//! limits, those of the shape as linear functions; `unmet`, limits that no tower found meets;
//! `error`; `check`, contradictions; `towers`, mass, limits and all derivatives at values of the
//! variables; `optimality`, the first-order conditions of a minimum, by `nonnegative` least
//! squares; `minimum`, a local minimum by the library `slsqp`; `steps`, stepped values; `confirm`,
//! the final tower solved with the options of `solve`; `result`, the whole procedure. `window` is
//! the band between multiples of the rotor speed.

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
