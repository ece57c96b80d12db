//! A subsystem as an eigenvalue problem.

use super::{Coefficients, Subsystem};
use crate::eigen::{Pencil, ShiftInvert};
use crate::lanes::LANES;

/// Of which two matrices the eigenvalues are sought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Eigenproblem {
    /// (K − σM) u = (λ − σ) M u for an origin σ.
    Vibration {
        /// σ, rad²/s².
        origin: f64,
    },
    /// K u = μ (−G) u: the structure of stiffness K buckles at μ times its self-weight.
    Buckling,
}

impl Eigenproblem {
    fn stiffness(self) -> Coefficients {
        match self {
            Self::Vibration { origin } => Coefficients::STIFFNESS.minus(origin, Coefficients::MASS),
            Self::Buckling => Coefficients::ELASTIC,
        }
    }

    fn mass(self) -> Coefficients {
        match self {
            Self::Vibration { .. } => Coefficients::MASS,
            Self::Buckling => Coefficients::GRAVITY,
        }
    }
}

/// An observer of the products with the mass matrix.
pub trait ProductObserver {
    /// Called after each product.
    fn count_product(&mut self);
}

/// A subsystem as the eigensolver sees it.
pub struct SubsystemPencil<'a> {
    subsystem: &'a mut dyn Subsystem,
    stiffness: Coefficients,
    mass: Coefficients,
    stiffness_is_identity: bool,
    start: Option<&'a [f64]>,
    observer: Option<&'a mut dyn ProductObserver>,
}

impl<'a> SubsystemPencil<'a> {
    /// An eigenvalue problem of a subsystem.
    pub fn new(subsystem: &'a mut dyn Subsystem, problem: Eigenproblem) -> Self {
        let stiffness = problem.stiffness();
        Self {
            stiffness_is_identity: subsystem.is_identity(&stiffness),
            subsystem,
            stiffness,
            mass: problem.mass(),
            start: None,
            observer: None,
        }
    }

    /// The same problem with this starting vector, if it is given, instead of the starting vector
    /// of the subsystem.
    #[must_use]
    pub fn starting_from(self, start: Option<&'a [f64]>) -> Self {
        Self { start, ..self }
    }

    /// The same problem, with an observer that counts its products.
    #[must_use]
    pub fn observed_by(self, observer: Option<&'a mut dyn ProductObserver>) -> Self {
        Self { observer, ..self }
    }
}

impl Pencil for SubsystemPencil<'_> {
    fn size(&self) -> usize {
        self.subsystem.degrees_of_freedom()
    }

    fn stiffness_is_identity(&self) -> bool {
        self.stiffness_is_identity
    }

    fn mass_times(&mut self, x: &[f64], out: &mut [f64]) {
        self.subsystem.product(&self.mass, x, out);
        if let Some(observer) = &mut self.observer {
            observer.count_product();
        }
    }

    fn stiffness_times(&mut self, x: &[f64], out: &mut [f64]) {
        if self.stiffness_is_identity {
            out.copy_from_slice(x);
        } else {
            self.subsystem.product(&self.stiffness, x, out);
        }
    }

    fn count_below(&mut self, shift: f64) -> usize {
        let shifted = self.stiffness.minus(shift, self.mass);
        self.subsystem.count_negative(&shifted)
    }

    fn factorize(&mut self) -> usize {
        if self.stiffness_is_identity {
            return 0;
        }
        self.subsystem.factorize(&self.stiffness)
    }

    fn solve(&mut self, x: &mut [f64]) {
        if !self.stiffness_is_identity {
            self.subsystem.solve(x);
        }
    }

    fn stiffness_cancellation(&mut self, x: &[f64], scratch: &mut Vec<f64>) -> f64 {
        if self.stiffness_is_identity {
            return 0.0;
        }
        let stiffness = self.stiffness;
        let energies = self.subsystem.energies(x);
        let others = [
            stiffness.foundation * energies.foundation,
            -stiffness.geometric * energies.gravity,
            stiffness.mass * energies.mass,
        ];
        // All terms add up to 1, so the rest is in the joints or elements.
        let own = 1.0 - others.iter().sum::<f64>();
        let gross = own.abs() + others.iter().map(|term| term.abs()).sum::<f64>();
        // The motion of a tied point is a sum over all points below it: cancellation is neglected.
        let ties = match stiffness.foundation {
            0.0 => 0.0,
            factor => {
                scratch.clear();
                scratch.extend(x.iter().map(|x| x.abs()));
                factor * self.subsystem.energy(&Coefficients::FOUNDATION, scratch)
            }
        };
        (gross - 1.0).max(0.0) + 2.0 * ties.abs().sqrt()
    }

    fn start(&mut self, out: &mut [f64]) {
        match self.start {
            Some(start) => out.copy_from_slice(start),
            None => self.subsystem.start(out),
        }
    }
}

impl ShiftInvert for SubsystemPencil<'_> {
    fn factorize_shifted(&mut self, shift: f64) -> usize {
        let shifted = self.stiffness.minus(shift, self.mass);
        self.subsystem.factorize(&shifted)
    }

    fn solve_shifted(&mut self, x: &mut [f64]) {
        self.subsystem.solve(x);
    }

    fn energies(&mut self, x: &[f64]) -> [f64; 2] {
        let energies = self.subsystem.energies(x);
        [&self.stiffness, &self.mass].map(|matrix| energies.of(matrix))
    }

    fn fused_step(&mut self, shift: Option<f64>, x: &mut [f64]) -> Option<(usize, [f64; 2])> {
        if self.mass != Coefficients::MASS {
            return None;
        }
        let shifted = shift.map(|shift| self.stiffness.minus(shift, self.mass));
        let (count, energies) = self.subsystem.inverse_step(shifted.as_ref(), x)?;
        if let Some(observer) = &mut self.observer {
            observer.count_product();
        }
        let of = |matrix| energies.of(matrix);
        Some((count, [&self.stiffness, &self.mass].map(of)))
    }

    fn inverse_steps(
        &mut self,
        shifts: &[f64; LANES],
        x: [Option<&mut [f64]>; LANES],
    ) -> Option<[(usize, [f64; 2]); LANES]> {
        if self.mass != Coefficients::MASS {
            return None;
        }
        let moved = x.iter().flatten().count();
        let shifted = shifts.map(|shift| self.stiffness.minus(shift, self.mass));
        let steps = self.subsystem.inverse_steps(&shifted, x)?;
        if let Some(observer) = &mut self.observer {
            (0..moved).for_each(|_| observer.count_product());
        }
        let both = [&self.stiffness, &self.mass];
        Some(steps.map(|(count, energies)| (count, both.map(|matrix| energies.of(matrix)))))
    }
}
