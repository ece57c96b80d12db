//! The order of elimination of the nodes: a node is eliminated after its children in the tree, and
//! of several possible nodes the one with the fewest neighbours is next (minimum degree; Tinney &
//! Walker 1967).

use std::collections::{BTreeSet, HashMap};

use super::equations::Equations;

/// A node to be eliminated.
#[derive(Debug, Clone)]
pub(super) struct Step {
    /// Index of its link.
    pub(super) link: usize,
    pub(super) node: usize,
    /// The nodes that are coupled with it and are eliminated later.
    pub(super) neighbours: Vec<usize>,
    /// The blocks of the matrix that couple it with each of them.
    pub(super) own_blocks: Vec<Block>,
    /// Index of the parent among the neighbours.
    pub(super) parent: Option<usize>,
    /// The blocks between two neighbours, row by row of the lower triangle without the diagonal.
    pub(super) pairs: Vec<Block>,
}

/// A block of a symmetric matrix, and whether it is stored transposed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block {
    pub(super) at: usize,
    pub(super) transposed: bool,
}

/// The order of elimination and the places of the blocks that become nonzero.
#[derive(Debug, Clone, Default)]
pub(super) struct Order {
    pub(super) steps: Vec<Step>,
    /// For each chord between two nodes, the block that couples them.
    pub(super) chords: Vec<Option<Block>>,
    /// Number of blocks beside the diagonal.
    pub(super) blocks: usize,
    /// Number of blocks of the parts of links and chords.
    pub(super) blocks_of_parts: usize,
}

impl Order {
    pub(super) fn new(equations: &Equations) -> Self {
        Self::ending_with(equations, None)
    }

    /// As above, with a node that is carried by the ground as the last one.
    pub(super) fn ending_with(equations: &Equations, last: Option<usize>) -> Self {
        let count = equations.nodes.len();
        let mut neighbours = vec![BTreeSet::new(); count];
        let mut children = vec![0_usize; count];
        let mut link_of = vec![usize::MAX; count];
        let mut couple = |a: usize, b: usize| {
            neighbours[a].insert(b);
            neighbours[b].insert(a);
        };
        for (place, link) in equations.links.iter().enumerate() {
            link_of[link.child] = place;
            if let Some(parent) = link.parent {
                couple(parent, link.child);
                children[parent] += 1;
            }
        }
        for chord in &equations.chords {
            if let [Some(a), Some(b)] = chord.ends {
                couple(a, b);
            }
        }
        let mut order = Self::default();
        let mut places = HashMap::new();
        let mut left: BTreeSet<usize> = (0..count).collect();
        while let Some(node) = next(&left, &children, &neighbours, last) {
            left.remove(&node);
            let own: Vec<usize> = neighbours[node].iter().copied().collect();
            for (k, a) in own.iter().enumerate() {
                neighbours[*a].remove(&node);
                for b in &own[..k] {
                    neighbours[*a].insert(*b);
                    neighbours[*b].insert(*a);
                }
            }
            let link = link_of[node];
            let parent = equations.links[link].parent;
            if let Some(parent) = parent {
                children[parent] -= 1;
            }
            let mut block = |row, column| order.block(&mut places, row, column);
            let own_blocks = own.iter().map(|other| block(node, *other)).collect();
            let below = |k: usize| own[..k].iter().map(move |b| (k, *b));
            let pairs = (0..own.len()).flat_map(below);
            let pairs = pairs.map(|(k, b)| block(own[k], b)).collect();
            order.steps.push(Step {
                link,
                node,
                own_blocks,
                parent: parent.and_then(|parent| own.iter().position(|other| *other == parent)),
                pairs,
                neighbours: own,
            });
        }
        let links = equations.links.iter().map(|link| &link.parts);
        let parts = links.chain(equations.chords.iter().map(|chord| &chord.parts));
        order.blocks_of_parts = parts.map(|parts| parts.blocks.len()).sum();
        let chord = |ends: [Option<usize>; 2]| match ends {
            [Some(a), Some(b)] => Some(order.block(&mut places, a, b)),
            _ => None,
        };
        order.chords = equations.chords.iter().map(|c| c.ends).map(chord).collect();
        order
    }

    /// The block of two nodes, a new one if there is none yet.
    fn block(
        &mut self,
        places: &mut HashMap<(usize, usize), usize>,
        row: usize,
        column: usize,
    ) -> Block {
        let key = (row.min(column), row.max(column));
        let at = *places.entry(key).or_insert_with(|| {
            self.blocks += 1;
            self.blocks - 1
        });
        Block {
            at,
            transposed: row > column,
        }
    }
}

/// The node with the fewest neighbours among the nodes whose children are all eliminated.
fn next(
    left: &BTreeSet<usize>,
    children: &[usize],
    neighbours: &[BTreeSet<usize>],
    last: Option<usize>,
) -> Option<usize> {
    let free = left.iter().filter(|node| children[**node] == 0);
    free.min_by_key(|node| (Some(**node) == last, neighbours[**node].len(), **node))
        .copied()
}
