//! A frame as an eigenvalue problem.

use super::elimination::Factors;
use super::equations::{ELASTIC, Equations, GEOMETRIC, GROUND, INERTIA, KINDS};
use super::order::Order;
use super::product::Sweep;
use crate::eigen::{Pencil, ShiftInvert};

/// The pencil K − σ M, M of a frame for an origin σ (rad²/s²).
#[derive(Debug, Clone)]
pub(super) struct FramePencil {
    pub(super) equations: Equations,
    pub(super) order: Order,
    pub(super) origin: f64,
    factors: Factors,
    sweep: Sweep,
    product: Vec<f64>,
}

/// The coefficients of the matrices, and the coefficient of the stiffness of the coordinates.
type Coefficients = ([f64; KINDS], f64);

fn stiffness_minus(shift: f64) -> Coefficients {
    let mut factors = [0.0; KINDS];
    (factors[INERTIA], factors[GROUND]) = (-shift, 1.0);
    (factors[GEOMETRIC], factors[ELASTIC]) = (1.0, 1.0);
    (factors, 1.0)
}

fn mass() -> Coefficients {
    let mut factors = [0.0; KINDS];
    factors[INERTIA] = 1.0;
    (factors, 0.0)
}

impl FramePencil {
    pub(super) fn new(equations: Equations) -> Self {
        Self {
            order: Order::new(&equations),
            equations,
            origin: 0.0,
            factors: Factors::default(),
            sweep: Sweep::default(),
            product: Vec::new(),
        }
    }

    fn factorize_minus(&mut self, shift: f64) -> usize {
        let (factors, own) = stiffness_minus(shift);
        let a = (&factors, own);
        self.equations.factorize(&self.order, a, &mut self.factors)
    }

    /// The number of eigenvalues below λ, rad²/s², counted from zero and not from the origin.
    pub(super) fn count_below_lambda(&mut self, lambda: f64) -> usize {
        // A count overwrites the factors, so the next solve must factor again.
        let mut factors = std::mem::take(&mut self.factors);
        let (coefficients, own) = stiffness_minus(lambda);
        let a = (&coefficients, own);
        let mut scratch = Factors::default();
        let count = self.equations.factorize(&self.order, a, &mut scratch);
        std::mem::swap(&mut self.factors, &mut factors);
        count
    }

    fn times(&mut self, (factors, own): Coefficients, x: &[f64], out: &mut [f64]) {
        self.equations
            .product((&factors, own), &mut self.sweep, x, out);
    }

    fn energy(&mut self, a: Coefficients, x: &[f64]) -> f64 {
        let mut product = std::mem::take(&mut self.product);
        product.resize(x.len(), 0.0);
        self.times(a, x, &mut product);
        let energy = product.iter().zip(x).map(|(a, b)| a * b).sum();
        self.product = product;
        energy
    }
}

impl Pencil for FramePencil {
    fn size(&self) -> usize {
        self.equations.unknowns
    }

    fn mass_times(&mut self, x: &[f64], out: &mut [f64]) {
        self.times(mass(), x, out);
    }

    fn stiffness_times(&mut self, x: &[f64], out: &mut [f64]) {
        self.times(stiffness_minus(self.origin), x, out);
    }

    fn count_below(&mut self, shift: f64) -> usize {
        self.count_below_lambda(self.origin + shift)
    }

    fn factorize(&mut self) -> usize {
        self.factorize_minus(self.origin)
    }

    fn solve(&mut self, x: &mut [f64]) {
        self.equations.solve(&self.order, &mut self.factors, x);
    }

    fn stiffness_cancellation(&mut self, x: &[f64], _: &mut Vec<f64>) -> f64 {
        let (all, own) = stiffness_minus(self.origin);
        let none = [0.0; KINDS];
        let mut terms = vec![self.energy((none, own), x)];
        for kind in 0..KINDS {
            let mut factors = none;
            factors[kind] = all[kind];
            terms.push(self.energy((factors, 0.0), x));
        }
        let gross: f64 = terms.iter().map(|term| term.abs()).sum();
        (gross - 1.0).max(0.0)
    }

    fn start(&mut self, out: &mut [f64]) {
        self.equations.start(out);
    }
}

impl ShiftInvert for FramePencil {
    fn factorize_shifted(&mut self, shift: f64) -> usize {
        self.factorize_minus(self.origin + shift)
    }

    fn solve_shifted(&mut self, x: &mut [f64]) {
        self.solve(x);
    }

    fn energies(&mut self, x: &[f64]) -> [f64; 2] {
        [
            self.energy(stiffness_minus(self.origin), x),
            self.energy(mass(), x),
        ]
    }
}
