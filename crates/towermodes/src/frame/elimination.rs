//! The factorization of a matrix A of a frame, node by node, with its eigenvalue count.
//!
//! The bubbles of each element are eliminated first, by themselves. Then each node that nothing
//! hangs on is eliminated: its motion X q + T y is replaced by that of the node that it hangs on
//! and by the coordinates y of its link, and y is eliminated. All are steps of L D Lᵀ, so the
//! negative pivots are the negative eigenvalues (Sylvester).

use super::equations::{Equations, Link, add_force, motion_of};
use super::kinds::Combination;
use super::order::{Block, Order, Step};
use super::parts::{MOST_ENDS, Side};
use super::rigid::{Motion, NONE, add_transposed, moved, product, transposed, transposed_product};
use crate::beam::{eliminate_rows, first_block};
use crate::space::{SpatialMatrix, add_scaled};

/// Factors of a matrix, and working memory; reused from factorization to factorization.
#[derive(Debug, Clone, Default)]
pub(super) struct Factors {
    /// The matrix of each part of a link or chord after the elimination of its bubbles.
    blocks_of_parts: Vec<Vec<f64>>,
    /// The matrix of each link for its ends, without bubbles.
    links: Vec<Vec<f64>>,
    /// The matrix of a chord without bubbles.
    chord: Vec<f64>,
    /// The front of each step after its coordinates were eliminated: the rows of the coordinates.
    fronts: Vec<Vec<f64>>,
    diagonal: Vec<SpatialMatrix>,
    blocks: Vec<SpatialMatrix>,
    forces: Vec<Motion>,
    motions: Vec<Motion>,
    at: Vec<f64>,
}

impl Equations {
    /// Factors A and returns the number of its negative eigenvalues.
    pub(super) fn factorize(
        &self,
        order: &Order,
        a: Combination<'_>,
        factors: &mut Factors,
    ) -> usize {
        self.factorize_steps(order, &order.steps, a, factors)
    }

    /// Eliminates all nodes except the last one; returns the matrix condensed to this node, and the
    /// number of negative eigenvalues of A with this node fixed.
    pub(super) fn factorize_to_last(
        &self,
        order: &Order,
        a: Combination<'_>,
        factors: &mut Factors,
    ) -> (SpatialMatrix, usize) {
        let Some((last, steps)) = order.steps.split_last() else {
            return (NONE, 0);
        };
        let negative = self.factorize_steps(order, steps, a, factors);
        (factors.diagonal[last.node], negative)
    }

    fn factorize_steps(
        &self,
        order: &Order,
        steps: &[Step],
        a: Combination<'_>,
        factors: &mut Factors,
    ) -> usize {
        let mut negative = self.begin(order, a, factors);
        factors.fronts.resize(order.steps.len(), Vec::new());
        for (place, step) in steps.iter().enumerate() {
            let mut front = std::mem::take(&mut factors.fronts[place]);
            negative += eliminate_node(&self.links[step.link], step, factors, &mut front);
            factors.fronts[place] = front;
        }
        negative
    }

    /// Adds what is attached to the nodes and eliminates all bubbles.
    fn begin(&self, order: &Order, (a, own): Combination<'_>, factors: &mut Factors) -> usize {
        let Factors {
            blocks_of_parts,
            links,
            chord: rest,
            diagonal,
            blocks,
            ..
        } = factors;
        blocks.clear();
        blocks.resize(order.blocks, NONE);
        diagonal.clear();
        diagonal.extend(self.nodes.iter().map(|matrices| {
            let mut sum = NONE;
            let all = a.iter().zip(matrices);
            all.for_each(|(factor, matrix)| add_scaled(&mut sum, *factor, matrix));
            sum
        }));
        let mut negative = 0;
        links.resize(self.links.len(), Vec::new());
        blocks_of_parts.resize(order.blocks_of_parts, Vec::new());
        let mut factors = blocks_of_parts.iter_mut();
        for (link, rest) in self.links.iter().zip(links) {
            negative += link.parts.condense((a, own * link.own), &mut factors, rest);
        }
        for (chord, block) in self.chords.iter().zip(&order.chords) {
            negative += chord.parts.condense((a, own), &mut factors, rest);
            add_chord(chord.ends, rest, *block, diagonal, blocks);
        }
        negative
    }

