//! Local motions of the members of a frame in a mode: the difference between the motion of the
//! frame and its static motion for the motion of its transition piece.
//!
//! x = Ψ q + f, with the motion q of the transition piece and the static shapes Ψ of the frame for
//! it (Guyan 1965). The strain energy has no product of both parts. Of the kinetic energy f has
//! fᵀ M x. Only members in loops count: a single pile is a part of the tower's bending, but legs
//! and braces can vibrate under a transition piece that stands still.

use super::elimination::Factors;
use super::equations::{ELASTIC, Equations, GROUND, INERTIA, KINDS, motion_of};
use super::order::Order;
use super::parts::{Parts, Side};
use super::rigid::Motion;
use crate::space::{SpatialMatrix, eigenpairs};

/// A flexibility less than this fraction of the largest one belongs to a fixed motion.
const HELD: f64 = 1e-15;

/// The static shapes of a frame for the motions of its transition piece, and its members in loops.
#[derive(Debug)]
pub(super) struct Local {
    /// Ψ: the unknowns for each motion (x, y, z, rotation about x, y, z).
    shapes: Vec<Vec<f64>>,
    /// Whether each link is in a loop; chords close loops.
    in_loop: Vec<bool>,
}

impl Local {
    /// Data of a frame without its tower; none without loops, or if the frame is supported only by
    /// the tower.
    pub(super) fn new(equations: &Equations, node: usize) -> Option<Self> {
        let in_loop = links_in_loops(equations);
        if !in_loop.contains(&true) {
            return None;
        }
        let (order, mut factors) = (Order::new(equations), Factors::default());
        let mut stiffness = [0.0; KINDS];
        (stiffness[GROUND], stiffness[ELASTIC]) = (1.0, 1.0);
        if equations.factorize(&order, (&stiffness, 1.0), &mut factors) != 0 {
            return None;
        }
        let mut memory = UnitLoads::default();
        let mut of_forces: Vec<Vec<f64>> = Vec::with_capacity(6);
        let flexibility = flexibility(equations, (&order, &mut factors), node, &mut memory, |x| {
            of_forces.push(x.to_vec());
        });
        let stiffness = inverse(flexibility);
        let shape = |row: &[f64; 6]| {
            let mut shape = vec![0.0; equations.unknowns];
            for (force, own) in row.iter().zip(&of_forces) {
                shape
                    .iter_mut()
                    .zip(own)
                    .for_each(|(sum, x)| *sum += force * x);
            }
            shape
        };
        Some(Self {
            shapes: stiffness.iter().map(shape).collect(),
            in_loop,
        })
    }

