//! The equations of a frame: links that carry nodes from node to node, chords that close loops.
//!
//! A node is a point with a motion q (x, y, z, rotation about x, y, z). One link carries each node:
//! q = X q_parent + T y, from another node or from the ground, with coordinates y. So the links are
//! trees, and the coordinates of all links determine all motions. A chord is an element between two
//! nodes that other links carry. The unknowns are the coordinates of the links and the bubbles of
//! links and chords.
//!
//! Stiff and short members are links, whose stiffness is the identity for their own coordinates: it
//! never meets the rigid motions of the rest, so a member of a millimetre costs no digit.

use super::rigid::Motion;
use crate::space::SpatialMatrix;

/// The kinds of matrices: inertia, stiffness to the ground, geometric stiffness, and elastic
/// stiffness of what has no own coordinates.
pub(super) const KINDS: usize = 4;
pub(super) const INERTIA: usize = 0;
pub(super) const GROUND: usize = 1;
pub(super) const GEOMETRIC: usize = 2;
pub(super) const ELASTIC: usize = 3;

/// What carries a node.
#[derive(Debug, Clone)]
pub(super) struct Link {
    /// The node that it hangs on; none: the ground.
    pub(super) parent: Option<usize>,
    pub(super) child: usize,
    /// X.
    pub(super) transfer: SpatialMatrix,
    /// The columns of T.
    pub(super) tip: Vec<Motion>,
    /// Place of the first coordinate among the unknowns.
    pub(super) first: usize,
    /// All coordinates: those that move the child, then the bubbles.
    pub(super) coordinates: usize,
    /// Stiffness for each coordinate: 1 of an element, 0 of a hinge or a support that moves.
    pub(super) own: f64,
    /// For the motion of the parent and the coordinates: 6 + coordinates rows, or empty.
    pub(super) matrices: [Vec<f64>; KINDS],
}

impl Link {
    pub(super) fn rows(&self) -> usize {
        6 + self.coordinates
    }
}

/// An element between two nodes that other links carry.
#[derive(Debug, Clone)]
pub(super) struct Chord {
    /// None: the ground.
    pub(super) ends: [Option<usize>; 2],
    /// Place of the first bubble among the unknowns.
    pub(super) first: usize,
    pub(super) bubbles: usize,
    /// For the motions of both ends and the bubbles: 12 + bubbles rows, or empty.
    pub(super) matrices: [Vec<f64>; KINDS],
}

impl Chord {
    pub(super) fn rows(&self) -> usize {
        12 + self.bubbles
    }
}

/// The equations of a frame.
#[derive(Debug, Clone, Default)]
pub(super) struct Equations {
    /// Parents before children.
    pub(super) links: Vec<Link>,
    pub(super) chords: Vec<Chord>,
    /// What is attached to each node, by kind.
    pub(super) nodes: Vec<[SpatialMatrix; KINDS]>,
    /// Number of unknowns.
    pub(super) unknowns: usize,
}

/// The motion of a node, or that of the ground.
pub(super) fn motion_of(motions: &[Motion], node: Option<usize>) -> Motion {
    node.map_or([0.0; 6], |node| motions[node])
}

/// Adds a force to that on a node; the ground takes any.
pub(super) fn add_force(forces: &mut [Motion], node: Option<usize>, force: &[f64]) {
    if let Some(node) = node {
        for (sum, force) in forces[node].iter_mut().zip(force) {
            *sum += force;
        }
    }
}

/// sum += factor·A for the lower triangle or the whole of matrices of the same size.
pub(super) fn add_matrices(factors: &[f64; KINDS], matrices: &[Vec<f64>; KINDS], sum: &mut [f64]) {
    for (factor, matrix) in factors.iter().zip(matrices) {
        if *factor != 0.0 {
            for (sum, entry) in sum.iter_mut().zip(matrix) {
                *sum += factor * entry;
            }
        }
    }
}
