//! The rotational stiffness of forces of constant direction on a rigid body (P-Delta effect).
//!
//! A point at r from the point whose motion is known moves by θ × r + ½ θ × (θ × r). A force F
//! on it does work on the second term, so the body has the stiffness (F·r) 1 − ½ (r Fᵀ + F rᵀ)
//! against rotation. Such forces are weights on the transition piece, and what rigid links pass on
//! at rest. Without the forces in rigid links, frequencies would depend on where the reference
//! point of a transition piece is.

use super::equations::{ELASTIC, Equations, GEOMETRIC, GROUND, INERTIA, KINDS};
use super::resultant::lever_of;
use super::rigid::{NONE, Vector};
use crate::space::{SpatialMatrix, add_scaled};

/// A rigid link of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct RigidLink {
    /// Index of its edge in the graph, the same for each frame with the same members.
    pub(super) edge: usize,
    /// Index of the link.
    pub(super) link: usize,
}

/// The stiffness of a force F (N) at r (m) on a rigid body.
pub(super) fn turning_over(force_n: Vector, arm_m: Vector) -> SpatialMatrix {
    let work: f64 = force_n.iter().zip(arm_m).map(|(f, r)| f * r).sum();
    let mut matrix = NONE;
    for i in 0..3 {
        for j in 0..3 {
            let mean = 0.5 * (force_n[i] * arm_m[j] + arm_m[i] * force_n[j]);
            matrix[3 + i][3 + j] = if i == j { work - mean } else { -mean };
        }
    }
    matrix
}

/// The stiffness of the forces in rigid links under weight, by index of the edge, for the static
/// unknowns x.
pub(super) fn of_rigid_links(
    equations: &Equations,
    rigid_links: &[RigidLink],
    x: &[f64],
    gravity_m_per_s2: f64,
) -> Vec<(usize, SpatialMatrix)> {
    if rigid_links.is_empty() {
        return Vec::new();
    }
    let (mut weights, mut stiffness) = ([0.0; KINDS], [0.0; KINDS]);
    weights[INERTIA] = -gravity_m_per_s2;
    (stiffness[GROUND], stiffness[ELASTIC]) = (1.0, 1.0);
    let upwards = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    let passed = equations.passed_on((&weights, upwards), (&stiffness, x));
    let of_link = |rigid: &RigidLink| {
        let [fx, fy, fz, ..] = passed[rigid.link];
        let arm_m = lever_of(&equations.links[rigid.link].transfer);
        (rigid.edge, turning_over([fx, fy, fz], arm_m))
    };
    rigid_links.iter().map(of_link).collect()
}

impl Equations {
    /// Adds the stiffness of the forces in rigid links to the child nodes of the links.
    pub(super) fn turn_over(
        &mut self,
        rigid_links: &[RigidLink],
        stiffness: &[(usize, SpatialMatrix)],
    ) {
        for rigid in rigid_links {
            let own = stiffness.iter().find(|(edge, _)| *edge == rigid.edge);
            let node = self.links[rigid.link].parent;
            if let (Some((_, matrix)), Some(node)) = (own, node) {
                add_scaled(&mut self.nodes[node][GEOMETRIC], 1.0, matrix);
            }
        }
    }
}
