//! The factorization of a matrix A of a frame, node by node, with its inertia count.
//!
//! The bubbles of each element are eliminated first, by themselves. Then each node that nothing
//! hangs on is eliminated: its motion X q + T y is replaced by that of the node that it hangs on
//! and by the coordinates y of its link, and y is eliminated. All are steps of L D Lᵀ, so the
//! negative pivots are the negative eigenvalues (Sylvester).

use super::equations::{Chord, Equations, KINDS, Link, add_force, add_matrices, motion_of};
use super::order::{Block, Order, Step};
use super::rigid::{Motion, NONE, add_transposed, moved, product, transposed, transposed_product};
use crate::beam::{eliminate, first_block};
use crate::space::{SpatialMatrix, add_scaled};

/// Factors of a matrix, and working memory; reused from factorization to factorization.
#[derive(Debug, Clone, Default)]
pub(super) struct Factors {
    /// The matrix of each link after its bubbles were eliminated.
    links: Vec<Vec<f64>>,
    /// The same of each chord.
    chords: Vec<Vec<f64>>,
    /// The front of each step after its coordinates were eliminated: the rows of the coordinates.
    fronts: Vec<Vec<f64>>,
    diagonal: Vec<SpatialMatrix>,
    blocks: Vec<SpatialMatrix>,
    forces: Vec<Motion>,
    motions: Vec<Motion>,
    at: Vec<f64>,
}

/// A = Σ factor·matrix + `own` times the stiffness of the coordinates.
pub(super) type Combination<'a> = (&'a [f64; KINDS], f64);

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

    /// Eliminates all nodes but the last one; returns the matrix that it feels, and the number of
    /// negative eigenvalues of A with this node held.
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
            links,
            chords,
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
        for (link, matrix) in self.links.iter().zip(links) {
            negative += condense_link(link, (a, own), matrix);
        }
        chords.resize(self.chords.len(), Vec::new());
        for ((chord, matrix), block) in self.chords.iter().zip(chords).zip(&order.chords) {
            negative += condense_chord(chord, (a, own), matrix);
            add_chord(chord, matrix, *block, diagonal, blocks);
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

    /// Finds all unknowns but those of the last node from its motion, in place of a reduced right
    /// side.
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
            links,
            chords,
            fronts,
            forces,
            at,
            ..
        } = factors;
        forces.clear();
        forces.resize(self.nodes.len(), [0.0; 6]);
        for (link, matrix) in self.links.iter().zip(&*links) {
            let (rows, lead) = (link.rows(), 6 + link.tip.len());
            at.clear();
            at.resize(6, 0.0);
            at.extend_from_slice(&x[link.first..][..link.coordinates]);
            forward(matrix, rows, lead, at);
            x[link.first..][..link.coordinates].copy_from_slice(&at[6..]);
            add_force(forces, link.parent, &at[..6]);
        }
        for (chord, matrix) in self.chords.iter().zip(&*chords) {
            at.clear();
            at.resize(12, 0.0);
            at.extend_from_slice(&x[chord.first..][..chord.bubbles]);
            forward(matrix, chord.rows(), 12, at);
            x[chord.first..][..chord.bubbles].copy_from_slice(&at[12..]);
            add_force(forces, chord.ends[0], &at[..6]);
            add_force(forces, chord.ends[1], &at[6..12]);
        }
        for (step, front) in steps.iter().zip(&*fronts) {
            forward_node(&self.links[step.link], step, front, forces, at, x);
        }
    }

    fn substitute(&self, steps: &[Step], factors: &mut Factors, x: &mut [f64]) {
        let Factors {
            links,
            chords,
            fronts,
            motions,
            at,
            ..
        } = factors;
        for (step, front) in steps.iter().zip(&*fronts).rev() {
            backward_node(&self.links[step.link], step, front, motions, at, x);
        }
        for (link, matrix) in self.links.iter().zip(&*links) {
            at.clear();
            at.extend(motion_of(motions, link.parent));
            at.extend_from_slice(&x[link.first..][..link.coordinates]);
            backward(matrix, link.rows(), 6 + link.tip.len(), at);
            x[link.first..][..link.coordinates].copy_from_slice(&at[6..]);
        }
        for (chord, matrix) in self.chords.iter().zip(&*chords) {
            at.clear();
            at.extend(motion_of(motions, chord.ends[0]));
            at.extend(motion_of(motions, chord.ends[1]));
            at.extend_from_slice(&x[chord.first..][..chord.bubbles]);
            backward(matrix, chord.rows(), 12, at);
            x[chord.first..][..chord.bubbles].copy_from_slice(&at[12..]);
        }
    }
}

