//! What a user sees of a mode: family and order, shape, modal mass, discretization error.

mod discretization;
mod family;
mod sampling;
mod shape;

pub use discretization::{Estimate, richardson};
pub use family::Family;
pub use sampling::{ModeCurve, ShapeWorkspace};
pub use shape::ShapePoint;
