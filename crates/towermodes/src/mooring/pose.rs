//! Position and orientation of a rigid body.

use super::vector::{IDENTITY, Matrix3, Vector, product, rotation, rotation_vector, sum, times};

/// A displacement of the platform from its reference pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Displacement of its reference point, m.
    pub displacement_m: [f64; 3],
    /// The rotation matrix R by rows: an arm r from the reference point becomes R r.
    pub rotation: [[f64; 3]; 3],
}

/// The reference pose.
impl Default for Pose {
    fn default() -> Self {
        Self {
            displacement_m: [0.0; 3],
            rotation: IDENTITY,
        }
    }
}

impl Pose {
    /// A displacement (m) and a rotation vector (rad).
    pub fn new(displacement_m: [f64; 3], rotation_rad: [f64; 3]) -> Self {
        Self {
            displacement_m,
            rotation: rotation(rotation_rad),
        }
    }

    /// The pose after a further motion (m, rad) of the reference point, in fixed axes:
    /// R ← exp\[δθ\] R.
    #[must_use]
    pub fn moved(&self, [x, y, z, rx, ry, rz]: [f64; 6]) -> Self {
        Self {
            displacement_m: sum(self.displacement_m, [x, y, z]),
            rotation: product(&rotation([rx, ry, rz]), &self.rotation),
        }
    }

    /// The rotation vector (axis times angle) of the pose, rad.
    pub fn rotation_rad(&self) -> [f64; 3] {
        rotation_vector(&self.rotation)
    }
}

/// The origin and the axes of an object to which points belong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Placement {
    /// Position of the origin, m.
    pub(super) origin_m: Vector,
    /// Its axes as columns.
    pub(super) rotation: Matrix3,
}

impl Placement {
    /// The placement at this origin, with the axes of the reference pose.
    pub(super) fn at(origin_m: Vector) -> Self {
        Self {
            origin_m,
            rotation: IDENTITY,
        }
    }

    /// The placement after a displacement and a rotation about its origin, in fixed axes.
    pub(super) fn moved(&self, displacement_m: Vector, rotation_rad: Vector) -> Self {
        Self {
            origin_m: sum(self.origin_m, displacement_m),
            rotation: product(&rotation(rotation_rad), &self.rotation),
        }
    }

    /// A vector in its axes, transformed to fixed axes.
    pub(super) fn turned(&self, arm_m: Vector) -> Vector {
        times(&self.rotation, arm_m)
    }
}
