//! The matrices of a link or a chord: blocks that nothing couples, in the axes of their member.
//!
//! A block acts on some of the entries of its ends (the motion of the near end, then that of the
//! far end of a chord, or the coordinates of a link that move its child) and on its own bubbles,
//! which are eliminated by themselves. Where both bending planes are equal one block is in both.

use super::element::{Element, Part};
use super::kinds::{Combination, ELASTIC, KINDS, add_matrices};
use super::rigid::{Motion, Vector, into_axes, out_of_axes};
use crate::beam::eliminate;
use crate::space::SpatialMatrix;
use crate::tower::Component;

/// Largest number of entries of the ends.
pub(super) const MOST_ENDS: usize = 12;
/// The entries of the ends of a link or a chord.
pub(super) type Ends = [f64; MOST_ENDS];

/// The ends and the bubbles of a link or a chord in a motion.
pub(super) struct Side<'a> {
    pub(super) ends: Ends,
    pub(super) bubbles: &'a [f64],
}

/// The blocks of a link or a chord.
#[derive(Debug, Clone, Default)]
pub(super) struct Parts {
    /// The axes of the member as rows; none for global axes.
    pub(super) axes: Option<[Vector; 3]>,
    /// Number of entries of the ends that are motions: 6 for a link, 12 for a chord. The other
    /// entries are coordinates.
    pub(super) motions: usize,
    /// Number of entries of the ends.
    pub(super) ends: usize,
    pub(super) blocks: Vec<Block>,
}

/// A block.
#[derive(Debug, Clone)]
pub(super) struct Block {
    pub(super) planes: Vec<Plane>,
    pub(super) bubbles: usize,
    /// Matrices for its entries of the ends and its bubbles, row by row; empty where there is none.
    pub(super) matrices: [Vec<f64>; KINDS],
}

/// The position of a block in one plane: both bending planes can have the same block.
#[derive(Debug, Clone)]
pub(super) struct Plane {
    /// Indices of its entries of the ends, each with its sign.
    pub(super) ends: Vec<Component>,
    /// Index of its first bubble among the bubbles of the link or the chord.
    pub(super) first: usize,
}

impl Block {
    pub(super) fn rows(&self) -> usize {
        self.leading() + self.bubbles
    }

    /// Number of its entries of the ends.
    fn leading(&self) -> usize {
        self.planes[0].ends.len()
    }

    /// Its entries of the ends and its bubbles in a plane, together.
    fn gather(&self, plane: &Plane, ends: &Ends, bubbles: &[f64], at: &mut Vec<f64>) {
        at.clear();
        at.extend(plane.ends.iter().map(|(end, sign)| sign * ends[*end]));
        at.extend_from_slice(&bubbles[plane.first..][..self.bubbles]);
    }
}

impl Parts {
    /// The parts of a link with coordinates but without matrices.
    pub(super) fn none(coordinates: usize) -> Self {
        Self {
            axes: None,
            motions: 6,
            ends: 6 + coordinates,
            blocks: Vec::new(),
        }
    }