    /// x ← A⁻¹ x with the matrix factored last.
    pub(super) fn solve(&self, order: &Order, factors: &mut Factors, x: &mut [f64]) {
        self.reduce(&order.steps, factors, x);
        factors.motions.clear();
        factors.motions.resize(self.nodes.len(), [0.0; 6]);
        self.substitute(&order.steps, factors, x);
    }

    /// Eliminates a right side up to the last node; returns the force on it.
    pub(super) fn reduce_to_last(
        &self,
        order: &Order,
        factors: &mut Factors,
        x: &mut [f64],
    ) -> Motion {
        let Some((last, steps)) = order.steps.split_last() else {
            return [0.0; 6];
        };
        self.reduce(steps, factors, x);
        factors.forces[last.node]
    }

    /// Computes all unknowns except those of the last node from its motion; they replace the
    /// reduced right side.
    pub(super) fn substitute_from_last(
        &self,
        order: &Order,
        factors: &mut Factors,
        motion: Motion,
        x: &mut [f64],
    ) {
        let Some((last, steps)) = order.steps.split_last() else {
            return;
        };
        factors.motions.clear();
        factors.motions.resize(self.nodes.len(), [0.0; 6]);
        factors.motions[last.node] = motion;
        self.substitute(steps, factors, x);
    }

    fn reduce(&self, steps: &[Step], factors: &mut Factors, x: &mut [f64]) {
        let Factors {
            blocks_of_parts,
            fronts,
            forces,
            at,
            ..
        } = factors;
        forces.clear();
        forces.resize(self.nodes.len(), [0.0; 6]);
        let mut factors = blocks_of_parts.iter();
        for link in &self.links {
            let moving = link.tip.len();
            let mut ends = [0.0; MOST_ENDS];
            let (own, bubbles) = x[link.first..][..link.coordinates].split_at_mut(moving);
            ends[6..6 + moving].copy_from_slice(own);
            link.parts.forward(&mut factors, &mut ends, bubbles, at);
            own.copy_from_slice(&ends[6..6 + moving]);
            add_force(forces, link.parent, &link.parts.out_of_axes(&ends[..6]));
        }
        for chord in &self.chords {
            let mut ends = [0.0; MOST_ENDS];
            let bubbles = &mut x[chord.first..][..chord.parts.bubbles()];
            chord.parts.forward(&mut factors, &mut ends, bubbles, at);
            add_force(forces, chord.ends[0], &chord.parts.out_of_axes(&ends[..6]));
            add_force(forces, chord.ends[1], &chord.parts.out_of_axes(&ends[6..]));
        }
        for (step, front) in steps.iter().zip(&*fronts) {
            forward_node(&self.links[step.link], step, front, forces, at, x);
        }
    }

    fn substitute(&self, steps: &[Step], factors: &mut Factors, x: &mut [f64]) {
        let Factors {
            blocks_of_parts,
            fronts,
            motions,
            at,
            ..
        } = factors;
        for (step, front) in steps.iter().zip(&*fronts).rev() {
            backward_node(&self.links[step.link], step, front, motions, at, x);
        }
        let mut factors = blocks_of_parts.iter();
        for link in &self.links {
            let Side { ends, .. } = link.side(x, &motion_of(motions, link.parent));
            let bubbles = &mut x[link.first + link.tip.len()..];
            link.parts.backward(&mut factors, &ends, bubbles, at);
        }
        for chord in &self.chords {
            let Side { ends, .. } = chord.side(x, chord.ends.map(|end| motion_of(motions, end)));
            let bubbles = &mut x[chord.first..][..chord.parts.bubbles()];
            chord.parts.backward(&mut factors, &ends, bubbles, at);
        }
    }
}

