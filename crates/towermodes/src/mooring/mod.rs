//! Mooring systems at rest: elastic lines with weight, on the seabed or above it, between anchors,
//! a platform, free points, bodies and rods; their force on the platform and their stiffness.
//!
//! The lines are quasi-static: each has its static shape in still water, and its mass is not
//! included in the modes. A description is checked once ([`Mooring::new`]) and evaluated at any
//! pose of the platform ([`Mooring::at`]).

mod assembly;
mod cable;
mod carrier;
mod catenary;
mod check;
mod curve;
mod description;
mod doubts;
mod elimination;
mod equilibrium;
mod error;
mod fairleads;
mod grounded;
mod hanging;
mod line;
mod mass;
mod pose;
mod root;
mod seabed;
mod state;
mod system;
mod vector;
mod warning;

pub use description::{
    Attachment, Carrier, LineType, MooringBody, MooringDescription, MooringLine, MooringPoint,
    MooringRod, RodEnd,
};
pub use error::{MooringError, MooringItem};
pub(crate) use fairleads::Fairlead;
pub use pose::Pose;
pub use state::{BodyState, LineState, MooringLoad, MooringState, MooringWorkspace};
pub use system::Mooring;
pub(crate) use vector::cross;
pub use warning::MooringWarning;
