//! The graph of a frame: its nodes, the edges between them, and the spanning trees.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::hinge::Hinge;
use super::rigid::Vector;

/// A node of the graph; none for the ground.
pub(super) type Node = Option<usize>;

/// A connection of two nodes, which can carry one of them.
#[derive(Debug, Clone)]
pub(super) struct Edge {
    pub(super) ends: [Node; 2],
    pub(super) kind: EdgeKind,
    /// The edge with the smallest weight carries a node. The weight of an element is its
    /// flexibility; rigid edges have a smaller weight than any element.
    pub(super) weight: f64,
}

#[derive(Debug, Clone)]
pub(super) enum EdgeKind {
    /// Rigid connection.
    Rigid,
    /// Hinge: the second node moves with the first except for some rotations.
    Hinge(Box<Hinge>),
    /// Free motions of the second node relative to the ground: one for each `true`.
    Free([bool; 6]),
    /// An element of a member.
    Element {
        member: usize,
        /// Its ends, as fractions of the member.
        from: f64,
        to: f64,
    },
}

/// Nodes with their positions, and edges.
#[derive(Debug, Clone, Default)]
pub(super) struct Graph {
    pub(super) positions_m: Vec<Vector>,
    /// The joint at each node or next to it.
    pub(super) joints: Vec<usize>,
    pub(super) edges: Vec<Edge>,
}

/// An edge that carries a node, and whether it runs from its second end to the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Branch {
    pub(super) edge: usize,
    pub(super) reversed: bool,
}

impl Graph {
    pub(super) fn add_node(&mut self, position_m: Vector, joint: usize) -> usize {
        self.positions_m.push(position_m);
        self.joints.push(joint);
        self.positions_m.len() - 1
    }

    pub(super) fn connect(&mut self, ends: [Node; 2], kind: EdgeKind, weight: f64) {
        self.edges.push(Edge { ends, kind, weight });
    }

    /// The edges that carry all nodes, those nearer to the ground first: minimum spanning trees
    /// from the ground (Prim 1957). A node that no edge reaches is carried by new free motions,
    /// which
    /// `free` gives; of such nodes the one named first begins.
    pub(super) fn trees(
        &mut self,
        first: Option<usize>,
        free: impl Fn(usize) -> [bool; 6],
    ) -> Vec<Branch> {
        let mut edges_of = vec![Vec::new(); self.positions_m.len()];
        for (index, edge) in self.edges.iter().enumerate() {
            edge.ends
                .iter()
                .flatten()
                .for_each(|node| edges_of[*node].push(index));
        }
        let mut branches = Vec::with_capacity(self.positions_m.len());
        let mut carried = vec![false; self.positions_m.len()];
        let mut queue = BinaryHeap::new();
        for (index, edge) in self.edges.iter().enumerate() {
            if edge.ends.contains(&None) {
                queue.push(Reverse((Weight(edge.weight), index)));
            }
        }
        let candidates: Vec<usize> = first.into_iter().chain(0..self.positions_m.len()).collect();
        let mut candidates = candidates.into_iter();
        loop {
            let Some(Reverse((_, index))) = queue.pop() else {
                let Some(root) = candidates.by_ref().find(|node| !carried[*node]) else {
                    return branches;
                };
                self.connect([None, Some(root)], EdgeKind::Free(free(root)), 0.0);
                queue.push(Reverse((Weight(0.0), self.edges.len() - 1)));
                continue;
            };
            let ends = self.edges[index].ends;
            let is_carried = |node: Node| node.is_none_or(|node| carried[node]);
            let (child, reversed) = match ends {
                [from, Some(child)] if is_carried(from) && !carried[child] => (child, false),
                [Some(child), to] if is_carried(to) && !carried[child] => (child, true),
                _ => continue,
            };
            carried[child] = true;
            branches.push(Branch {
                edge: index,
                reversed,
            });
            for next in &edges_of[child] {
                queue.push(Reverse((Weight(self.edges[*next].weight), *next)));
            }
        }
    }
}

/// A weight, ordered.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Weight(f64);

impl Eq for Weight {}

impl PartialOrd for Weight {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Weight {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}