    /// The parts of an element that carries its far end.
    pub(super) fn of_link(element: &Element, axes: Option<[Vector; 3]>) -> Self {
        let (mut moving, mut bubbles, mut blocks) = (0, 0, Vec::new());
        for part in &element.parts {
            let of_part = part.coordinates - part.moving();
            let mut plane = |components: &&'static [Component]| {
                let mut ends = components.to_vec();
                ends.extend((0..part.moving()).map(|k| (6 + moving + k, 1.0)));
                let first = bubbles;
                moving += part.moving();
                bubbles += of_part;
                Plane { ends, first }
            };
            let [inertia, ground, geometric] = part.matrices.clone();
            blocks.push(Block {
                planes: part.planes.iter().map(&mut plane).collect(),
                bubbles: of_part,
                matrices: [inertia, ground, geometric, Vec::new()],
            });
        }
        Self {
            axes,
            blocks,
            ..Self::none(moving)
        }
    }

    /// The parts of an element between two nodes that are carried by other links.
    pub(super) fn of_chord(element: &Element, axes: [Vector; 3]) -> Self {
        let (mut first, mut blocks) = (0, Vec::new());
        for part in &element.parts {
            let block = chord_block(part, element, first);
            first += block.bubbles * block.planes.len();
            blocks.push(block);
        }
        Self {
            axes: Some(axes),
            motions: MOST_ENDS,
            ends: MOST_ENDS,
            blocks,
        }
    }

    /// The parts of a matrix for the motions of two nodes: its blocks near-near, near-far, far-far.
    pub(super) fn of_nodal(kind: usize, [near, across, far]: &[SpatialMatrix; 3]) -> Self {
        let mut matrices = [const { Vec::new() }; KINDS];
        let entry = |i: usize, j: usize| match (i < 6, j < 6) {
            (true, true) => near[i][j],
            (true, false) => across[i][j - 6],
            (false, true) => across[j][i - 6],
            (false, false) => far[i - 6][j - 6],
        };
        let all = (0..MOST_ENDS).flat_map(|i| (0..MOST_ENDS).map(move |j| entry(i, j)));
        matrices[kind] = all.collect();
        Self {
            axes: None,
            motions: MOST_ENDS,
            ends: MOST_ENDS,
            blocks: vec![Block {
                planes: vec![Plane {
                    ends: (0..MOST_ENDS).map(|end| (end, 1.0)).collect(),
                    first: 0,
                }],
                bubbles: 0,
                matrices,
            }],
        }
    }

    pub(super) fn bubbles(&self) -> usize {
        let blocks = self.blocks.iter();
        blocks.map(|block| block.bubbles * block.planes.len()).sum()
    }

    /// Factors the bubbles of each block of A, whose coordinates have `own` as stiffness of their
    /// own, and writes the condensed matrix of the ends, in global axes, to `rest`: all rows of
    /// both triangles. Returns the number of negative pivots.
    pub(super) fn condense<'f>(
        &self,
        (a, own): Combination<'_>,
        factors: &mut impl Iterator<Item = &'f mut Vec<f64>>,
        rest: &mut Vec<f64>,
    ) -> usize {
        rest.clear();
        rest.resize(self.ends * self.ends, 0.0);
        let mut negative = 0;
        for (block, matrix) in self.blocks.iter().zip(factors) {
            let (rows, leading) = (block.rows(), block.leading());
            matrix.clear();
            matrix.resize(rows * rows, 0.0);
            add_matrices(a, &block.matrices, matrix);
            let [plane, ..] = &block.planes[..] else {
                continue;
            };
            let is_coordinate =
                |k: usize| plane.ends.get(k).is_none_or(|(e, _)| *e >= self.motions);
            (0..rows)
                .filter(|k| is_coordinate(*k))
                .for_each(|k| matrix[k * rows + k] += own);
            negative += block.planes.len() * eliminate(matrix, rows, leading);
            for plane in &block.planes {
                for (i, (row, of_row)) in plane.ends.iter().enumerate() {
                    for (j, (column, sign)) in plane.ends[..=i].iter().enumerate() {
                        let entry = of_row * sign * matrix[i * rows + j];
                        rest[row * self.ends + column] = entry;
                        rest[column * self.ends + row] = entry;
                    }
                }
            }
        }
        self.turn(rest);
        negative
    }

    /// Transforms a matrix for the ends to global axes.
    fn turn(&self, matrix: &mut [f64]) {
        let (Some(axes), n) = (&self.axes, self.ends) else {
            return;
        };
        for triple in matrix[..self.motions * n].chunks_exact_mut(3 * n) {
            for j in 0..n {
                let own = [triple[j], triple[n + j], triple[2 * n + j]];
                for i in 0..3 {
                    triple[i * n + j] = (0..3).map(|k| axes[k][i] * own[k]).sum();
                }
            }
        }
        for row in matrix.chunks_exact_mut(n) {
            for triple in row[..self.motions].chunks_exact_mut(3) {
                let own = [triple[0], triple[1], triple[2]];
                for (i, entry) in triple.iter_mut().enumerate() {
                    *entry = (0..3).map(|k| axes[k][i] * own[k]).sum();
                }
            }
        }
    }

    /// A motion in the axes of the parts.
    pub(super) fn to_axes(&self, motion: &Motion) -> Motion {
        match &self.axes {
            Some(axes) => into_axes(axes, motion),
            None => *motion,
        }
    }

    /// A force of the parts in global axes.
    pub(super) fn out_of_axes(&self, force: &[f64]) -> Motion {
        let force = std::array::from_fn(|i| force[i]);
        match &self.axes {
            Some(axes) => out_of_axes(axes, &force),
            None => force,
        }
    }

    /// Replaces the forces on the bubbles by their forward substitution, and adds the resulting
    /// forces to the ends.
    pub(super) fn forward<'f>(
        &self,
        factors: &mut impl Iterator<Item = &'f Vec<f64>>,
        ends: &mut Ends,
        bubbles: &mut [f64],
        at: &mut Vec<f64>,
    ) {
        for (block, matrix) in self.blocks.iter().zip(factors) {
            let leading = block.leading();
            for plane in &block.planes {
                block.gather(plane, ends, bubbles, at);
                forward(matrix, block.rows(), leading, at);
                for ((end, sign), force) in plane.ends.iter().zip(&*at) {
                    ends[*end] = sign * force;
                }
                bubbles[plane.first..][..block.bubbles].copy_from_slice(&at[leading..]);
            }
        }
    }

    /// Computes the bubbles from their forward substitution and the ends.
    pub(super) fn backward<'f>(
        &self,
        factors: &mut impl Iterator<Item = &'f Vec<f64>>,
        ends: &Ends,
        bubbles: &mut [f64],
        at: &mut Vec<f64>,
    ) {
        for (block, matrix) in self.blocks.iter().zip(factors) {
            let leading = block.leading();
            for plane in &block.planes {
                block.gather(plane, ends, bubbles, at);
                backward(matrix, block.rows(), leading, at);
                bubbles[plane.first..][..block.bubbles].copy_from_slice(&at[leading..]);
            }
        }
    }

    /// Adds the energy xᵀ A x of each kind of matrix, without the coordinates' own stiffness.
    pub(super) fn add_energies(
        &self,
        ends: &Ends,
        bubbles: &[f64],
        at: &mut Vec<f64>,
        energies: &mut [f64; KINDS],
    ) {
        let planes = self.blocks.iter();
        let planes = planes.flat_map(|block| block.planes.iter().map(move |plane| (block, plane)));
        for (block, plane) in planes {
            block.gather(plane, ends, bubbles, at);
            let rows = block.rows();
            for (energy, matrix) in energies.iter_mut().zip(&block.matrices) {
                if matrix.is_empty() {
                    continue;
                }
                at.truncate(rows);
                at.resize(2 * rows, 0.0);
                let (x, y) = at.split_at_mut(rows);
                add_product(1.0, matrix, x, y);
                *energy += dot(x, y);
            }
        }
    }

    /// The forces A (ends, bubbles) without the coordinates' own stiffness.
    pub(super) fn product(
        &self,
        factors: &[f64; KINDS],
        ends: &Ends,
        (bubbles, out): (&[f64], &mut [f64]),
        at: &mut Vec<f64>,
    ) -> Ends {
        let mut forces = [0.0; MOST_ENDS];
        out.fill(0.0);
        let planes = self.blocks.iter();
        let planes = planes.flat_map(|block| block.planes.iter().map(move |plane| (block, plane)));
        for (block, plane) in planes {
            block.gather(plane, ends, bubbles, at);
            let rows = block.rows();
            at.resize(2 * rows, 0.0);
            let (x, y) = at.split_at_mut(rows);
            for (factor, matrix) in factors.iter().zip(&block.matrices) {
                if *factor != 0.0 {
                    add_product(*factor, matrix, x, y);
                }
            }
            let (of_ends, of_bubbles) = y.split_at(plane.ends.len());
            for ((end, sign), force) in plane.ends.iter().zip(of_ends) {
                forces[*end] += sign * force;
            }
            for (out, force) in out[plane.first..].iter_mut().zip(of_bubbles) {
                *out += force;
            }
        }
        forces
    }
}

