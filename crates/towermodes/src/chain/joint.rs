//! The springs of a joint.

use crate::tower::Planes;

/// The flexibilities of the springs in a joint on the tower's axis: 1/k, zero where the joint is
/// rigid.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct JointFlexibility {
    /// Transverse sliding in each plane, m/N.
    pub deflection_m_per_n: Planes<f64>,
    /// Bending rotation in each plane, rad/(N m).
    pub bending_per_n_m: Planes<f64>,
    /// Axial sliding, m/N.
    pub axial_m_per_n: f64,
    /// Rotation about the axis, rad/(N m).
    pub torsion_per_n_m: f64,
}

impl JointFlexibility {
    /// For the motion (x, y, z, rotation about x, y, z).
    pub fn spatial(&self) -> [f64; 6] {
        let (w, theta) = (self.deflection_m_per_n, self.bending_per_n_m);
        [
            w.fore_aft,
            w.side_side,
            self.axial_m_per_n,
            theta.side_side,
            theta.fore_aft,
            self.torsion_per_n_m,
        ]
    }

    /// Whether it bends.
    pub fn turns(&self) -> bool {
        self.bending_per_n_m != Planes::default()
    }

    /// Whether it slides transversely.
    pub fn slides(&self) -> bool {
        self.deflection_m_per_n != Planes::default()
    }

    /// The same joint without what moves in the side-side plane, and a joint with that alone: where
    /// the planes' joints sit apart.
    pub fn split(&self) -> [Self; 2] {
        let (mut others, mut side_side) = (*self, Self::default());
        side_side.deflection_m_per_n.side_side = self.deflection_m_per_n.side_side;
        side_side.bending_per_n_m.side_side = self.bending_per_n_m.side_side;
        others.deflection_m_per_n.side_side = 0.0;
        others.bending_per_n_m.side_side = 0.0;
        [others, side_side]
    }
}
