//! A frame as the foundation of a tower.

use super::super::parts::rigid_body::RigidBody;
use super::description::FrameDescription;
use super::error::{FrameError, FramePlace, FrameProblem};
use super::validate::Frame;

/// A frame that carries a tower on its transition piece.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameFoundation {
    /// The frame.
    pub frame: Frame,
    /// The transition piece itself as a rigid body, with its centre from the reference point.
    pub platform: RigidBody,
    /// Whether the weight of the structure changes the stiffness of the members (geometric
    /// stiffness of their forces at rest). OpenFAST's SubDyn leaves it out.
    pub weight_on_members: bool,
    reference_m: [f64; 3],
}

impl FrameFoundation {
    /// A frame with a transition piece that moves.
    ///
    /// # Errors
    /// [`FrameProblem::NoTransition`] if the frame has none, or one that is held.
    pub fn new(frame: Frame, platform: RigidBody) -> Result<Self, FrameError> {
        let transition = frame.description().transition.as_ref();
        match transition.filter(|transition| !transition.is_held) {
            Some(transition) => Ok(Self {
                reference_m: transition.position_m,
                frame,
                platform,
                weight_on_members: true,
            }),
            None => Err(FrameError {
                place: FramePlace::Transition,
                problem: FrameProblem::NoTransition,
            }),
        }
    }

    /// Removes everything but the elastic members, whose elements stay as they are.
    pub(crate) fn remove_masses_and_springs(&mut self) {
        self.platform = RigidBody::default();
        self.frame.remove_masses_and_springs();
    }

    /// Changes the frame, with its joints where they are.
    pub(in crate::tower) fn change(&mut self, change: impl FnOnce(&mut FrameDescription)) {
        let mut description = self.frame.description().clone();
        change(&mut description);
        self.frame = Frame::unchecked(description);
    }

    /// Removes the springs of the soil along members, whose elements stay as they are.
    pub(crate) fn remove_soil(&mut self) {
        self.frame.remove_soil();
    }

    /// The reference point of the transition piece, m; the axis of the tower goes through it.
    pub fn reference_m(&self) -> [f64; 3] {
        self.reference_m
    }
}
