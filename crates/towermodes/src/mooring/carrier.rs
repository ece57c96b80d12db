//! The owner of a point: ground, platform or a free part, and the position of the point on it.

use super::pose::Placement;
use super::vector::{Vector, sum};

/// The object that moves a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    /// Nothing.
    Ground,
    /// The platform.
    Platform,
    /// A free point, body or rod, by its index in the list of all.
    Free(usize),
}

/// A point of an owner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arm {
    /// The owner.
    pub(super) owner: Owner,
    /// Position from the origin of the owner, in its axes, m; on the ground the position itself.
    pub(super) arm_m: Vector,
}

/// A point of an owner at a given position of the owner.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reached {
    /// Position, m.
    pub(super) position_m: Vector,
    /// Position from the origin of the owner in fixed axes, m.
    pub(super) arm_m: Vector,
}

impl Arm {
    /// The position of the point.
    pub(super) fn reached(&self, platform: &Placement, free: &[Placement]) -> Reached {
        let placement = match self.owner {
            Owner::Ground => {
                return Reached {
                    position_m: self.arm_m,
                    arm_m: self.arm_m,
                };
            }
            Owner::Platform => platform,
            Owner::Free(index) => &free[index],
        };
        let arm_m = placement.turned(self.arm_m);
        Reached {
            position_m: sum(placement.origin_m, arm_m),
            arm_m,
        }
    }
}
