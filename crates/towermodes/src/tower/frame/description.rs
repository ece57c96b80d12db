//! The description of a frame: joints, members, supports, masses and the transition piece.

use super::super::parts::rigid_body::RigidBody;
use super::member::FrameMember;
use crate::space::SpatialMatrix;

/// A space frame: members between joints, supports, masses, and the joints that carry the tower.
/// [`Frame::new`](super::Frame::new) checks it.
///
/// Coordinates are x fore-aft (downwind), y side-side, z up, m, in the datum of the tower.
///
/// # Example
/// A tube of 20 m that is clamped at its lower end:
/// ```
/// use towermodes::frame::*;
/// use towermodes::{Material, tower::Tube};
///
/// let steel = Material::from_shear_modulus(7850.0, 2.1e11, 8.08e10);
/// let tube = Tube { outer_diameter_m: 2.0, wall_thickness_m: 0.03 };
/// let frame = Frame::new(FrameDescription {
///     joints: vec![
///         FrameJoint::new("1", [0.0, 0.0, -20.0]),
///         FrameJoint::new("2", [0.0, 0.0, 0.0]),
///     ],
///     members: vec![FrameMember::tube("1", [0, 1], [tube, tube], steel)],
///     supports: vec![FrameSupport::clamped(0)],
///     ..FrameDescription::default()
/// })?;
/// assert!((frame.mass_kg() - 29149.895755).abs() < 1e-6);
/// # Ok::<(), FrameError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FrameDescription {
    /// The joints.
    pub joints: Vec<FrameJoint>,
    /// The members between them.
    pub members: Vec<FrameMember>,
    /// Joints that are supported.
    pub supports: Vec<FrameSupport>,
    /// Rigid bodies on joints: the number of the joint from 0, and the body with its centre from
    /// the joint.
    pub masses: Vec<(usize, RigidBody)>,
    /// Inertia that moves with joints and has no weight, such as the added mass of the ends of
    /// members: the number of the joint from 0, and the matrix, kg, kg m, kg m².
    pub added_masses: Vec<(usize, SpatialMatrix)>,
    /// Inertia that moves with points of members and has no weight, such as added mass of
    /// members of a coarser description.
    pub riders: Vec<FrameRider>,
    /// The rigid transition piece, if there is one.
    pub transition: Option<Transition>,
}

/// Inertia that moves with a section of a beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameRider {
    /// The member, from 0; a beam.
    pub member: usize,
    /// Where it is, as a fraction of the length from the first joint.
    pub fraction: f64,
    /// Inertia for the motion (x, y, z, rotation about x, y, z) of the point of the member's axis,
    /// kg, kg m, kg m².
    pub inertia: SpatialMatrix,
}

/// A joint.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameJoint {
    /// Name in messages and results, for example the number in a file.
    pub name: String,
    /// Position, m.
    pub position_m: [f64; 3],
    /// How the members are connected here.
    pub kind: JointKind,
}

impl FrameJoint {
    /// A joint in which all members are welded.
    pub fn new(name: impl Into<String>, position_m: [f64; 3]) -> Self {
        Self {
            name: name.into(),
            position_m,
            kind: JointKind::Cantilever,
        }
    }
}

/// How the members of a joint are connected. All share its translations.
///
/// A stiffness is that of a rotational spring between each two members, N m/rad.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum JointKind {
    /// Welded: all rotations are shared.
    #[default]
    Cantilever,
    /// A pin: each member rotates by itself about one axis.
    Pin {
        /// Direction of the axis; its length does not matter.
        axis: [f64; 3],
        /// Stiffness of the spring about the axis, N m/rad.
        stiffness_n_m_per_rad: f64,
    },
    /// A universal joint of two members: bending is free, the rotation of each member about its own
    /// axis is shared.
    Universal {
        /// Stiffness of the springs about the two transverse axes of each member, N m/rad.
        stiffness_n_m_per_rad: f64,
    },
    /// A ball joint: no rotation is shared.
    Ball {
        /// Stiffness of the springs about x, y and z, N m/rad.
        stiffness_n_m_per_rad: f64,
    },
}

/// A support of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameSupport {
    /// The joint, from 0.
    pub joint: usize,
    /// Which motions (x, y, z, rotation about x, y, z) are held.
    pub fixed: [bool; 6],
    /// Stiffness of the soil against the motions of the joint, N/m, N, N m.
    pub stiffness: SpatialMatrix,
    /// Inertia of soil that moves with the joint, kg, kg m, kg m².
    pub inertia: SpatialMatrix,
}

impl FrameSupport {
    /// A support that holds all motions.
    pub fn clamped(joint: usize) -> Self {
        Self {
            joint,
            fixed: [true; 6],
            stiffness: [[0.0; 6]; 6],
            inertia: [[0.0; 6]; 6],
        }
    }

    /// Whether all motions are held.
    pub fn is_clamped(&self) -> bool {
        self.fixed == [true; 6]
    }
}

/// A rigid transition piece: a point to which joints are connected rigidly.
#[derive(Debug, Clone, PartialEq)]
pub struct Transition {
    /// Its reference point, m.
    pub position_m: [f64; 3],
    /// The joints that move with it, from 0.
    pub joints: Vec<usize>,
    /// Whether it is held: then the frame is solved below a clamped transition piece.
    pub is_held: bool,
}
