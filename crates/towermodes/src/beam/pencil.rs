//! A beam as an eigenvalue problem.

use super::count;
use super::model::Beam;
use super::product;
use crate::chain::{Dim, Space};
use crate::eigen::Pencil;

/// Working memory of a beam's products and counts; reused from solve to solve.
#[derive(Debug, Clone, Default)]
pub struct BeamPencilWorkspace {
    loads: Vec<f64>,
    element: Vec<f64>,
}

/// A beam with the memory to work on it: what the eigensolver sees.
#[derive(Debug)]
pub struct BeamPencil<'a, const D: usize> {
    beam: &'a Beam<D>,
    workspace: &'a mut BeamPencilWorkspace,
}

impl<'a, const D: usize> BeamPencil<'a, D> {
    /// The eigenvalue problem of `beam`.
    pub fn new(beam: &'a Beam<D>, workspace: &'a mut BeamPencilWorkspace) -> Self {
        Self { beam, workspace }
    }
}

impl<const D: usize> Pencil for BeamPencil<'_, D>
where
    Dim<D>: Space,
{
    fn size(&self) -> usize {
        self.beam.degrees_of_freedom()
    }

    fn mass_times(&mut self, x: &[f64], out: &mut [f64]) {
        product::mass_times(self.beam, &mut self.workspace.loads, x, out);
    }

    fn stiffness_times(&mut self, x: &[f64], out: &mut [f64]) {
        out.copy_from_slice(x);
    }

    fn count_below(&mut self, shift: f64) -> usize {
        count::count_below(self.beam, shift, &mut self.workspace.element)
    }

    fn factorize(&mut self) -> usize {
        // K is the identity: there is nothing to factor.
        0
    }

    fn solve(&mut self, _: &mut [f64]) {}

    fn start(&mut self, out: &mut [f64]) {
        product::base_excitation(self.beam, &mut self.workspace.loads, out);
    }
}
