//! Results as text tables.

mod agreement;
mod blade;
mod campbell;
mod comparison;
mod convergence;
mod elastodyn;
mod solution;
mod text;
mod verification;

pub(crate) use agreement::{agreement, examination};
pub(crate) use blade::blade;
pub(crate) use campbell::campbell;
pub(crate) use comparison::comparison;
pub(crate) use convergence::convergence;
pub(crate) use elastodyn::{changes, fits, judgements};
pub(crate) use solution::solution;
pub(crate) use verification::verification;
