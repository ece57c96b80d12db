//! What a point rides on, and where it is there.

use super::pose::Placement;
use super::vector::{Vector, sum};

/// What moves a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    /// Nothing.
    Ground,
    /// The platform.
    Platform,
    /// A free point, body or rod, by its place in the list of all.
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

/// A point of an owner at a moment.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reached {
    /// Position, m.
    pub(super) position_m: Vector,
    /// Position from the origin of the owner in fixed axes, m.
    pub(super) arm_m: Vector,
}

impl Arm {
    /// Where it is.
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
