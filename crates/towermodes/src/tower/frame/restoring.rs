//! What holds a frame that floats.

use crate::space::SpatialMatrix;

/// The stiffness of buoyancy, water plane, weights and moorings of a frame that floats.
///
/// Of both the water and the moorings, what acts at a place of the frame is on a joint near it; the
/// rest moves with the transition piece. For motions of the frame as a rigid body the sum is that
/// of the rigid platform. The weights of the tower and of the transition piece's own body are not
/// part of it: they turn over about the point at `height_m`, as on a
/// [`FloatingPlatform`](crate::FloatingPlatform).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Restoring {
    /// Stiffness for the motion (x, y, z, rotation about x, y, z) of a point on the axis of the
    /// tower that moves with the transition piece: N/m, N, N m.
    pub matrix: SpatialMatrix,
    /// Height of this point, m.
    pub height_m: f64,
    /// Stiffness for the motion of joints: the number of the joint from 0, and the matrix.
    pub on_joints: Vec<(usize, SpatialMatrix)>,
    /// Stiffness of the moorings for the motion of the same point.
    pub moorings: SpatialMatrix,
    /// Stiffness of the moorings for the motion of joints.
    pub moorings_on_joints: Vec<(usize, SpatialMatrix)>,
}

impl Restoring {
    /// All entries of all matrices.
    pub(in crate::tower) fn entries(&self) -> impl Iterator<Item = f64> + '_ {
        let on_joints = self.all_on_joints().map(|(_, matrix)| matrix);
        let all = [&self.matrix, &self.moorings].into_iter().chain(on_joints);
        all.flat_map(|matrix| matrix.iter().flatten().copied())
    }

    /// The stiffness on joints, of water and moorings.
    pub(crate) fn all_on_joints(&self) -> impl Iterator<Item = &(usize, SpatialMatrix)> {
        self.on_joints.iter().chain(&self.moorings_on_joints)
    }
}