/// Adds the condensed matrix of a chord to the nodes at its ends.
fn add_chord(
    ends: [Option<usize>; 2],
    rest: &[f64],
    block: Option<Block>,
    diagonal: &mut [SpatialMatrix],
    blocks: &mut [SpatialMatrix],
) {
    let part = |row: usize, column: usize| -> SpatialMatrix {
        let entry = |i: usize, j: usize| rest[(row + i) * MOST_ENDS + column + j];
        std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
    };
    if let Some(near) = ends[0] {
        add_scaled(&mut diagonal[near], 1.0, &part(0, 0));
    }
    if let Some(far) = ends[1] {
        add_scaled(&mut diagonal[far], 1.0, &part(6, 6));
    }
    if let Some(block) = block {
        // Rows are the near end, columns the far one.
        add_block(blocks, block, &part(0, 6));
    }
}

fn add_block(blocks: &mut [SpatialMatrix], block: Block, matrix: &SpatialMatrix) {
    match block.transposed {
        false => add_scaled(&mut blocks[block.at], 1.0, matrix),
        true => add_scaled(&mut blocks[block.at], 1.0, &transposed(matrix)),
    }
}

fn block_of(blocks: &[SpatialMatrix], block: Block) -> SpatialMatrix {
    match block.transposed {
        false => blocks[block.at],
        true => transposed(&blocks[block.at]),
    }
}

/// The block of two neighbours of a step, the larger index first.
fn pair(step: &Step, greater: usize, less: usize) -> Block {
    step.pairs[greater * (greater - 1) / 2 + less]
}

/// Replaces the motion of a node by that of the node that it hangs on and its link's coordinates,
/// and eliminates these. Leaves their rows in `front`.
fn eliminate_node(link: &Link, step: &Step, factors: &mut Factors, front: &mut Vec<f64>) -> usize {
    let (n, moving) = (6 * step.neighbours.len(), link.tip.len());
    let size = n + moving;
    front.clear();
    front.resize(moving * size, 0.0);
    let Factors {
        links,
        diagonal,
        blocks,
        ..
    } = factors;
    let (own, rows) = (&links[step.link], link.parts.ends);
    let at_node = diagonal[step.node];
    for (t, column) in link.tip.iter().enumerate() {
        let row = &mut front[t * size..(t + 1) * size];
        for (k, block) in step.own_blocks.iter().enumerate() {
            let mut coupled = [0.0; 6];
            add_transposed(&mut coupled, &block_of(blocks, *block), column);
            row[6 * k..6 * k + 6].copy_from_slice(&coupled);
        }
        let force = moved(&at_node, column);
        if let Some(parent) = step.parent {
            let at_parent = &mut row[6 * parent..6 * parent + 6];
            let mut carried = [0.0; 6];
            add_transposed(&mut carried, &link.transfer, &force);
            for (j, sum) in at_parent.iter_mut().enumerate() {
                *sum += carried[j] + own[(6 + t) * rows + j];
            }
        }
        for (s, other) in link.tip[..=t].iter().enumerate() {
            let product: f64 = other.iter().zip(force).map(|(a, b)| a * b).sum();
            row[n + s] = product + own[(6 + t) * rows + 6 + s];
        }
    }
    if let Some(parent) = step.parent {
        carry_to_parent(link, step, parent, own, diagonal, blocks);
    }
    let negative = eliminate_rows(front, size, n);
    // The contribution of the rows to two neighbours: −Σ r rᵀ/pivot.
    let left = |k: usize, l: usize| {
        let mut block = NONE;
        for (t, row) in front.chunks_exact(size).enumerate() {
            let (row, of_link) = row.split_at(n);
            let (row, _) = row.as_chunks::<6>();
            let (of_k, of_l) = (row[k], row[l]);
            for (sums, entry) in block.iter_mut().zip(of_k) {
                let factor = entry / of_link[t];
                for (sum, entry) in sums.iter_mut().zip(of_l) {
                    *sum -= factor * entry;
                }
            }
        }
        block
    };
    for (k, node) in step.neighbours.iter().enumerate() {
        add_scaled(&mut diagonal[*node], 1.0, &left(k, k));
        for l in 0..k {
            add_block(blocks, pair(step, k, l), &left(k, l));
        }
    }
    negative
}

