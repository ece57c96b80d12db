//! The independent beams of an axisymmetric tower: two bending planes, torsion, axial.

use super::model::Beam;
use crate::chain::RigidBody;

/// The beams into which a tower with everything on its axis falls apart.
#[derive(Debug, Clone, Default)]
pub struct DecoupledBeams {
    /// Bending in the fore-aft plane.
    pub fore_aft: Beam<2>,
    /// Bending in the side-side plane; empty if it equals the fore-aft one.
    pub side_side: Beam<2>,
    /// Twist about the axis.
    pub torsion: Beam<1>,
    /// Stretch along the axis.
    pub axial: Beam<1>,
    planes_are_equal: bool,
}

impl DecoupledBeams {
    /// Forgets all elements but keeps the memory; elements from here on have these coordinates: curvature and shear in bending, torsion,
    /// axial.
    pub fn restart(
        &mut self,
        planes_are_equal: bool,
        (curvature, shear): (usize, usize),
        torsion: usize,
        axial: usize,
    ) {
        self.planes_are_equal = planes_are_equal;
        self.fore_aft.restart(curvature, shear);
        self.side_side.restart(curvature, shear);
        self.torsion.restart(torsion, 0);
        self.axial.restart(axial, 0);
    }

    /// Whether the side-side plane is the fore-aft one again.
    pub fn planes_are_equal(&self) -> bool {
        self.planes_are_equal
    }

    /// A body, given about a height (m), on the top of the last element.
    pub fn add_body(&mut self, reference_m: f64, body: &RigidBody) {
        self.fore_aft.add_body(reference_m, body.fore_aft());
        self.side_side.add_body(reference_m, body.side_side());
        self.torsion.add_body(reference_m, body.torsion());
        self.axial.add_body(reference_m, body.axial());
    }

    /// Degrees of freedom of the whole tower, an equal plane counted twice.
    pub fn degrees_of_freedom(&self) -> usize {
        let side_side = if self.planes_are_equal {
            &self.fore_aft
        } else {
            &self.side_side
        };
        self.fore_aft.degrees_of_freedom()
            + side_side.degrees_of_freedom()
            + self.torsion.degrees_of_freedom()
            + self.axial.degrees_of_freedom()
    }

    /// Whether every number in every beam is finite.
    pub fn is_finite(&self) -> bool {
        self.fore_aft.is_finite()
            && self.side_side.is_finite()
            && self.torsion.is_finite()
            && self.axial.is_finite()
    }
}
