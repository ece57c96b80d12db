//! One step of inverse iteration in two passes over the joints.

use super::articulated::{Elimination, Eliminations, bias_down, eliminate, motion_up};
use super::energies::EnergySums;
use super::model::{Chain, Link};
use super::product::{Loads, coordinates_of_forces, inertia_forces};
use crate::space::{add, transform_force};
use crate::subsystem::{Coefficients, Energies};

/// x ← A⁻¹ M x, with A factored first if it is given, else with the factors of the last A. The
/// number of negative eigenvalues of A (0 if it is not factored), and the energies of the new x.
///
/// The pass down computes the right-hand side with the elimination, the pass up the energies with
/// the motions: the processor overlaps the operations that do not depend on each other.
pub fn inverse_step<const D: usize>(
    chain: &Chain<D>,
    a: Option<&Coefficients>,
    loads: &mut Loads<D>,
    factors: &mut Vec<Elimination<D>>,
    x: &mut [f64],
) -> (usize, Energies) {
    let forces = inertia_forces(chain, loads, x);
    let negative = match a {
        Some(a) => ForcesDown::new(forces, factors, x).eliminate(chain, a),
        None => {
            coordinates_of_forces(chain, forces, x);
            bias_down(chain, factors, x);
            0
        }
    };
    let mut sums = EnergySums::default();
    motion_up(chain, factors, x, |joint, link, motion, own| {
        sums.add(chain, joint, link, motion, || link.scaled(own));
    });
    (negative, sums.of(chain, x))
}

/// The forces on the bodies and the bias of the right-hand side, on the way down.
struct ForcesDown<'a, const D: usize> {
    forces: &'a [[f64; D]],
    factors: &'a mut Vec<Elimination<D>>,
    /// The right-hand side, and in it the first and the next entry of the present joint.
    x: &'a mut [f64],
    begin: usize,
    next: usize,
    force: [f64; D],
    bias: [f64; D],
}

impl<'a, const D: usize> ForcesDown<'a, D> {
    fn new(forces: &'a [[f64; D]], factors: &'a mut Vec<Elimination<D>>, x: &'a mut [f64]) -> Self {
        factors.clear();
        Self {
            forces,
            factors,
            begin: x.len(),
            next: x.len(),
            x,
            force: [0.0; D],
            bias: [0.0; D],
        }
    }

    /// Factors A and returns the number of its negative eigenvalues.
    fn eliminate(mut self, chain: &Chain<D>, a: &Coefficients) -> usize {
        eliminate(chain, a, &mut self)
    }
}

impl<const D: usize> Eliminations<D> for ForcesDown<'_, D> {
    #[inline(always)]
    fn begin(&mut self, joint: usize, link: &Link<D>, rise_m: f64) {
        transform_force(&mut self.force, rise_m);
        transform_force(&mut self.bias, rise_m);
        add(&mut self.force, &self.forces[joint]);
        self.begin -= link.moving;
        self.next = self.begin;
    }

    #[inline(always)]
    fn take(&mut self, component: usize, root: f64, elimination: Elimination<D>) {
        let x = &mut self.x[self.next];
        *x = root * self.force[component];
        elimination.bias(component, root, x, &mut self.bias);
        self.next += 1;
        self.factors.push(elimination);
    }
}
