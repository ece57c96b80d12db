//! Matrices of a piece of tower, which are axisymmetric: inertia, soil, weight.

use super::super::support::independent::Motion;
use super::planes::{Plane, Planes};
use crate::space::{Matrix, SpatialMatrix};

/// A matrix for rigid motions that couples neither the bending planes nor torsion nor stretch:
/// inertia or stiffness.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Axisymmetric {
    /// For deflection w and rotation θ in each plane, θ being minus the rotation about x in the
    /// side-side plane: ww, wθ, θθ.
    pub bending: Planes<[f64; 3]>,
    /// For rotation about the axis.
    pub torsion: f64,
    /// For motion along the axis.
    pub axial: f64,
}

impl Axisymmetric {
    /// The matrix of a bending plane for (w, θ).
    #[inline]
    pub(crate) fn plane(&self, plane: Plane) -> Matrix<2> {
        let [ww, wt, tt] = self.bending.of(plane);
        [[ww, wt], [wt, tt]]
    }

    /// The matrix for the motion (x, y, z, rotation about x, y, z).
    #[inline]
    pub fn spatial(&self) -> SpatialMatrix {
        let mut matrix = [[0.0; 6]; 6];
        for plane in [Plane::ForeAft, Plane::SideSide] {
            let components = Motion::Bending(plane).components();
            for (row, (i, s)) in self.plane(plane).iter().zip(components) {
                for (entry, (j, t)) in row.iter().zip(components) {
                    matrix[*i][*j] = s * t * entry;
                }
            }
        }
        matrix[5][5] = self.torsion;
        matrix[2][2] = self.axial;
        matrix
    }
}
