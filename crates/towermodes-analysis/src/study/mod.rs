//! What several methods make of one tower: side by side, and each as it converges.

mod comparison;
mod convergence;
mod follow;

pub use comparison::{Column, ColumnSpec, Comparison, compare, compare_with};
pub use convergence::{Convergence, Fineness, Level, converge, converge_with};
pub use follow::FollowedMode;
