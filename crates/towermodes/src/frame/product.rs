//! Products with the matrices of a frame: motions from the ground outwards, forces back.

use super::equations::{ELASTIC, Equations, INERTIA, KINDS, add_force, motion_of};
use super::parts::Side;
use super::rigid::{Motion, add_transposed, moved};

/// Working memory of a product.
#[derive(Debug, Clone, Default)]
pub(super) struct Sweep {
    pub(super) motions: Vec<Motion>,
    forces: Vec<Motion>,
    /// The motion of the ground.
    ground: Motion,
    at: Vec<f64>,
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
            let range = chord.first..chord.first + chord.parts.bubbles();
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
            let moving = link.tip.len();
            let Side { ends, bubbles } = link.side(x, &motion_of(link.parent));
            let out = &mut out[link.first..][..link.coordinates];
            let (own, of_bubbles) = out.split_at_mut(moving);
            let load = link
                .parts
                .product(factors, &ends, (bubbles, of_bubbles), at);
            own.copy_from_slice(&load[6..6 + moving]);
            add_force(forces, link.parent, &link.parts.out_of_axes(&load[..6]));
        }
        for chord in &self.chords {
            let Side { ends, bubbles } = chord.side(x, chord.ends.map(motion_of));
            let out = &mut out[chord.first..][..bubbles.len()];
            let load = chord.parts.product(factors, &ends, (bubbles, out), at);
            add_force(forces, chord.ends[0], &chord.parts.out_of_axes(&load[..6]));
            add_force(forces, chord.ends[1], &chord.parts.out_of_axes(&load[6..]));
        }
    }

    /// xᵀ A x of each kind of matrix; the energy of the coordinates is included in the elastic
    /// stiffness.
    pub(super) fn energies(&self, sweep: &mut Sweep, x: &[f64]) -> [f64; KINDS] {
        self.set_motions(x, &mut sweep.motions);
        let Sweep { motions, at, .. } = sweep;
        let motion = |node| motion_of(motions, node);
        let mut energies = [0.0; KINDS];
        for (matrices, motion) in self.nodes.iter().zip(&*motions) {
            for (energy, matrix) in energies.iter_mut().zip(matrices) {
                let force = moved(matrix, motion);
                *energy += force.iter().zip(motion).map(|(f, v)| f * v).sum::<f64>();
            }
        }
        let squares = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>();
        for link in &self.links {
            let Side { ends, bubbles } = link.side(x, &motion(link.parent));
            link.parts.add_energies(&ends, bubbles, at, &mut energies);
            energies[ELASTIC] += link.own * squares(&x[link.first..][..link.coordinates]);
        }
        for chord in &self.chords {
            let Side { ends, bubbles } = chord.side(x, chord.ends.map(motion));
            chord.parts.add_energies(&ends, bubbles, at, &mut energies);
            energies[ELASTIC] += squares(bubbles);
        }
        energies
    }

    /// Adds the forces on the nodes to the forces on the coordinates.
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

    /// The force and moment at the child of each link that it passes on to its parent, from all
    /// nodes beyond it: the forces of a motion of every node, less the forces of the unknowns x.
    pub(super) fn passed_on(
        &self,
        (loads, motion): (&[f64; KINDS], Motion),
        (stiffness, x): (&[f64; KINDS], &[f64]),
    ) -> Vec<Motion> {
        let still = vec![0.0; self.unknowns];
        let mut forces = self.forces_of(loads, &still, (vec![motion; self.nodes.len()], motion));
        let mut motions = Vec::new();
        self.set_motions(x, &mut motions);
        let held = self.forces_of(stiffness, x, (motions, [0.0; 6]));
        for (force, held) in forces.iter_mut().flatten().zip(held.iter().flatten()) {
            *force -= held;
        }
        let mut passed = vec![[0.0; 6]; self.links.len()];
        for (link, passed) in self.links.iter().zip(&mut passed).rev() {
            *passed = forces[link.child];
            if let Some(parent) = link.parent {
                add_transposed(&mut forces[parent], &link.transfer, passed);
            }
        }
        passed
    }

    /// The forces of matrices on the nodes, for the unknowns x and motions of nodes and ground.
    fn forces_of(
        &self,
        factors: &[f64; KINDS],
        x: &[f64],
        (motions, ground): (Vec<Motion>, Motion),
    ) -> Vec<Motion> {
        let mut sweep = Sweep {
            motions,
            forces: vec![[0.0; 6]; self.nodes.len()],
            ground,
            ..Sweep::default()
        };
        self.load(factors, &mut sweep, x, &mut vec![0.0; self.unknowns]);
        sweep.forces
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
