//! From the derivatives of eigenvalues on each mesh to that of a frequency.

use std::f64::consts::PI;

use super::{Derivative, NoDerivative};
use crate::modes::without_powers;
use crate::solve::{FrozenModes, ModeFrequency};
use crate::tower::Motions;

/// Modes whose eigenvalues differ by less, relatively, count as repeated.
const REPEATED: f64 = 1e-6;
/// The fraction of the difference between one step and its half that remains in the value
/// extrapolated from both, at least.
const REMAINDER: f64 = 0.01;
/// The fraction of the change by the last extrapolation from meshes that remains, at least.
const LEFT_OF_MESH: f64 = 0.1;
/// How many times as far as a frequency its derivative may be from that of the beam, relatively.
const DISTANCES: f64 = 10.0;
/// How fast these fractions grow with the relative difference.
const GROWTH: f64 = 100.0;

/// The derivatives of each mode, and that of the mass, kg per unit.
pub(super) type Derivatives = (Vec<Result<Derivative, NoDerivative>>, f64);

/// dλ/d(value) for each mesh and mode.
pub(super) type Slopes = Vec<Vec<f64>>;

/// A derivative of an eigenvalue, with its error from steps and rounding.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slope {
    pub(super) value: f64,
    pub(super) error: f64,
}

impl Slope {
    /// Of central differences over a step and over its half: their errors are quadratic in the
    /// step, that of the result is of fourth order.
    pub(super) fn extrapolated(whole: f64, half: f64) -> Self {
        let change = (half - whole) / 3.0;
        let value = half + change;
        Self {
            value,
            error: left_of(change, value, REMAINDER),
        }
    }
}

/// What is left of a change that removed the lowest power of an error from a value: if the change
/// is small relative to the value, the next power is smaller by as much.
fn left_of(change: f64, value: f64, least: f64) -> f64 {
    match change == 0.0 {
        true => 0.0,
        false => change.abs() * (GROWTH * (change / value).abs()).clamp(least, 1.0),
    }
}

impl FrozenModes {
    /// # Errors
    /// Why a mode has no derivative with respect to a change that couples these sets of motions.
    pub(super) fn check(&self, mode: usize, coupled: &[Motions]) -> Result<(), NoDerivative> {
        if self.modes[mode].frequency_hz == 0.0 {
            return Err(NoDerivative::AtRest);
        }
        match self.is_split(mode, coupled) {
            true => Err(NoDerivative::Repeated),
            false => Ok(()),
        }
    }

    /// The derivative of the frequency of a mode from those of its eigenvalue on each mesh.
    pub(super) fn derivative(&self, mode: usize, slope: impl Fn(usize) -> Slope) -> Derivative {
        let mut of_meshes = [0.0; MOST_MESHES];
        let (mut error, mut count) = (0.0_f64, 0);
        let powers = self.powers[mode];
        // One mesh more than the powers of the error need shows how well they are removed.
        let meshes = self.meshes.iter().take((powers.len() + 2).min(MOST_MESHES));
        for (index, mesh) in meshes.enumerate() {
            // df/dλ = 1/(8π² f) with f = √λ/2π.
            let per_lambda = 1.0 / (4.0 * PI * mesh.lambdas[mode].sqrt());
            let slope = slope(index);
            of_meshes[index] = slope.value * per_lambda;
            error = error.max(slope.error * per_lambda);
            count = index + 1;
        }
        let mesh_hz_per_unit = of_meshes[self.own.min(count - 1)];
        if count == 1 && !powers.is_empty() {
            // Without another mesh, as far as the frequency itself is from that of the beam.
            let ModeFrequency {
                frequency_hz,
                extrapolated_hz,
                ..
            } = self.modes[mode];
            let distance = 1.0 - extrapolated_hz / frequency_hz;
            error += DISTANCES * (distance * mesh_hz_per_unit).abs();
        }
        let is_regular = !self.irregular.contains(&mode);
        let (hz_per_unit, of_mesh) = extrapolated(&of_meshes[..count], powers, is_regular);
        Derivative {
            hz_per_unit,
            error_hz_per_unit: error + of_mesh,
            mesh_hz_per_unit,
        }
    }

    /// Whether a change that couples these sets of motions splits a mode from one of its frequency.
    fn is_split(&self, mode: usize, coupled: &[Motions]) -> bool {
        let lambdas = &self.meshes[0].lambdas;
        let motions = &self.motions;
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

/// More meshes than any mode has.
const MOST_MESHES: usize = 4;

/// The value without the powers of the error, and the error that is left: from meshes that halve
/// each other's segments.
fn extrapolated(of_meshes: &[f64], powers: &[i32], is_regular: bool) -> (f64, f64) {
    let own = of_meshes[0];
    let Some(&lowest) = powers.first() else {
        return (own, 0.0);
    };
    let needed = powers.len() + 1;
    if of_meshes.len() < needed {
        let coarser = of_meshes.get(1).unwrap_or(&own);
        return (own, (own - coarser).abs());
    }
    let from = |first: usize| {
        let mut values = [0.0; MOST_MESHES];
        let values = &mut values[..needed];
        values.copy_from_slice(&of_meshes[first..first + needed]);
        without_powers(values, powers)
    };
    let (value, last_change) = from(0);
    if of_meshes.len() == needed {
        let error = match is_regular {
            true => left_of(last_change, value, LEFT_OF_MESH),
            false => last_change.abs(),
        };
        return (value, error);
    }
    // What is left decreases at least as fast as the first power that was removed.
    let spread = (value - from(1).0).abs();
    (value, spread * 2.0_f64.powi(-lowest))
}
