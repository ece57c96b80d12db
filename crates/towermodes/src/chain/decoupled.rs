//! The independent chains of an axisymmetric tower: two bending planes, torsion, axial.

use super::model::Chain;
use super::spatial::{JointFlexibility, RigidBody};
use crate::tower::Plane;

/// The chains into which a tower with everything on its axis falls apart.
///
/// A recipe tells it joints and bodies from the base up; each chain takes from them what it can feel, and bodies between joints that
/// a chain does not feel become one.
#[derive(Debug, Clone, Default)]
pub struct DecoupledChains {
    /// Bending in the fore-aft plane.
    pub fore_aft: Chain<2>,
    /// Bending in the side-side plane; empty if it equals the fore-aft one.
    pub side_side: Chain<2>,
    /// Twist about the axis.
    pub torsion: Chain<1>,
    /// Stretch along the axis.
    pub axial: Chain<1>,
    planes_are_equal: bool,
}

impl DecoupledChains {
    /// Forgets all joints and bodies, keeps the memory, and makes room for `joints` joints.
    pub fn restart(&mut self, planes_are_equal: bool, joints: usize) {
        self.planes_are_equal = planes_are_equal;
        self.fore_aft.clear();
        self.side_side.clear();
        self.torsion.clear();
        self.axial.clear();
        self.fore_aft.reserve(joints);
        if !planes_are_equal {
            self.side_side.reserve(joints);
        }
    }

    /// Whether the side-side plane is the fore-aft one again.
    pub fn planes_are_equal(&self) -> bool {
        self.planes_are_equal
    }

    /// A joint at a height (m); see [`Chain::add_joint`].
    pub fn add_joint(&mut self, height_m: f64, flexibility: &JointFlexibility) {
        self.fore_aft
            .add_joint(height_m, flexibility.bending(Plane::ForeAft));
        if !self.planes_are_equal {
            self.side_side
                .add_joint(height_m, flexibility.bending(Plane::SideSide));
        }
        self.torsion.add_joint(height_m, flexibility.torsion());
        self.axial.add_joint(height_m, flexibility.axial());
    }

    /// A body, given about a height (m); see [`Chain::add_body`].
    pub fn add_body(&mut self, reference_m: f64, body: &RigidBody) {
        self.fore_aft.add_body(reference_m, body.fore_aft());
        if !self.planes_are_equal {
            self.side_side.add_body(reference_m, body.side_side());
        }
        self.torsion.add_body(reference_m, body.torsion());
        self.axial.add_body(reference_m, body.axial());
    }

    /// Degrees of freedom of the whole tower, an equal plane counted twice.
    pub fn degrees_of_freedom(&self) -> usize {
        let bending = if self.planes_are_equal {
            2 * self.fore_aft.degrees_of_freedom()
        } else {
            self.fore_aft.degrees_of_freedom() + self.side_side.degrees_of_freedom()
        };
        bending + self.torsion.degrees_of_freedom() + self.axial.degrees_of_freedom()
    }

    /// Whether every number in every chain is finite.
    pub fn is_finite(&self) -> bool {
        self.fore_aft.is_finite()
            && self.side_side.is_finite()
            && self.torsion.is_finite()
            && self.axial.is_finite()
    }
}