/// Adds the matrix of a node to its parent, to which the node is connected by X.
fn carry_to_parent(
    link: &Link,
    step: &Step,
    parent: usize,
    own: &[f64],
    diagonal: &mut [SpatialMatrix],
    blocks: &mut [SpatialMatrix],
) {
    let (node, x) = (step.neighbours[parent], &link.transfer);
    let at_node = diagonal[step.node];
    // Xᵀ A_jk for every neighbour, and for the parent twice.
    for (k, block) in step.own_blocks.iter().enumerate() {
        let carried = transposed_product(x, &block_of(blocks, *block));
        match k.cmp(&parent) {
            std::cmp::Ordering::Equal => {
                add_scaled(&mut diagonal[node], 1.0, &carried);
                add_scaled(&mut diagonal[node], 1.0, &transposed(&carried));
            }
            std::cmp::Ordering::Less => add_block(blocks, pair(step, parent, k), &carried),
            std::cmp::Ordering::Greater => {
                add_block(blocks, pair(step, k, parent), &transposed(&carried));
            }
        }
    }
    let carried = transposed_product(x, &product(&at_node, x));
    add_scaled(&mut diagonal[node], 1.0, &carried);
    let own = first_block::<6, f64>(own, link.parts.ends);
    add_scaled(&mut diagonal[node], 1.0, &own);
}

fn forward_node(
    link: &Link,
    step: &Step,
    front: &[f64],
    forces: &mut [Motion],
    at: &mut Vec<f64>,
    x: &mut [f64],
) {
    let (n, moving) = (6 * step.neighbours.len(), link.tip.len());
    let size = n + moving;
    let force = forces[step.node];
    if let Some(parent) = link.parent {
        add_transposed(&mut forces[parent], &link.transfer, &force);
    }
    at.clear();
    at.resize(n, 0.0);
    for (column, x) in link.tip.iter().zip(&mut x[link.first..]) {
        *x += column.iter().zip(force).map(|(t, f)| t * f).sum::<f64>();
        at.push(*x);
    }
    for t in (0..moving).rev() {
        let row = &front[t * size..t * size + n + t + 1];
        let factor = at[n + t] / row[n + t];
        for (x, entry) in at[..n + t].iter_mut().zip(row) {
            *x -= entry * factor;
        }
    }
    x[link.first..][..moving].copy_from_slice(&at[n..]);
    for (k, node) in step.neighbours.iter().enumerate() {
        add_force(forces, Some(*node), &at[6 * k..6 * k + 6]);
    }
}

fn backward_node(
    link: &Link,
    step: &Step,
    front: &[f64],
    motions: &mut [Motion],
    at: &mut Vec<f64>,
    x: &mut [f64],
) {
    let (n, moving) = (6 * step.neighbours.len(), link.tip.len());
    let size = n + moving;
    at.clear();
    for node in &step.neighbours {
        at.extend(motions[*node]);
    }
    at.extend_from_slice(&x[link.first..][..moving]);
    for t in 0..moving {
        let row = &front[t * size..t * size + n + t + 1];
        let sum: f64 = row[..n + t].iter().zip(&*at).map(|(a, x)| a * x).sum();
        at[n + t] = (at[n + t] - sum) / row[n + t];
    }
    let mut motion = match link.parent {
        Some(parent) => moved(&link.transfer, &motions[parent]),
        None => [0.0; 6],
    };
    for ((column, y), x) in link.tip.iter().zip(&at[n..]).zip(&mut x[link.first..]) {
        for (sum, entry) in motion.iter_mut().zip(column) {
            *sum += entry * y;
        }
        *x = *y;
    }
    motions[step.node] = motion;
}
