//! The resultant of the forces in a frame: the products of the forces with rigid-body motions of
//! the whole frame including the ground.

use super::equations::{Equations, KINDS};
use super::parts::{Parts, Side};
use super::rigid::{
    Motion, NONE, Vector, add_transposed, identity, moved, rigid_transfer, transposed,
};
use crate::space::{SpatialMatrix, add_scaled};
use crate::tower::frame::difference;

/// Positions of the nodes of a frame, without the tower, relative to the reference point of the
/// resultants.
#[derive(Debug)]
pub(super) struct Places {
    about_m: Vector,
    /// Positions of the nodes from the reference point, m.
    pub(super) levers_m: Vec<Vector>,
    /// Number of links.
    links: usize,
}

impl Places {
    /// For the nodes of the equations at these positions; the equations contain nothing else yet.
    pub(super) fn new(equations: &Equations, positions_m: &[Vector], about_m: Vector) -> Self {
        let lever = |position_m: &Vector| difference(*position_m, about_m);
        Self {
            about_m,
            levers_m: positions_m.iter().map(lever).collect(),
            links: equations.links.len(),
        }
    }

    /// The resultant of A for the unknowns x and the motions of all nodes, with a fixed ground.
    pub(super) fn resultant(
        &self,
        equations: &Equations,
        factors: &[f64; KINDS],
        (motions, x): (&[Motion], &[f64]),
    ) -> Motion {
        self.sum(equations, factors, (motions, x, &[0.0; 6]))
    }

    /// The matrix A for rigid-body motions of the whole frame.
    pub(super) fn as_rigid(&self, equations: &Equations, factors: &[f64; KINDS]) -> SpatialMatrix {
        let x = vec![0.0; equations.unknowns];
        let columns = identity().map(|motion| {
            let at = |lever_m: &Vector| moved(&rigid_transfer(*lever_m), &motion);
            let motions: Vec<Motion> = self.levers_m.iter().map(at).collect();
            self.sum(equations, factors, (&motions, &x, &motion))
        });
        transposed(&columns)
    }

    /// The resultant if the ground moves as a rigid body with the reference point.
    fn sum(
        &self,
        equations: &Equations,
        factors: &[f64; KINDS],
        (motions, x, ground): (&[Motion], &[f64], &Motion),
    ) -> Motion {
        let mut sum = [0.0; 6];
        let mut add = |lever_m: &Vector, force: &Motion| {
            add_transposed(&mut sum, &rigid_transfer(*lever_m), force);
        };
        let nodes = equations.nodes.iter().zip(motions);
        for ((matrices, motion), lever_m) in nodes.zip(&self.levers_m) {
            let mut matrix = NONE;
            let parts = factors.iter().zip(matrices);
            parts.for_each(|(factor, own)| add_scaled(&mut matrix, *factor, own));
            add(lever_m, &moved(&matrix, motion));
        }
        let motion_of = |node: Option<usize>, lever_m: &Vector| match node {
            Some(node) => motions[node],
            None => moved(&rigid_transfer(*lever_m), ground),
        };
        let (mut at, mut load) = (Vec::new(), Vec::new());
        let mut forces_of = |parts: &Parts, side: Side<'_>| {
            load.resize(side.bubbles.len(), 0.0);
            parts.product(factors, &side.ends, (side.bubbles, &mut load), &mut at)
        };
        for link in &equations.links[..self.links] {
            let lever_m = match link.parent {
                Some(parent) => self.levers_m[parent],
                None => difference(self.levers_m[link.child], lever_of(&link.transfer)),
            };
            let side = link.side(x, &motion_of(link.parent, &lever_m));
            let forces = forces_of(&link.parts, side);
            add(&lever_m, &link.parts.out_of_axes(&forces[..6]));
        }
        for chord in &equations.chords {
            let levers_m = chord.ends_m.map(|end_m| difference(end_m, self.about_m));
            let motions = std::array::from_fn(|i| motion_of(chord.ends[i], &levers_m[i]));
            let forces = forces_of(&chord.parts, chord.side(x, motions));
            add(&levers_m[0], &chord.parts.out_of_axes(&forces[..6]));
            add(&levers_m[1], &chord.parts.out_of_axes(&forces[6..]));
        }
        sum
    }
}

/// The lever (m) of a [`rigid_transfer`].
pub(super) fn lever_of(transfer: &SpatialMatrix) -> Vector {
    [transfer[1][5], transfer[2][3], transfer[0][4]]
}
