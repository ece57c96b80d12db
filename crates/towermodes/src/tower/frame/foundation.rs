//! A frame as the foundation of a tower.

use super::super::parts::material::Material;
use super::super::parts::rigid_body::RigidBody;
use super::super::parts::surroundings::Water;
use super::description::FrameDescription;
use super::error::{FrameError, FramePlace, FrameProblem};
use super::in_water::MembersInWater;
use super::member::MemberKind;
use super::restoring::{Held, Restoring};
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
    /// Whether the buoyancy of members in water carries a part of that weight. Then the force in a
    /// member is its effective tension, that of its wall with the pressure of the water on its
    /// cross section, which is what changes its stiffness. Off by default: the weight of a tower in
    /// water has no buoyancy either, and a monopile then has one frequency as a member and as a
    /// tower.
    pub buoyancy_on_members: bool,
    /// For each member, the index of its material among the materials of the tower; a member
    /// without one, or beyond the end of the list, has a material of its own.
    pub materials: Vec<Option<usize>>,
    /// Marine growth and flooded members in the water of the tower.
    pub in_water: MembersInWater,
    /// Stiffness of water and moorings that holds a floating frame; none for a frame on supports.
    pub restoring: Option<Restoring>,
    /// The stiffness that holds the frame of a tower, if it floats.
    pub(crate) held: Option<Held>,
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
                buoyancy_on_members: false,
                materials: Vec::new(),
                in_water: MembersInWater::default(),
                restoring: None,
                held: None,
            }),
            None => Err(FrameError {
                place: FramePlace::Transition,
                problem: FrameProblem::NoTransition,
            }),
        }
    }

    /// Height of the point about which the weights on the transition piece turn over, m: only about
    /// that of the buoyancy's stiffness its entries and theirs add up.
    pub(crate) fn pivot_m(&self) -> f64 {
        let [_, _, reference_m] = self.reference_m;
        self.restoring.as_ref().map_or(reference_m, |restoring| {
            restoring.platform.hydrostatic.height_m
        })
    }

    /// Gravity for the forces of members at rest, m/s²: afloat none, because buoyancy carries the
    /// weight where it is and is not among them.
    pub(crate) fn gravity_on_members(&self, gravity_m_per_s2: f64) -> f64 {
        match self.weight_on_members && self.restoring.is_none() {
            true => gravity_m_per_s2,
            false => 0.0,
        }
    }

    /// Changes the description of the frame; the joints keep their positions.
    pub(in crate::tower) fn change(&mut self, change: impl FnOnce(&mut FrameDescription)) {
        let mut description = self.frame.description().clone();
        change(&mut description);
        self.frame = Frame::unchecked(description);
    }

    /// Removes all springs to the ground, along members and at supports.
    pub(in crate::tower) fn remove_springs(&mut self) {
        self.frame.multiply_soil(0.0);
    }

    /// The description of the frame, mutable. [`Tower::new`](crate::Tower::new) checks its values.
    pub fn numbers_mut(&mut self) -> &mut FrameDescription {
        self.frame.numbers_mut()
    }

    /// Gives members the materials of the tower and puts its water on them.
    pub(in crate::tower) fn complete(&mut self, materials: &[Material], water: Option<&Water>) {
        self.take_materials(materials);
        if let Some(water) = water {
            self.in_water.put_on(self.frame.numbers_mut(), water);
        }
    }

    /// Gives members the materials of the tower.
    pub(crate) fn take_materials(&mut self, materials: &[Material]) {
        let frame = self.frame.numbers_mut();
        for (member, index) in frame.members.iter_mut().zip(&self.materials) {
            let of_tower = index.and_then(|index| materials.get(index));
            if let (MemberKind::Beam { material, .. }, Some(own)) = (&mut member.kind, of_tower) {
                *material = *own;
            }
        }
    }

    /// Height of the lowest joint, m.
    pub fn lowest_m(&self) -> f64 {
        let joints = self.frame.description().joints.iter();
        let heights_m = joints.map(|joint| joint.position_m[2]);
        heights_m.fold(f64::INFINITY, f64::min)
    }

    /// The reference point of the transition piece, m; the axis of the tower goes through it.
    pub fn reference_m(&self) -> [f64; 3] {
        self.reference_m
    }
}
