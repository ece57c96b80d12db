//! One step of inverse iteration in two passes over the joints.

use super::articulated::{Elimination, Eliminations, eliminate, motion_up};
use super::energies::EnergySums;
use super::model::{Chain, Link};
use crate::space::{add, transform_force};
use crate::subsystem::{Coefficients, Energies};

/// One step of inverse iteration with a matrix A: factors it, solves A y = Gᵀ Jᵀ f for the forces f
/// on the bodies, and takes the energies of y. The number of negative eigenvalues of A.
///
/// The forces and the right-hand side go down with the elimination, the energies up with the
/// motion: what one waits for is computed while the other waits.
pub fn factorize_and_solve<const D: usize>(
    chain: &Chain<D>,
    a: &Coefficients,
    forces: &[[f64; D]],
    factors: &mut Vec<Elimination<D>>,
    y: &mut [f64],
) -> (usize, Energies) {
    factors.clear();
    let mut down = ForcesDown {
        forces,
        factors,
        next: y.len(),
        begin: y.len(),
        x: y,
        force: [0.0; D],
        bias: [0.0; D],
    };
    let negative = eliminate(chain, a, &mut down);
    let mut sums = EnergySums::default();
    motion_up(chain, factors, y, |joint, link, motion, own| {
        sums.add(chain, joint, link, motion, || link.scaled(own));
    });
    (negative, sums.of(chain, y))
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
