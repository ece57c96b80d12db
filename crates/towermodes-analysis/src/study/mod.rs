//! Several methods on one tower: compared with each other, and as the number of segments increases.

mod comparison;
mod convergence;
mod follow;

pub use comparison::{
    COMPARED_SEGMENTS, Column, ColumnSpec, Comparison, all_methods, compare, compare_all_methods,
};
pub use convergence::{
    Convergence, Fineness, Level, STUDY_DEGREES, STUDY_SEGMENTS, converge, converge_by_default,
};
pub use follow::FollowedMode;