/// A part of an element as a block of a chord: its coordinates s that move the far end are
/// L⁻¹ (q_far − X q_near), and its elastic energy is sᵀ s.
fn chord_block(part: &Part, element: &Element, first: usize) -> Block {
    let (n, moving) = (part.own(), part.moving());
    let bubbles = part.coordinates - moving;
    let rows = 2 * n + bubbles;
    let inverse = inverse_tip(part);
    // X in the components of the part.
    let components = part.planes[0];
    let transfer =
        |(d, of_row): &Component, (c, sign): &Component| of_row * sign * element.transfer[*d][*c];
    // v and y for (q_near, q_far, bubbles).
    let old = n + part.coordinates;
    let mut change = vec![0.0; old * rows];
    (0..n).for_each(|i| change[i * rows + i] = 1.0);
    for (k, inverse) in inverse.iter().enumerate() {
        let row = &mut change[(n + k) * rows..][..2 * n];
        row[n..].copy_from_slice(inverse);
        for (to_near, c) in row[..n].iter_mut().zip(components) {
            let moved = components.iter().zip(inverse);
            *to_near = -moved.map(|(d, l)| l * transfer(d, c)).sum::<f64>();
        }
    }
    for bubble in 0..bubbles {
        change[(n + moving + bubble) * rows + 2 * n + bubble] = 1.0;
    }
    let mut matrices = [const { Vec::new() }; KINDS];
    for (matrix, own) in matrices.iter_mut().zip(&part.matrices) {
        *matrix = congruence(own, &change, old, rows);
    }
    let mut elastic = vec![0.0; rows * rows];
    for row in change[n * rows..].chunks_exact(rows).take(moving) {
        for (out, a) in elastic.chunks_exact_mut(rows).zip(&row[..2 * n]) {
            out.iter_mut()
                .zip(&row[..2 * n])
                .for_each(|(o, b)| *o += a * b);
        }
    }
    matrices[ELASTIC] = elastic;
    let plane = |(k, components): (usize, &&'static [Component])| {
        let far = components.iter().map(|(c, sign)| (6 + c, *sign));
        Plane {
            ends: components.iter().copied().chain(far).collect(),
            first: first + k * bubbles,
        }
    };
    Block {
        planes: part.planes.iter().enumerate().map(plane).collect(),
        bubbles,
        matrices,
    }
}