    /// fᵀ M x and the elastic energy fᵀ K x of the members in loops, for the unknowns of the frame
    /// first in x, and the motions of all nodes.
    pub(super) fn energies(
        &self,
        equations: &Equations,
        node: usize,
        x: &[f64],
        motions: &[Motion],
    ) -> [f64; 2] {
        let mut own = x.to_vec();
        for (shape, amount) in self.shapes.iter().zip(motions[node]) {
            own.iter_mut()
                .zip(shape)
                .for_each(|(x, shape)| *x -= amount * shape);
        }
        // Parts connected to the frame that are beyond its unknowns have no motion in f.
        own[self.shapes[0].len()..].fill(0.0);
        let mut own_motions = Vec::new();
        equations.set_motions(&own, &mut own_motions);
        let mut energies = [0.0; 2];
        let (mut at, mut load) = (Vec::new(), Vec::new());
        let mut add = |parts: &Parts, stiffness: f64, whole: Side<'_>, local: Side<'_>| {
            load.resize(whole.bubbles.len(), 0.0);
            for (kind, energy) in [INERTIA, ELASTIC].into_iter().zip(&mut energies) {
                let mut factors = [0.0; KINDS];
                factors[kind] = 1.0;
                let forces =
                    parts.product(&factors, &whole.ends, (whole.bubbles, &mut load), &mut at);
                *energy += dot(&forces, &local.ends) + dot(&load, local.bubbles);
            }
            let coordinates = dot(&whole.ends[parts.motions..], &local.ends[parts.motions..]);
            energies[1] += stiffness * (coordinates + dot(whole.bubbles, local.bubbles));
        };
        for (link, _) in equations
            .links
            .iter()
            .zip(&self.in_loop)
            .filter(|(_, is)| **is)
        {
            let side = |x, motions: &[Motion]| link.side(x, &motion_of(motions, link.parent));
            let (whole, local) = (side(x, motions), side(&own, &own_motions));
            add(&link.parts, link.own, whole, local);
        }
        for chord in &equations.chords {
            let side = |x, motions: &[Motion]| {
                chord.side(x, chord.ends.map(|end| motion_of(motions, end)))
            };
            let (whole, local) = (side(x, motions), side(&own, &own_motions));
            add(&chord.parts, 1.0, whole, local);
        }
        energies
    }
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Whether members of a frame are in loops.
pub(super) fn has_loops(equations: &Equations) -> bool {
    links_in_loops(equations).contains(&true)
}

/// The links in loops: each chord of a beam closes a loop, also through the ground.
fn links_in_loops(equations: &Equations) -> Vec<bool> {
    let mut link_of = vec![None; equations.nodes.len()];
    for (place, link) in equations.links.iter().enumerate() {
        link_of[link.child] = Some(place);
    }
    let mut in_loop = vec![false; equations.links.len()];
    let chords = equations.chords.iter();
    for chord in chords.filter(|chord| chord.parts.bubbles() > 0) {
        let [near, far] = chord.ends.map(|end| {
            let link = |node: Option<usize>| node.and_then(|node| link_of[node]);
            let up = |place: &usize| link(equations.links[*place].parent);
            std::iter::successors(link(end), up).collect::<Vec<usize>>()
        });
        // What both have in common is above the loop.
        let common = near
            .iter()
            .rev()
            .zip(far.iter().rev())
            .take_while(|(a, b)| a == b);
        let common = common.count();
        for path in [&near, &far] {
            path[..path.len() - common]
                .iter()
                .for_each(|place| in_loop[*place] = true);
        }
    }
    in_loop
}

/// Working memory for a flexibility.
#[derive(Debug, Clone, Default)]
struct UnitLoads {
    x: Vec<f64>,
    forces: Vec<Motion>,
    motions: Vec<Motion>,
}

/// J A⁻¹ Jᵀ of a node with a matrix that is factored; `each` is passed A⁻¹ Jᵀ column by column.
fn flexibility(
    equations: &Equations,
    (order, factors): (&Order, &mut Factors),
    node: usize,
    UnitLoads { x, forces, motions }: &mut UnitLoads,
    mut each: impl FnMut(&[f64]),
) -> SpatialMatrix {
    let mut flexibility = [[0.0; 6]; 6];
    for (component, row) in flexibility.iter_mut().enumerate() {
        forces.clear();
        forces.resize(equations.nodes.len(), [0.0; 6]);
        forces[node][component] = 1.0;
        x.clear();
        x.resize(equations.unknowns, 0.0);
        equations.gather(forces, x);
        equations.solve(order, factors, x);
        equations.set_motions(x, motions);
        *row = motions[node];
        each(x);
    }
    std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (flexibility[i][j] + flexibility[j][i])))
}

/// The inverse of a flexibility.
fn inverse(flexibility: SpatialMatrix) -> SpatialMatrix {
    let (flexibilities, directions) = eigenpairs(flexibility);
    let sizes = flexibilities.iter().map(|f| f.abs());
    let most = sizes.fold(0.0, f64::max);
    let mut stiffness = [[0.0; 6]; 6];
    for (flexibility, direction) in flexibilities.iter().zip(&directions) {
        let least = (HELD * most).max(f64::MIN_POSITIVE);
        let resisted = 1.0 / flexibility.abs().max(least).copysign(*flexibility);
        for (row, a) in stiffness.iter_mut().zip(direction) {
            let entries = row.iter_mut().zip(direction);
            entries.for_each(|(entry, b)| *entry += resisted * a * b);
        }
    }
    stiffness
}
