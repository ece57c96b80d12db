//! A chain as an eigenvalue problem.

use super::articulated::{self, Elimination};
use super::model::Chain;
use super::product;
use super::space::{Dim, Space};
use crate::eigen::Pencil;

/// Working memory of a chain's products and factorizations; reused from solve to solve.
#[derive(Debug, Clone)]
pub struct ChainWorkspace<const D: usize> {
    loads: Vec<[f64; D]>,
    factors: Vec<Elimination<D>>,
}

impl<const D: usize> Default for ChainWorkspace<D> {
    fn default() -> Self {
        Self {
            loads: Vec::new(),
            factors: Vec::new(),
        }
    }
}

/// A chain with the memory to work on it: what the eigensolver sees.
#[derive(Debug)]
pub struct ChainPencil<'a, const D: usize> {
    chain: &'a Chain<D>,
    workspace: &'a mut ChainWorkspace<D>,
}

impl<'a, const D: usize> ChainPencil<'a, D>
where
    Dim<D>: Space,
{
    /// The eigenvalue problem of `chain`.
    pub fn new(chain: &'a Chain<D>, workspace: &'a mut ChainWorkspace<D>) -> Self {
        workspace.loads.clear();
        workspace.loads.reserve_exact(chain.joints());
        Self { chain, workspace }
    }
}

impl<const D: usize> Pencil for ChainPencil<'_, D>
where
    Dim<D>: Space,
{
    fn size(&self) -> usize {
        self.chain.degrees_of_freedom()
    }

    fn mass_times(&mut self, x: &[f64], out: &mut [f64]) {
        product::mass_times(self.chain, &mut self.workspace.loads, x, out);
    }

    fn stiffness_times(&mut self, x: &[f64], out: &mut [f64]) {
        product::stiffness_times(self.chain, &mut self.workspace.loads, x, out);
    }

    fn count_below(&mut self, shift: f64) -> usize {
        articulated::count_below(self.chain, shift)
    }

    fn factorize(&mut self) -> usize {
        // Without springs to ground K is the identity and there is nothing to factor.
        if self.chain.ground.is_empty() {
            return 0;
        }
        articulated::factorize(self.chain, 0.0, &mut self.workspace.factors)
    }

    fn solve(&mut self, x: &mut [f64]) {
        if !self.chain.ground.is_empty() {
            articulated::solve(self.chain, &self.workspace.factors, x);
        }
    }

    fn start(&mut self, out: &mut [f64]) {
        product::base_excitation(self.chain, out);
    }
}