/// L⁻¹ of a part of an element, in its components.
pub(super) fn inverse_tip(part: &Part) -> Vec<Vec<f64>> {
    inverse_of_columns(&part.tip, part.own())
}

/// The inverse of the matrix of n rows with these columns, by Gauss-Jordan elimination with pivots.
pub(super) fn inverse_of_columns(columns: &[Vec<f64>], n: usize) -> Vec<Vec<f64>> {
    let entry = |i: usize, j: usize| match j.checked_sub(n) {
        None => columns.get(j).map_or(0.0, |column| column[i]),
        Some(j) => f64::from(u8::from(i == j)),
    };
    let row = |i: usize| (0..2 * n).map(|j| entry(i, j)).collect::<Vec<f64>>();
    let mut a: Vec<Vec<f64>> = (0..n).map(row).collect();
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| a[*i][k].abs().total_cmp(&a[*j][k].abs()));
        a.swap(k, pivot.unwrap_or(k));
        let row: Vec<f64> = a[k].iter().map(|entry| entry / a[k][k]).collect();
        for (i, other) in a.iter_mut().enumerate() {
            let factor = other[k];
            if i != k {
                let pairs = other.iter_mut().zip(&row);
                pairs.for_each(|(x, r)| *x -= factor * r);
            }
        }
        a[k] = row;
    }
    a.into_iter().map(|row| row[n..].to_vec()).collect()
}

