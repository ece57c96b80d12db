//! What several methods make of one tower: side by side, and each as it converges.

mod agreement;
mod comparison;
mod convergence;
mod follow;

pub use agreement::{
    Agreement, AgreementError, AgreementLimits, AgreementRow, Compared, ComparedFrequency,
    Examination, ExaminationRow, HeightRange, LargestDifference, Verdict, WhichTower, agree,
    examine,
};
pub use comparison::{Column, ColumnSpec, Comparison, compare, compare_with};
pub use convergence::{Convergence, Fineness, Level, converge, converge_with};
pub use follow::{FollowedMode, solve_until};
