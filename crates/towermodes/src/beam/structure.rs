//! A beam as what eigenvalue problems are made of.

use super::elimination::{self, Factors};
use super::model::Beam;
use super::product;
use crate::parts::{Balance, Combination, Kind, Role, Structure};
use crate::space::{Dim, Matrix, Space};

/// Working memory of a beam's products and factorizations; reused from solve to solve.
#[derive(Debug, Clone, Default)]
pub struct BeamWork {
    loads: Vec<f64>,
    factors: Factors,
}

impl<const D: usize> Structure<D> for Beam<D>
where
    Dim<D>: Space,
{
    type Work = BeamWork;

    fn clear(&mut self) {
        Self::clear(self);
    }

    fn add_base(&mut self, height_m: f64, unit: [f64; D]) {
        Self::add_base(self, height_m, unit);
    }

    fn add(&mut self, role: Role, reference_m: f64, matrix: Matrix<D>) {
        Self::add(self, role, reference_m, matrix);
    }

    fn overturn(&mut self, stiffness_n_m: f64) {
        Self::overturn(self, stiffness_n_m);
    }

    fn degrees_of_freedom(&self) -> usize {
        Self::degrees_of_freedom(self)
    }

    fn is_finite(&self) -> bool {
        Self::is_finite(self)
    }

    fn is_identity(&self, combination: &Combination) -> bool {
        Self::is_identity(self, combination)
    }

    fn times(&self, combination: &Combination, work: &mut BeamWork, x: &[f64], out: &mut [f64]) {
        product::product(self, combination, &mut work.loads, x, out);
    }

    fn count_negative(&self, combination: &Combination, work: &mut BeamWork) -> usize {
        elimination::count_negative(self, combination, &mut work.factors)
    }

    fn factorize(&self, combination: &Combination, work: &mut BeamWork) -> usize {
        elimination::factorize(self, combination, &mut work.factors)
    }

    fn solve(&self, work: &mut BeamWork, x: &mut [f64]) {
        elimination::solve(self, &mut work.factors, x);
    }

    fn balance(
        &self,
        combination: &Combination,
        work: &mut BeamWork,
        x: &[f64],
        _: f64,
    ) -> Balance<D> {
        product::balance(self, combination, &mut work.loads, x)
    }

    fn start(&self, work: &mut BeamWork, out: &mut [f64]) {
        product::base_excitation(self, &mut work.loads, out);
    }
}

/// The kind of structure that beams are.
#[derive(Debug, Clone, Copy)]
pub struct Beams;

impl Kind for Beams {
    type Of<const D: usize>
        = Beam<D>
    where
        Dim<D>: Space;
}
