//! The coupled Campbell diagram: the natural frequencies of a whole turbine, tower and rotating
//! rotor together, against the rotor speed.
//!
//! Modes are followed from speed to speed by their shapes; crossings are distinguished from
//! veerings; whirl modes are paired; the excitations are compared with the frequencies of each name
//! by the rules of [`crate::resonance`].

mod compared;
mod curve;
mod diagram;
mod follow;
mod judged;
mod meeting;
mod named;
mod options;
mod refine;
mod remarks;
mod solved;
#[cfg(test)]
mod tests;

pub use compared::{AgainstRigid, Change};
pub use curve::{CoupledCurve, CurvePoint, NameChange, NameRange, SHARED};
pub use diagram::{CoupledCampbell, coupled_campbell, coupled_campbell_while};
pub use meeting::{Meeting, MeetingKind};
pub use options::{CoupledError, CoupledOptions, RotorSpeeds, coupled_limit_hz};
pub use solved::SolvedSpeed;
