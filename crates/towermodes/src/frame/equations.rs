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

use super::parts::{MOST_ENDS, Parts, Side};
use super::rigid::{Motion, Vector};
use crate::space::SpatialMatrix;

pub(super) use super::kinds::{ELASTIC, GEOMETRIC, GROUND, INERTIA, KINDS};

/// A link, whose coordinates determine the motion of a node.
#[derive(Debug, Clone)]
pub(super) struct Link {
    /// The node at its near end; none if this end is on the ground.
    pub(super) parent: Option<usize>,
    pub(super) child: usize,
    /// X.
    pub(super) transfer: SpatialMatrix,
    /// The columns of T.
    pub(super) tip: Vec<Motion>,
    /// Index of the first coordinate among the unknowns.
    pub(super) first: usize,
    /// Number of its coordinates: those that move the child, then the bubbles.
    pub(super) coordinates: usize,
    /// Diagonal stiffness of its coordinates: 1 for an element, 0 for a hinge or a support that
    /// moves.
    pub(super) own: f64,
    /// Matrices for the motion of the parent, the coordinates that move the child, and the bubbles.
    pub(super) parts: Parts,
}

/// An element between two nodes whose motions are determined by links.
#[derive(Debug, Clone)]
pub(super) struct Chord {
    /// The nodes at both ends; none for an end on the ground.
    pub(super) ends: [Option<usize>; 2],
    /// Positions of the ends, m.
    pub(super) ends_m: [Vector; 2],
    /// Index of the first bubble among the unknowns.
    pub(super) first: usize,
    /// Matrices for the motions of both ends and the bubbles.
    pub(super) parts: Parts,
}

/// The equations of a frame.
#[derive(Debug, Clone, Default)]
pub(super) struct Equations {
    /// The links, parents before children.
    pub(super) links: Vec<Link>,
    pub(super) chords: Vec<Chord>,
    /// The matrices attached to each node, by kind.
    pub(super) nodes: Vec<[SpatialMatrix; KINDS]>,
    /// Number of unknowns.
    pub(super) unknowns: usize,
}

impl Link {
    /// Its ends and bubbles for the unknowns x and the motion of its parent.
    pub(super) fn side<'a>(&self, x: &'a [f64], near: &Motion) -> Side<'a> {
        let moving = self.tip.len();
        let (own, bubbles) = x[self.first..][..self.coordinates].split_at(moving);
        let mut ends = [0.0; MOST_ENDS];
        ends[..6].copy_from_slice(&self.parts.to_axes(near));
        ends[6..6 + moving].copy_from_slice(own);
        Side { ends, bubbles }
    }
}

impl Chord {
    /// Its ends and bubbles for the unknowns x and the motions of its ends.
    pub(super) fn side<'a>(&self, x: &'a [f64], motions: [Motion; 2]) -> Side<'a> {
        let [near, far] = motions.map(|motion| self.parts.to_axes(&motion));
        let mut ends = [0.0; MOST_ENDS];
        ends[..6].copy_from_slice(&near);
        ends[6..].copy_from_slice(&far);
        Side {
            ends,
            bubbles: &x[self.first..][..self.parts.bubbles()],
        }
    }
}

impl Equations {
    /// The equations of these numbers of nodes and links alone, as [`shrink`](Self::shrink).
    pub(super) fn first(&self, bare: (usize, usize)) -> Self {
        let mut first = self.clone();
        first.shrink(bare);
        first
    }

    /// Removes nodes and links beyond these numbers: what hangs on the others, without chords.
    pub(super) fn shrink(&mut self, (nodes, links): (usize, usize)) {
        self.nodes.truncate(nodes);
        for link in self.links.drain(links..) {
            self.unknowns -= link.coordinates;
        }
    }
}

/// The motion of a node, or that of the ground.
pub(super) fn motion_of(motions: &[Motion], node: Option<usize>) -> Motion {
    node.map_or([0.0; 6], |node| motions[node])
}

/// Adds a force to the force on a node; forces on the ground are ignored.
pub(super) fn add_force(forces: &mut [Motion], node: Option<usize>, force: &[f64]) {
    if let Some(node) = node {
        for (sum, force) in forces[node].iter_mut().zip(force) {
            *sum += force;
        }
    }
}
