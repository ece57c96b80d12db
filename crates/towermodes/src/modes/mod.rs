//! What a user sees of a mode: family and order, shape, modal mass, energy, discretization error.

mod beam_curves;
mod chain_curves;
mod discretization;
mod energy;
mod family;
mod rigid;
mod sampling;
mod shape;

pub use beam_curves::BeamCurves;
pub use chain_curves::ChainCurves;
pub use discretization::{Estimate, richardson};
pub use energy::{ByMotion, Energy};
pub use family::{Family, Ordinal};
pub(crate) use rigid::{RigidBody, rigid_names};
pub use sampling::{ModeCurve, SegmentCurves};
pub use shape::ShapePoint;