fn condense_link(link: &Link, (a, own): Combination<'_>, matrix: &mut Vec<f64>) -> usize {
    let rows = link.rows();
    matrix.clear();
    matrix.resize(rows * rows, 0.0);
    add_matrices(a, &link.matrices, matrix);
    (6..rows).for_each(|i| matrix[i * rows + i] += own * link.own);
    eliminate(matrix, rows, 6 + link.tip.len())
}

fn condense_chord(chord: &Chord, (a, own): Combination<'_>, matrix: &mut Vec<f64>) -> usize {
    let rows = chord.rows();
    matrix.clear();
    matrix.resize(rows * rows, 0.0);
    add_matrices(a, &chord.matrices, matrix);
    (12..rows).for_each(|i| matrix[i * rows + i] += own);
    eliminate(matrix, rows, 12)
}

/// Adds what is left of a chord to the nodes at its ends.
fn add_chord(
    chord: &Chord,
    matrix: &[f64],
    block: Option<Block>,
    diagonal: &mut [SpatialMatrix],
    blocks: &mut [SpatialMatrix],
) {
    let rows = chord.rows();
    if let Some(near) = chord.ends[0] {
        add_scaled(&mut diagonal[near], 1.0, &first_block(matrix, rows));
    }
    if let Some(far) = chord.ends[1] {
        let of_far = |i: usize, j: usize| matrix[(6 + i.max(j)) * rows + 6 + i.min(j)];
        let own = std::array::from_fn(|i| std::array::from_fn(|j| of_far(i, j)));
        add_scaled(&mut diagonal[far], 1.0, &own);
    }
    if let Some(block) = block {
        // Rows are the near end, columns the far one.
        let across = std::array::from_fn(|i| std::array::from_fn(|j| matrix[(6 + j) * rows + i]));
        add_block(blocks, block, &across);
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

/// The block of two neighbours of a step, the greater place first.
fn pair(step: &Step, greater: usize, less: usize) -> Block {
    step.pairs[greater * (greater - 1) / 2 + less]
}

/// Replaces the motion of a node by that of the node that it hangs on and its link's coordinates,
/// and eliminates these. Leaves their rows in `front`.
fn eliminate_node(link: &Link, step: &Step, factors: &mut Factors, front: &mut Vec<f64>) -> usize {
    let (n, moving) = (6 * step.neighbours.len(), link.tip.len());
    let size = n + moving;
    front.clear();
    front.resize(size * size, 0.0);
    let Factors {
        links,
        diagonal,
        blocks,
        ..
    } = factors;
    let (own, rows) = (&links[step.link], link.rows());
    let at_node = diagonal[step.node];
    for (t, column) in link.tip.iter().enumerate() {
        let row = &mut front[(n + t) * size..(n + t + 1) * size];
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
    let negative = eliminate(front, size, n);
    for (k, node) in step.neighbours.iter().enumerate() {
        let entry = |i: usize, j: usize| front[(6 * k + i.max(j)) * size + 6 * k + i.min(j)];
        let block = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        add_scaled(&mut diagonal[*node], 1.0, &block);
        for l in 0..k {
            let entry = |i: usize, j: usize| front[(6 * k + i) * size + 6 * l + j];
            let block = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
            add_block(blocks, pair(step, k, l), &block);
        }
    }
    front.drain(..n * size);
    negative
}

/// Adds what a node that hangs on its parent by X feels to the parent.
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
    let own = first_block::<6, f64>(own, link.rows());
    add_scaled(&mut diagonal[node], 1.0, &own);
}

/// Forward substitution of the rows from `first` on, the last one first; these are not divided yet.
fn forward(matrix: &[f64], rows: usize, first: usize, x: &mut [f64]) {
    for last in (first..rows).rev() {
        let row = &matrix[last * rows..last * rows + last + 1];
        let factor = x[last] / row[last];
        for (x, entry) in x[..last].iter_mut().zip(row) {
            *x -= entry * factor;
        }
    }
}

/// Backward substitution of the rows from `first` on.
fn backward(matrix: &[f64], rows: usize, first: usize, x: &mut [f64]) {
    for last in first..rows {
        let row = &matrix[last * rows..last * rows + last + 1];
        let sum: f64 = row[..last].iter().zip(&*x).map(|(a, x)| a * x).sum();
        x[last] = (x[last] - sum) / row[last];
    }
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
