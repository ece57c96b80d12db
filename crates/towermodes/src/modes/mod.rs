//! What a user sees of a mode: family and order, shape, modal mass, discretization error.

mod beam_curves;
mod chain_curves;
mod discretization;
mod family;
mod sampling;
mod shape;

pub use beam_curves::BeamCurves;
pub use chain_curves::{ChainCurves, ChainCurvesWorkspace};
pub use discretization::{Estimate, richardson};
pub use family::Family;
pub use sampling::{ModeCurve, SegmentCurves};
pub use shape::ShapePoint;
