//! Derivatives of eigenvalues with the vectors held.

use super::NoDerivative;
use super::slope::{Bends, Derivatives, Slope, Slopes};
use super::step::{LARGE, RELATIVE, SHORTER, SMALL, is_linear, size_of};
use crate::parameter::Change;
use crate::solve::FrozenModes;
use crate::tower::{Motions, Neighbour, Neighbours, TowerDescription};

/// The factor by which a step is enlarged.
const ENLARGE: f64 = 30.0;
/// Largest number of enlargements.
const MOST_ENLARGEMENTS: usize = 8;

/// The ratio of the rounding error of a quotient to that of a sum of gradients.
const ROUGH: f64 = 10.0;

/// The fixed modes of a tower, with the memory to differentiate them.
pub(super) struct Held<'a> {
    neighbours: &'a Neighbours,
    frozen: &'a mut FrozenModes,
    /// The description that is changed.
    description: TowerDescription,
    quotients: Vec<Vec<f64>>,
}

/// The differences of quotients over one step.
struct Difference {
    slopes: Slopes,
    /// For each mode, the difference between the changes of its first eigenvalue in both
    /// directions.
    bends: Vec<f64>,
    mass_kg_per_unit: f64,
    /// The sets of motions that are coupled in the slightly changed towers.
    coupled: Vec<Motions>,
    /// The largest relative change of an eigenvalue on the modes' own mesh.
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

    pub(super) fn frozen(&self) -> &FrozenModes {
        self.frozen
    }

    /// The derivatives with respect to a change; none if it changes the structure of the tower.
    pub(super) fn derivatives(&mut self, change: &Change, value: f64) -> Option<Derivatives> {
        let size = size_of(change, value, self.neighbours);
        let mut h = RELATIVE * size;
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
        let mut half = self.difference(change, value, 0.5 * h)?;
        let modes = 0..self.frozen.modes.len();
        // Sums of stiffness and inertia have no kink.
        let may_kink = !is_linear(change);
        if may_kink
            && modes
                .clone()
                .any(|mode| self.is_kink(mode, &whole, &half, h))
        {
            // The kink may be near the value.
            h *= SHORTER;
            whole = self.difference(change, value, h)?;
            half = self.difference(change, value, 0.5 * h)?;
        }
        let derivatives = modes.map(|mode| {
            self.frozen.check(mode, &whole.coupled)?;
            if may_kink && self.is_kink(mode, &whole, &half, h) {
                return Err(NoDerivative::OneSided);
            }
            let of_mesh = |mesh: usize| {
                let lambda = self.frozen.meshes[mesh].lambdas[mode];
                let [whole, half] = [&whole, &half].map(|of| of.slopes[mesh][mode]);
                let mut slope = Slope::extrapolated(whole, half);
                slope.error += 8.0 * f64::EPSILON * lambda / h;
                slope
            };
            Ok(self.frozen.derivative(mode, size, of_mesh))
        });
        Some((derivatives.collect(), half.mass_kg_per_unit))
    }

    /// Whether the eigenvalue of a mode has a kink, from its changes over a step and over half the
    /// step.
    fn is_kink(&self, mode: usize, whole: &Difference, half: &Difference, h: f64) -> bool {
        let bends = Bends {
            whole: whole.bends[mode],
            half: half.bends[mode],
        };
        let lambda = ROUGH * self.frozen.meshes[0].lambdas[mode];
        bends.are_of_kink(half.slopes[0][mode] * h, lambda)
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
        let quotients = upper[0].iter().zip(&self.quotients[0]).zip(lambdas);
        let bends = quotients.map(|((upper, lower), own)| (upper - own) - (own - lower));
        Some(Difference {
            bends: bends.collect(),
            largest: changes.fold(0.0, |most, (s, lambda)| most.max((s * h / lambda).abs())),
            mass_kg_per_unit: (above.tower.structure_mass_kg() - below.tower.structure_mass_kg())
                / (2.0 * h),
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
        if !neighbour.slivers.is_empty() {
            return None;
        }
        let is_same = self
            .frozen
            .quotients(self.neighbours, &neighbour, quotients);
        let all = quotients.iter().flatten();
        (is_same && all.into_iter().all(|quotient| quotient.is_finite())).then_some(neighbour)
    }
}
