//! The coupled Campbell diagram: the natural frequencies of a whole turbine, tower and turning
//! rotor together, against the rotor speed.
//!
//! Modes are followed from speed to speed by their shapes; curves that cross are told from curves
//! that veer; whirl modes are paired; the excitations are judged against the coupled frequencies by
//! the rules of [`crate::resonance`].

mod compared;
mod curve;
mod diagram;
mod follow;
mod meeting;
mod named;
mod options;
mod refine;
mod remarks;
mod solved;
#[cfg(test)]
mod tests;

pub use compared::{AgainstRigid, Change};
pub use curve::{CoupledCurve, CurvePoint};
pub use diagram::{CoupledCampbell, coupled_campbell};
pub use meeting::{Meeting, MeetingKind};
pub use options::{CoupledError, CoupledOptions, RotorSpeeds, coupled_limit_hz};
pub use solved::SolvedSpeed;
