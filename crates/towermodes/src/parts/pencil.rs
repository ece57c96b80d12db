//! A structure as an eigenvalue problem.

use super::structure::{Combination, Structure};
use crate::eigen::Pencil;
use crate::space::{Dim, Space};

/// Which two matrices the eigenvalues are of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Problem {
    /// (K − σM) u = (λ − σ) M u for an origin σ, rad²/s².
    Vibration {
        /// σ.
        origin: f64,
    },
    /// K u = μ (−G) u: μ times the weights G buckle the structure of stiffness K.
    Buckling,
}

impl Problem {
    fn stiffness(self) -> Combination {
        match self {
            Self::Vibration { origin } => Combination::STIFFNESS.minus(origin, Combination::MASS),
            Self::Buckling => Combination::ELASTIC,
        }
    }

    fn mass(self) -> Combination {
        match self {
            Self::Vibration { .. } => Combination::MASS,
            Self::Buckling => Combination::WEIGHTS,
        }
    }
}

/// A structure with the memory to work on it: what the eigensolver sees.
#[derive(Debug)]
pub struct StructurePencil<'a, S, const D: usize>
where
    S: Structure<D>,
    Dim<D>: Space,
{
    structure: &'a S,
    work: &'a mut S::Work,
    problem: Problem,
    /// Where an iteration begins, if something better is known than the structure's own start.
    first: Option<&'a [f64]>,
}

impl<'a, S, const D: usize> StructurePencil<'a, S, D>
where
    S: Structure<D>,
    Dim<D>: Space,
{
    /// An eigenvalue problem of `structure`.
    pub fn new(structure: &'a S, work: &'a mut S::Work, problem: Problem) -> Self {
        Self {
            structure,
            work,
            problem,
            first: None,
        }
    }

    /// The same, with iterations that begin with a vector near the one looked for.
    pub fn beginning_with(self, first: Option<&'a [f64]>) -> Self {
        Self { first, ..self }
    }

    /// The vibration of a structure that nothing lets float away.
    pub fn vibration(structure: &'a S, work: &'a mut S::Work) -> Self {
        Self::new(structure, work, Problem::Vibration { origin: 0.0 })
    }
}

impl<S, const D: usize> Pencil for StructurePencil<'_, S, D>
where
    S: Structure<D>,
    Dim<D>: Space,
{
    fn size(&self) -> usize {
        self.structure.degrees_of_freedom()
    }

    fn stiffness_is_identity(&self) -> bool {
        self.structure.is_identity(&self.problem.stiffness())
    }

    fn mass_times(&mut self, x: &[f64], out: &mut [f64]) {
        self.structure
            .times(&self.problem.mass(), self.work, x, out);
    }

    fn stiffness_times(&mut self, x: &[f64], out: &mut [f64]) {
        let stiffness = self.problem.stiffness();
        if self.stiffness_is_identity() {
            out.copy_from_slice(x);
        } else {
            self.structure.times(&stiffness, self.work, x, out);
        }
    }

    fn count_below(&mut self, shift: f64) -> usize {
        let shifted = self.problem.stiffness().minus(shift, self.problem.mass());
        self.structure.count_negative(&shifted, self.work)
    }

    fn factorize(&mut self) -> usize {
        let stiffness = self.problem.stiffness();
        if self.stiffness_is_identity() {
            return 0;
        }
        self.structure.factorize(&stiffness, self.work)
    }

    fn solve(&mut self, x: &mut [f64]) {
        if !self.stiffness_is_identity() {
            self.structure.solve(self.work, x);
        }
    }

    fn stiffness_cancellation(&mut self, x: &[f64]) -> f64 {
        if self.stiffness_is_identity() {
            return 0.0;
        }
        let stiffness = self.problem.stiffness();
        let mut energy = |factor: f64, matrix: Combination, x: &[f64]| {
            if factor == 0.0 {
                return 0.0;
            }
            let balance = self.structure.balance(&matrix, self.work, x, 0.0);
            factor * balance.energy.iter().sum::<f64>()
        };
        let others = [
            energy(stiffness.ground, Combination::GROUND, x),
            -energy(stiffness.weights, Combination::WEIGHTS, x),
            energy(stiffness.mass, Combination::MASS, x),
        ];
        // All terms add up to 1, so the springs have the rest.
        let springs = 1.0 - others.iter().sum::<f64>();
        let gross = springs.abs() + others.iter().map(|term| term.abs()).sum::<f64>();
        // Motions at what ties to the ground are sums over all below: as if none of them cancelled.
        let all: Vec<f64> = x.iter().map(|x| x.abs()).collect();
        let ties = energy(stiffness.ground, Combination::GROUND, &all).abs();
        (gross - 1.0).max(0.0) + 2.0 * ties.sqrt()
    }

    fn start(&mut self, out: &mut [f64]) {
        match self.first {
            Some(first) => out.copy_from_slice(first),
            None => self.structure.start(self.work, out),
        }
    }
}
