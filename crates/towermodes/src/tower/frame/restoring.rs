//! The restoring stiffness of a floating frame.

use crate::space::SpatialMatrix;
use crate::tower::parts::floating_platform::FloatingPlatform;

type OnJoint = (usize, SpatialMatrix);

/// The restoring stiffness of a floating frame: water, weights and moorings.
///
/// Stiffness that acts at a place of the frame is attached to a joint near it: water planes, and
/// lines between an anchor and the frame. The rest is attached to the transition piece. For motions
/// of the frame as a rigid body the sum is that of the rigid platform.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Restoring {
    /// The floater as one rigid body, without the tower and without the body of the transition
    /// piece. Its mass and centre are those of the members with growth and filling; only its
    /// weight, its stiffness, its moorings and its buoyancy are used. Its added mass, beside that
    /// of the members, moves with the transition piece. The overturning moments of the weights of
    /// the tower and of the transition piece are about the height of its hydrostatic stiffness.
    pub platform: FloatingPlatform,
    /// The part of its hydrostatic stiffness that acts on joints: the number of the joint from 0,
    /// and the stiffness for its motion.
    pub water_planes: Vec<(usize, SpatialMatrix)>,
}

impl Restoring {
    /// Whether neither water nor moorings have a stiffness.
    pub(in crate::tower) fn holds_nothing(&self) -> bool {
        let FloatingPlatform {
            hydrostatic,
            mooring,
            mooring_lines,
            ..
        } = &self.platform;
        let matrices = [hydrostatic, mooring].map(|referred| referred.matrix);
        mooring_lines.is_none() && matrices == [SpatialMatrix::default(); 2]
    }
}

/// The stiffness of water, weights and moorings on a frame that floats, where it acts.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Held {
    /// The stiffness of water and weights on the transition piece, for the motion of a point on the
    /// axis of the tower.
    pub(crate) water: SpatialMatrix,
    /// The stiffness of water and weights on joints.
    pub(crate) water_on_joints: Vec<OnJoint>,
    /// The stiffness of the moorings on the transition piece, for the motion of the same point.
    pub(crate) moorings: SpatialMatrix,
    /// The stiffness of the moorings on joints.
    pub(crate) moorings_on_joints: Vec<OnJoint>,
    /// Height of the point, m.
    pub(crate) height_m: f64,
}

impl Held {
    /// The stiffness on joints, of water and moorings.
    pub(crate) fn on_joints(&self) -> impl Iterator<Item = &OnJoint> {
        self.water_on_joints.iter().chain(&self.moorings_on_joints)
    }
}
