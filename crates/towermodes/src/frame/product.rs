//! Products with the matrices of a frame: motions from the ground outwards, forces back.

use super::equations::{Equations, INERTIA, KINDS, add_force};
use super::rigid::{Motion, add_transposed, moved};

/// Memory of a product.
#[derive(Debug, Clone, Default)]
pub(super) struct Sweep {
    pub(super) motions: Vec<Motion>,
    forces: Vec<Motion>,
    /// The motion of the ground.
    ground: Motion,
    at: Vec<f64>,
    load: Vec<f64>,
}

impl Equations {
    /// The motion of each node for the unknowns x.
    pub(super) fn set_motions(&self, x: &[f64], motions: &mut Vec<Motion>) {
        motions.clear();
        motions.resize(self.nodes.len(), [0.0; 6]);
        for link in &self.links {
            let mut motion = match link.parent {
                Some(parent) => moved(&link.transfer, &motions[parent]),
                None => [0.0; 6],
            };
            for (column, y) in link.tip.iter().zip(&x[link.first..]) {
                for (sum, entry) in motion.iter_mut().zip(column) {
                    *sum += entry * y;
                }
            }
            motions[link.child] = motion;
        }
    }

    /// out = A x, for A = Σ factor·matrix and `own` times the stiffness of the coordinates.
    pub(super) fn product(
        &self,
        (factors, own): (&[f64; KINDS], f64),
        sweep: &mut Sweep,
        x: &[f64],
        out: &mut [f64],
    ) {
        self.set_motions(x, &mut sweep.motions);
        sweep.forces.clear();
        sweep.forces.resize(self.nodes.len(), [0.0; 6]);
        self.load(factors, sweep, x, out);
        for link in &self.links {
            let range = link.first..link.first + link.coordinates;
            for (out, x) in out[range.clone()].iter_mut().zip(&x[range]) {
                *out += own * link.own * x;
            }
        }
        for chord in &self.chords {
            let range = chord.first..chord.first + chord.bubbles;
            for (out, x) in out[range.clone()].iter_mut().zip(&x[range]) {
                *out += own * x;
            }
        }
        self.gather(&mut sweep.forces, out);
    }

    /// The forces of nodes, links and chords: on the nodes in the sweep, on the unknowns in `out`.
    fn load(&self, factors: &[f64; KINDS], sweep: &mut Sweep, x: &[f64], out: &mut [f64]) {
        let Sweep {
            motions,
            forces,
            ground,
            at,
            load,
        } = sweep;
        let motion_of = |node: Option<usize>| node.map_or(*ground, |node| motions[node]);
        for ((matrices, motion), force) in self.nodes.iter().zip(&*motions).zip(&mut *forces) {
            for (factor, matrix) in factors.iter().zip(matrices) {
                if *factor != 0.0 {
                    let own = moved(matrix, motion);
                    force
                        .iter_mut()
                        .zip(own)
                        .for_each(|(f, own)| *f += factor * own);
                }
            }
        }
        for link in &self.links {
            let (own, rows) = (&x[link.first..][..link.coordinates], link.rows());
            at.clear();
            at.extend(motion_of(link.parent));
            at.extend(own);
            times(factors, &link.matrices, rows, at, load);
            add_force(forces, link.parent, &load[..6]);
            out[link.first..][..link.coordinates].copy_from_slice(&load[6..]);
        }
        for chord in &self.chords {
            let (own, rows) = (&x[chord.first..][..chord.bubbles], chord.rows());
            at.clear();
            at.extend(motion_of(chord.ends[0]));
            at.extend(motion_of(chord.ends[1]));
            at.extend(own);
            times(factors, &chord.matrices, rows, at, load);
            add_force(forces, chord.ends[0], &load[..6]);
            add_force(forces, chord.ends[1], &load[6..12]);
            out[chord.first..][..chord.bubbles].copy_from_slice(&load[12..]);
        }
    }

    /// Brings forces on the nodes back to the coordinates, which get their part added.
    pub(super) fn gather(&self, forces: &mut [Motion], out: &mut [f64]) {
        for link in self.links.iter().rev() {
            let force = forces[link.child];
            for (column, out) in link.tip.iter().zip(&mut out[link.first..]) {
                *out += column.iter().zip(force).map(|(t, f)| t * f).sum::<f64>();
            }
            if let Some(parent) = link.parent {
                add_transposed(&mut forces[parent], &link.transfer, &force);
            }
        }
    }

    /// Inertia forces of a motion that is 1 in every component at every node: a start vector.
    pub(super) fn start(&self, out: &mut [f64]) {
        let mut factors = [0.0; KINDS];
        factors[INERTIA] = 1.0;
        self.loads_of_rigid_motion(&factors, [1.0; 6], out);
    }

    /// out = Jᵀ A r for the same motion r of every node, without deformations.
    pub(super) fn loads_of_rigid_motion(
        &self,
        factors: &[f64; KINDS],
        motion: Motion,
        out: &mut [f64],
    ) {
        let mut sweep = Sweep {
            motions: vec![motion; self.nodes.len()],
            forces: vec![[0.0; 6]; self.nodes.len()],
            ground: motion,
            ..Sweep::default()
        };
        self.load(factors, &mut sweep, &vec![0.0; self.unknowns], out);
        self.gather(&mut sweep.forces, out);
    }
}

/// load = Σ factor·A x.
fn times(
    factors: &[f64; KINDS],
    matrices: &[Vec<f64>; KINDS],
    rows: usize,
    x: &[f64],
    load: &mut Vec<f64>,
) {
    load.clear();
    load.resize(rows, 0.0);
    for (factor, matrix) in factors.iter().zip(matrices) {
        if *factor == 0.0 {
            continue;
        }
        for (load, row) in load.iter_mut().zip(matrix.chunks_exact(rows)) {
            *load += factor * row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
        }
    }
}
