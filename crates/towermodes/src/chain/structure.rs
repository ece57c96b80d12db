//! A chain as what eigenvalue problems are made of.

use super::articulated::{self, Elimination};
use super::joint::JointFlexibility;
use super::model::Chain;
use super::product::{self, Loads};
use crate::parts::{Balance, Combination, Kind, Part, Parts, Role, Structure, on_structure};
use crate::space::{Dim, Matrix, Space};

/// Working memory of a chain's products and factorizations; reused from solve to solve.
#[derive(Debug, Clone)]
pub struct ChainWork<const D: usize> {
    loads: Loads<D>,
    factors: Vec<Elimination<D>>,
}

impl<const D: usize> Default for ChainWork<D> {
    fn default() -> Self {
        Self {
            loads: Loads::default(),
            factors: Vec::new(),
        }
    }
}

impl<const D: usize> Structure<D> for Chain<D>
where
    Dim<D>: Space,
{
    type Work = ChainWork<D>;

    fn clear(&mut self) {
        Self::clear(self);
    }

    fn add_base(&mut self, height_m: f64, unit: [f64; D]) {
        Self::add_base(self, height_m, unit);
    }

    #[inline]
    fn add(&mut self, role: Role, reference_m: f64, matrix: Matrix<D>) {
        Self::add(self, role, reference_m, matrix);
    }

    #[inline]
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

    fn times(&self, combination: &Combination, work: &mut Self::Work, x: &[f64], out: &mut [f64]) {
        product::product(self, combination, &mut work.loads, x, out);
    }

    fn count_negative(&self, combination: &Combination, _: &mut Self::Work) -> usize {
        articulated::count_negative(self, combination)
    }

    fn factorize(&self, combination: &Combination, work: &mut Self::Work) -> usize {
        articulated::factorize(self, combination, &mut work.factors)
    }

    fn solve(&self, work: &mut Self::Work, x: &mut [f64]) {
        articulated::solve(self, &work.factors, x);
    }

    fn balance(
        &self,
        combination: &Combination,
        _: &mut Self::Work,
        x: &[f64],
        base_m: f64,
    ) -> Balance<D> {
        product::balance(self, combination, x, base_m)
    }

    fn start(&self, _: &mut Self::Work, out: &mut [f64]) {
        product::base_excitation(self, out);
    }
}

/// The kind of structure that chains are.
#[derive(Debug, Clone, Copy)]
pub struct Chains;

impl Kind for Chains {
    type Of<const D: usize>
        = Chain<D>
    where
        Dim<D>: Space;
}

impl Parts<Chains> {
    /// Makes room for so many joints in each part.
    pub fn reserve(&mut self, joints: usize) {
        for part in self.iter_mut() {
            on_structure!(part, member => member.structure.reserve(joints));
        }
    }

    /// A joint at a height (m) under a compression (N); see [`Chain::add_joint`].
    pub fn add_joint(&mut self, height_m: f64, joint: &JointFlexibility, compression_n: f64) {
        for part in self.iter_mut() {
            add_joint(part, height_m, joint, compression_n);
        }
    }
}

#[inline]
fn add_joint(part: &mut Part<Chains>, z: f64, joint: &JointFlexibility, n: f64) {
    match part {
        Part::Line(line, chain) => chain.structure.add_joint(z, [joint.line(*line)], n),
        Part::Plane(plane, chain) => chain.structure.add_joint(z, joint.bending(*plane), n),
        Part::PlaneAndLine(plane, line, chain) => {
            let flexibility = joint.plane_and_line(*plane, *line);
            chain.structure.add_joint(z, flexibility, n);
        }
        Part::Space(motions, chain) => {
            let flexibility = motions.masked(joint.spatial());
            chain.structure.add_joint(z, flexibility, n);
        }
    }
}