/// Cᵀ M C for a matrix M of `old` rows and C of `old` rows and `rows` columns; empty if M is empty.
fn congruence(matrix: &[f64], change: &[f64], old: usize, rows: usize) -> Vec<f64> {
    if matrix.is_empty() {
        return Vec::new();
    }
    let add = |out: &mut [f64], factor: f64, row: &[f64]| {
        if factor != 0.0 {
            out.iter_mut().zip(row).for_each(|(o, x)| *o += factor * x);
        }
    };
    // Most entries of a row of C are zero.
    let mut half = vec![0.0; old * rows];
    for (out, row) in half.chunks_exact_mut(rows).zip(matrix.chunks_exact(old)) {
        for (factor, change) in row.iter().zip(change.chunks_exact(rows)) {
            for (o, c) in out.iter_mut().zip(change).filter(|(_, c)| **c != 0.0) {
                *o += factor * c;
            }
        }
    }
    let mut sum = vec![0.0; rows * rows];
    for (half, change) in half.chunks_exact(rows).zip(change.chunks_exact(rows)) {
        for (out, factor) in sum.chunks_exact_mut(rows).zip(change) {
            add(out, *factor, half);
        }
    }
    sum
}

/// y += factor M x for a symmetric matrix, which may be empty: four columns at a time, and two
/// entries of each column, so that the processor multiplies them in one operation.
fn add_product(factor: f64, matrix: &[f64], x: &[f64], y: &mut [f64]) {
    let n = x.len();
    let (fours, rest) = x.as_chunks::<4>();
    for (x, rows) in fours.iter().zip(matrix.chunks_exact(4 * n)) {
        let [a, b, c, d] = x.map(|x| factor * x);
        let row = |k: usize| rows[k * n..][..n].as_chunks::<2>();
        let [(p, p_last), (q, q_last), (r, r_last), (s, s_last)] = std::array::from_fn(row);
        let (pairs, last) = y.as_chunks_mut::<2>();
        for ((((y, p), q), r), s) in pairs.iter_mut().zip(p).zip(q).zip(r).zip(s) {
            y[0] += (a * p[0] + b * q[0]) + (c * r[0] + d * s[0]);
            y[1] += (a * p[1] + b * q[1]) + (c * r[1] + d * s[1]);
        }
        for ((((y, p), q), r), s) in last
            .iter_mut()
            .zip(p_last)
            .zip(q_last)
            .zip(r_last)
            .zip(s_last)
        {
            *y += (a * p + b * q) + (c * r + d * s);
        }
    }
    let done = 4 * fours.len() * n;
    for (x, row) in rest
        .iter()
        .zip(matrix.get(done..).unwrap_or_default().chunks_exact(n))
    {
        add(factor * x, row, y);
    }
}

/// y += factor x, two entries at a time.
fn add(factor: f64, x: &[f64], y: &mut [f64]) {
    let ((x, x_last), (y, y_last)) = (x.as_chunks::<2>(), y.as_chunks_mut::<2>());
    for (y, x) in y.iter_mut().zip(x) {
        y[0] += factor * x[0];
        y[1] += factor * x[1];
    }
    for (y, x) in y_last.iter_mut().zip(x_last) {
        *y += factor * x;
    }
}

/// Two sums at a time, which the processor adds in one operation.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (mut sums, pairs) = ([0.0; 2], (a.chunks_exact(2), b.chunks_exact(2)));
    let (a_rest, b_rest) = (pairs.0.remainder(), pairs.1.remainder());
    for (a, b) in pairs.0.zip(pairs.1) {
        sums[0] += a[0] * b[0];
        sums[1] += a[1] * b[1];
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum();
    sums[0] + sums[1] + rest
}

/// Forward substitution of the rows with index `first` and higher, the last row first; without
/// division by the pivots.
fn forward(matrix: &[f64], rows: usize, first: usize, x: &mut [f64]) {
    for last in (first..rows).rev() {
        let row = &matrix[last * rows..last * rows + last + 1];
        let factor = x[last] / row[last];
        add(-factor, &row[..last], &mut x[..last]);
    }
}

/// Backward substitution of the rows with index `first` and higher.
fn backward(matrix: &[f64], rows: usize, first: usize, x: &mut [f64]) {
    for last in first..rows {
        let row = &matrix[last * rows..last * rows + last + 1];
        x[last] = (x[last] - dot(&row[..last], &x[..last])) / row[last];
    }
}
