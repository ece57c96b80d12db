//! Space frames as eigenvalue problems: members between joints in space, factored joint by joint.

mod assembly;
pub(crate) mod below;
mod carrying;
mod element;
mod elimination;
mod equations;
mod error;
mod finer;
mod graph;
mod hinge;
mod kinds;
mod local;
mod mechanism;
mod order;
mod parts;
mod pencil;
mod product;
mod recipe;
mod resultant;
mod rigid;
mod shape;
mod solve;
mod static_stiffness;
mod statics;
mod tension;
mod turning_over;

pub(crate) use below::{FrameBelow, ReducedFrame};
pub(crate) use carrying::{BareFrame, OnFrame};
pub use error::FrameSolveError;
pub use recipe::FrameRecipe;
pub use shape::FrameShape;
pub use solve::{FrameMode, FrameOptions, FrameSolution, count_frame_modes, solve_frame};
pub use static_stiffness::static_stiffness;

pub use crate::tower::frame::{
    CoatKind, Frame, FrameCoat, FrameDescription, FrameError, FrameFoundation, FrameJoint,
    FrameMasses, FrameMember, FramePart, FramePlace, FrameProblem, FrameRider, FrameSoil,
    FrameSoilRow, FrameSpring, FrameSupport, GivenSection, JointKind, MarineGrowth, MemberKind,
    MembersInWater, Rectangle, Restoring, SectionEnds, Transition, member_axes, spin_of_axes,
};
