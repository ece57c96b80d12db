//! Bodies and joints of a tower in space, and what each decoupled chain sees of them.

use super::space::Matrix;
use crate::tower::{Plane, Planes};

/// A rigid body whose centre of mass lies on the tower's axis, seen from a reference height on that axis.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RigidBody {
    /// Mass m, kg.
    pub mass_kg: f64,
    /// First moment m·c of the centre's height c above the reference, kg m.
    pub first_moment_kg_m: f64,
    /// Inertia about the fore-aft axis through the reference, kg m².
    pub inertia_xx_kg_m2: f64,
    /// Inertia about the side-side axis through the reference, kg m².
    pub inertia_yy_kg_m2: f64,
    /// Inertia about the tower's axis, kg m².
    pub inertia_zz_kg_m2: f64,
}

impl RigidBody {
    /// A point mass at the reference.
    pub fn point(mass_kg: f64) -> Self {
        Self {
            mass_kg,
            ..Self::default()
        }
    }

    /// What the fore-aft bending chain sees: deflection x and rotation about y.
    pub fn fore_aft(&self) -> Matrix<2> {
        let s = self.first_moment_kg_m;
        [[self.mass_kg, s], [s, self.inertia_yy_kg_m2]]
    }

    /// What the side-side bending chain sees: deflection y and minus the rotation about x, so that the chain is the same.
    pub fn side_side(&self) -> Matrix<2> {
        let s = self.first_moment_kg_m;
        [[self.mass_kg, s], [s, self.inertia_xx_kg_m2]]
    }

    /// What the torsion chain sees.
    pub fn torsion(&self) -> Matrix<1> {
        [[self.inertia_zz_kg_m2]]
    }

    /// What the axial chain sees.
    pub fn axial(&self) -> Matrix<1> {
        [[self.mass_kg]]
    }

    /// The spatial inertia `[[m 1, −m [c]×], [m [c]×, J]]` for the motion (x, y, z, rx, ry, rz) of the reference.
    pub fn spatial(&self) -> Matrix<6> {
        let (m, s) = (self.mass_kg, self.first_moment_kg_m);
        let mut matrix = [[0.0; 6]; 6];
        let diagonal = [
            m,
            m,
            m,
            self.inertia_xx_kg_m2,
            self.inertia_yy_kg_m2,
            self.inertia_zz_kg_m2,
        ];
        for (i, value) in diagonal.into_iter().enumerate() {
            matrix[i][i] = value;
        }
        (matrix[0][4], matrix[4][0]) = (s, s);
        (matrix[1][3], matrix[3][1]) = (-s, -s);
        matrix
    }
}

/// The flexibilities of the springs in a joint on the tower's axis: 1/k, zero where the joint is rigid.
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
    /// For the bending chain of a plane: deflection, rotation.
    pub fn bending(&self, plane: Plane) -> [f64; 2] {
        [
            self.deflection_m_per_n.of(plane),
            self.bending_per_n_m.of(plane),
        ]
    }

    /// For the torsion chain.
    pub fn torsion(&self) -> [f64; 1] {
        [self.torsion_per_n_m]
    }

    /// For the axial chain.
    pub fn axial(&self) -> [f64; 1] {
        [self.axial_m_per_n]
    }

    /// For the coupled chain (x, y, z, rx, ry, rz).
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

    /// The same joint without what moves in the side-side plane, and a joint with that alone: where the planes' joints sit apart.
    pub fn split(&self) -> [Self; 2] {
        let (mut others, mut side_side) = (*self, Self::default());
        side_side.deflection_m_per_n.side_side = self.deflection_m_per_n.side_side;
        side_side.bending_per_n_m.side_side = self.bending_per_n_m.side_side;
        others.deflection_m_per_n.side_side = 0.0;
        others.bending_per_n_m.side_side = 0.0;
        [others, side_side]
    }
}
