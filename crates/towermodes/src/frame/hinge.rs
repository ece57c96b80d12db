//! Hinges: pins, universal joints and ball joints between the members of one joint.

use super::rigid::{Motion, NONE, Vector, identity};
use crate::space::SpatialMatrix;
use crate::tower::frame::JointKind;

/// The motion (m or rad) for a coordinate of 1 of a free motion.
pub(super) const UNIT: f64 = 1e-4;

/// The relation of the motions of two members at a hinge.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Hinge {
    /// The motion of the second end for that of the first without rotation of the hinge, and the
    /// inverse.
    transfers: [SpatialMatrix; 2],
    /// The motion of the second end for each rotation of the hinge, and the inverse.
    rotations: [Vec<Motion>; 2],
}

impl Hinge {
    /// The hinge between two members with these axes (rows x, y, z, with z along the member); none
    /// if they are welded.
    pub(super) fn new(kind: &JointKind, axes: [&[Vector; 3]; 2]) -> Option<Self> {
        let about = |axes: &[Vector]| axes.iter().map(|axis| rotation(*axis)).collect();
        match kind {
            JointKind::Cantilever => None,
            JointKind::Pin { axis, .. } => Some(Self::symmetric(about(&[unit(*axis)]))),
            JointKind::Ball { .. } => Some(Self::symmetric(about(&[
                [1.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                [0.0, 0.0, 1.0],
            ]))),
            JointKind::Universal { .. } => Some(Self {
                transfers: [torsion(axes[0], axes[1]), torsion(axes[1], axes[0])],
                rotations: [about(&axes[1][..2]), about(&axes[0][..2])],
            }),
        }
    }

    fn symmetric(rotations: Vec<Motion>) -> Self {
        Self {
            transfers: [identity(); 2],
            rotations: [rotations.clone(), rotations],
        }
    }

    /// X and the columns of T of the second end, or of the first if `reversed`.
    pub(super) fn link(&self, reversed: bool) -> (SpatialMatrix, Vec<Motion>) {
        let way = usize::from(reversed);
        (self.transfers[way], self.rotations[way].clone())
    }
}

fn unit(axis: Vector) -> Vector {
    let length = axis.iter().map(|a| a * a).sum::<f64>().sqrt();
    axis.map(|a| a / length)
}

fn rotation(axis: Vector) -> Motion {
    std::array::from_fn(|i| if i < 3 { 0.0 } else { UNIT * axis[i - 3] })
}

/// The second end of a universal joint: each member rotates by the same angle about its own axis,
/// e₂·φ₂ = e₁·φ₁, so that φ₂ = φ₁ + e₂ (e₁ − e₂)·φ₁ but for bending.
fn torsion(from: &[Vector; 3], to: &[Vector; 3]) -> SpatialMatrix {
    let mut matrix = identity();
    for i in 0..3 {
        for j in 0..3 {
            matrix[3 + i][3 + j] += to[2][i] * (from[2][j] - to[2][j]);
        }
    }
    matrix
}

/// The stiffness of the springs of a joint between two of its members, for the motions of both
/// ends: 12 rows.
pub(super) fn spring(kind: &JointKind, axes: [&[Vector; 3]; 2]) -> Option<[SpatialMatrix; 3]> {
    let (stiffness, pairs): (f64, Vec<[Vector; 2]>) = match kind {
        JointKind::Cantilever => return None,
        JointKind::Pin {
            axis,
            stiffness_n_m_per_rad,
        } => (*stiffness_n_m_per_rad, vec![[unit(*axis); 2]]),
        JointKind::Ball {
            stiffness_n_m_per_rad,
        } => {
            let all = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            (*stiffness_n_m_per_rad, all.map(|axis| [axis; 2]).to_vec())
        }
        JointKind::Universal {
            stiffness_n_m_per_rad,
        } => {
            let of = |k: usize| [axes[0][k], axes[1][k]];
            (*stiffness_n_m_per_rad, vec![of(0), of(1)])
        }
    };
    if stiffness == 0.0 {
        return None;
    }
    let mut sum = [NONE; 3];
    for [a, b] in pairs {
        for i in 0..3 {
            for j in 0..3 {
                sum[0][3 + i][3 + j] += stiffness * a[i] * a[j];
                sum[1][3 + i][3 + j] -= stiffness * a[i] * b[j];
                sum[2][3 + i][3 + j] += stiffness * b[i] * b[j];
            }
        }
    }
    Some(sum)
}
