//! Derivatives of eigenvalues with the vectors held.

use super::step::{LARGE, SMALL, is_linear, step};
use super::{Derivative, NoDerivative};
use crate::modes::without_powers;
use crate::parameter::Change;
use crate::solve::{FrozenModes, ModeFrequency};
use crate::tower::{Motions, Neighbour, Neighbours, TowerDescription};

/// Modes whose eigenvalues differ by less, relatively, count as repeated.
const REPEATED: f64 = 1e-6;
/// The factor by which a step is enlarged.
const ENLARGE: f64 = 30.0;
/// How often it is enlarged at most.
const MOST_ENLARGEMENTS: usize = 8;

/// The derivatives of each mode, and that of the mass, kg per unit.
pub(super) type Derivatives = (Vec<Result<Derivative, NoDerivative>>, f64);

/// The held modes of a tower with the memory to differentiate them.
pub(super) struct Held<'a> {
    neighbours: &'a Neighbours,
    frozen: &'a mut FrozenModes,
    /// The description that is changed.
    description: TowerDescription,
    quotients: Vec<Vec<f64>>,
}

/// The differences of quotients over one step: d(λ)/d(value) for each mesh and mode.
struct Difference {
    slopes: Vec<Vec<f64>>,
    mass_kg_per_unit: f64,
    /// The sets of motions that are coupled on the neighbours.
    coupled: Vec<Motions>,
    /// The largest change of an eigenvalue of the modes' own mesh, relatively.
    largest: f64,
}

impl<'a> Held<'a> {
    pub(super) fn new(neighbours: &'a Neighbours, frozen: &'a mut FrozenModes) -> Self {
        Self {
            description: neighbours.description().clone(),
            neighbours,
            frozen,
            quotients: Vec::new(),
        }
    }

    pub(super) fn modes(&self) -> &[ModeFrequency] {
        &self.frozen.modes
    }

    /// The derivatives with respect to a change; none if it changes the structure of the tower.
    pub(super) fn derivatives(&mut self, change: &Change, value: f64) -> Option<Derivatives> {
        let mut h = step(change, value, self.neighbours.tower());
        let mut whole = self.difference(change, value, h)?;
        if is_linear(change) {
            for _ in 0..MOST_ENLARGEMENTS {
                if whole.largest >= SMALL {
                    break;
                }
                let wanted = (0.1 * LARGE / whole.largest).clamp(ENLARGE, ENLARGE.powi(3));
                let Some(larger) = self.difference(change, value, h * wanted) else {
                    break;
                };
                if larger.largest > 100.0 * LARGE {
                    break;
                }
                (h, whole) = (h * wanted, larger);
            }
        }
        let half = self.difference(change, value, 0.5 * h)?;
        let modes = 0..self.frozen.modes.len();
        let derivatives = modes.map(|mode| self.derivative(mode, h, &whole, &half));
        Some((derivatives.collect(), half.mass_kg_per_unit))
    }

    /// The central difference of every quotient over a step.
    fn difference(&mut self, change: &Change, value: f64, h: f64) -> Option<Difference> {
        let above = self.quotients_at(change, value + h)?;
        let upper = self.quotients.clone();
        let below = self.quotients_at(change, value - h)?;
        let slope = |(upper, lower): (&f64, &f64)| (upper - lower) / (2.0 * h);
        let meshes = upper.iter().zip(&self.quotients);
        let slopes: Vec<Vec<f64>> = meshes
            .map(|(upper, lower)| upper.iter().zip(lower).map(slope).collect())
            .collect();
        let lambdas = &self.frozen.meshes[0].lambdas;
        let changes = slopes[0].iter().zip(lambdas);
        let changes = changes.filter(|(_, lambda)| **lambda > 0.0);
        Some(Difference {
            largest: changes.fold(0.0, |most, (s, lambda)| most.max((s * h / lambda).abs())),
            mass_kg_per_unit: (above.tower.mass_kg() - below.tower.mass_kg()) / (2.0 * h),
            coupled: above.coupled,
            slopes,
        })
    }

    /// Computes the quotients at a value of a change.
    fn quotients_at(&mut self, change: &Change, value: f64) -> Option<Neighbour> {
        self.description.clone_from(self.neighbours.description());
        change.apply(&mut self.description, value);
        let neighbour = self.neighbours.near(&self.description)?;
        let quotients = &mut self.quotients;
        let is_same = self
            .frozen
            .quotients(self.neighbours, &neighbour, quotients);
        let all = quotients.iter().flatten();
        (is_same && all.into_iter().all(|quotient| quotient.is_finite())).then_some(neighbour)
    }

    /// The derivative of a mode from differences over a step h and its half.
    fn derivative(
        &self,
        mode: usize,
        h: f64,
        whole: &Difference,
        half: &Difference,
    ) -> Result<Derivative, NoDerivative> {
        let frequency = &self.frozen.modes[mode];
        if frequency.frequency_hz == 0.0 {
            return Err(NoDerivative::AtRest);
        }
        if self.is_split(mode, &whole.coupled) {
            return Err(NoDerivative::Repeated);
        }
        let mut of_meshes = Vec::with_capacity(self.frozen.meshes.len());
        let mut error = 0.0_f64;
        let slopes = whole.slopes.iter().zip(&half.slopes);
        for (mesh, (whole, half)) in self.frozen.meshes.iter().zip(slopes) {
            let lambda = mesh.lambdas[mode];
            // df/dλ = 1/(8π² f) with f = √λ/2π.
            let per_lambda = 1.0 / (4.0 * std::f64::consts::PI * lambda.sqrt());
            let better = half[mode] + (half[mode] - whole[mode]) / 3.0;
            of_meshes.push(better * per_lambda);
            let rounding = 8.0 * f64::EPSILON * lambda / h;
            let of_step = (better - half[mode]).abs().max(rounding);
            error = error.max(of_step * per_lambda);
        }
        let mesh_hz_per_unit = of_meshes[0];
        let powers = self.frozen.powers[mode];
        let needed = powers.len() + 1;
        if of_meshes.len() < needed {
            let coarser = of_meshes.get(1).unwrap_or(&mesh_hz_per_unit);
            error += (mesh_hz_per_unit - coarser).abs();
            of_meshes.truncate(1);
        }
        of_meshes.truncate(needed);
        let used = &powers[..powers.len().min(of_meshes.len() - 1)];
        let (hz_per_unit, last_change) = without_powers(&mut of_meshes, used);
        Ok(Derivative {
            hz_per_unit,
            error_hz_per_unit: error
                + if used.len() > 1 {
                    last_change.abs()
                } else {
                    0.0
                },
            mesh_hz_per_unit,
        })
    }

    /// Whether a change that couples these sets of motions splits a mode from one of its frequency.
    fn is_split(&self, mode: usize, coupled: &[Motions]) -> bool {
        let lambdas = &self.frozen.meshes[0].lambdas;
        let motions = &self.frozen.motions;
        let are_coupled = |a: Motions, b: Motions| {
            let set = coupled
                .iter()
                .find(|set| a.iter().any(|motion| set.contains(motion)));
            set.is_some_and(|set| b.iter().any(|motion| set.contains(motion)))
        };
        (0..lambdas.len()).any(|other| {
            let distance = (lambdas[other] - lambdas[mode]).abs();
            other != mode
                && distance <= REPEATED * lambdas[mode].abs()
                && are_coupled(motions[mode], motions[other])
        })
    }
}
