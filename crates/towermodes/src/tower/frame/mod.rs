//! Space frames: joints and members of a jacket, tripod or monopile, as a user describes them.

mod afloat;
mod axes;
mod coat;
mod description;
mod error;
mod foundation;
mod in_water;
mod masses;
mod member;
pub(super) mod part;
mod removal;
mod restoring;
mod soil;
mod validate;
mod warning;

pub(crate) use axes::difference;
pub(in crate::tower) use axes::norm;
pub use axes::{member_axes, spin_of_axes};
pub(in crate::tower) use coat::Substance;
pub use coat::{CoatKind, FrameCoat};
pub use description::{
    FrameDescription, FrameJoint, FrameRider, FrameSupport, JointKind, Transition,
};
pub use error::{FrameError, FramePlace, FrameProblem};
pub use foundation::FrameFoundation;
pub use in_water::{MarineGrowth, MembersInWater};
pub use masses::FrameMasses;
pub use member::{FrameMember, FrameSpring, GivenSection, MemberKind, Rectangle, SectionEnds};
pub use part::FramePart;
pub use restoring::Restoring;
pub use soil::{FrameSoil, FrameSoilRow};
pub use validate::Frame;
pub use warning::FrameWarning;
