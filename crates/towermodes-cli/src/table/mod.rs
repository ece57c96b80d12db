//! Results for people.

mod blade;
mod comparison;
mod convergence;
mod plot;
mod solution;
mod text;
mod verification;

pub(crate) use blade::blade;
pub(crate) use comparison::comparison;
pub(crate) use convergence::convergence;
pub(crate) use solution::solution;
pub(crate) use verification::verification;
