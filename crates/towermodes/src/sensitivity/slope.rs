//! From the derivatives of eigenvalues on each mesh to the derivative of a frequency.

use std::f64::consts::PI;

use super::{Derivative, NoDerivative};
use crate::modes::without_powers;
use crate::solve::{FrozenModes, ModeFrequency};
use crate::tower::Motions;

/// Modes whose eigenvalues have a smaller relative difference are treated as repeated.
const REPEATED: f64 = 1e-6;
/// Lower bound of the remaining error of the value extrapolated from one step and its half, as a
/// fraction of their difference.
const REMAINDER: f64 = 0.01;
/// Lower bound of the remaining error after the last extrapolation from meshes, as a fraction of
/// its change.
const LEFT_OF_MESH: f64 = 0.1;
/// Largest ratio of the relative error of a derivative to that of its frequency.
const DISTANCES: f64 = 10.0;
/// What meshes leave of a derivative, by the square of the fraction δ by which the next coarser one
/// changes the frequency, and at least: relative to the frequency over the size of the value. A
/// small last change may be a small sum of large ones, so it alone does not tell. Of
/// 10 602 derivatives of random towers 5 have more than three times the stated error.
const OF_SQUARE: f64 = 30.0;
const OF_CHANCE: f64 = 1e-7;
/// How fast these fractions grow with the relative difference.
const GROWTH: f64 = 100.0;

/// If the slopes on both sides have a smaller relative difference, there is no kink.
const SMOOTH: f64 = 1e-6;
/// At a kink their difference exceeds this fraction of the change of the slope over a step by
/// curvature.
const CURVED: f64 = 0.03;
/// Relative rounding error of an eigenvalue.
const ROUNDING: f64 = 1e-11;

/// The derivatives of each mode, and that of the mass, kg per unit.
pub(super) type Derivatives = (Vec<Result<Derivative, NoDerivative>>, f64);

/// dλ/d(value) for each mesh and mode.
pub(super) type Slopes = Vec<Vec<f64>>;

/// The differences between the changes of an eigenvalue in both directions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bends {
    /// For a step.
    pub(super) whole: f64,
    /// For half of the step.
    pub(super) half: f64,
}

impl Bends {
    /// Whether these differences indicate a kink, for a step that changes the eigenvalue λ by this
    /// amount.
    pub(super) fn are_of_kink(self, change: f64, lambda: f64) -> bool {
        // A curvature causes four times the difference for the whole step, a kink twice the
        // difference.
        let kink = (4.0 * self.half - self.whole).abs();
        let is_large = kink > SMOOTH * change.abs() && kink > ROUNDING * lambda;
        is_large && kink > CURVED * self.whole.abs()
    }
}

/// A derivative of an eigenvalue, with its error from steps and rounding.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slope {
    pub(super) value: f64,
    pub(super) error: f64,
}

impl Slope {
    /// The slope from central differences over a step and over its half: their errors are quadratic
    /// in the step, the error of the result is of fourth order.
    pub(super) fn extrapolated(whole: f64, half: f64) -> Self {
        let change = (half - whole) / 3.0;
        let value = half + change;
        Self {
            value,
            error: left_of(change, value, REMAINDER),
        }
    }
}

/// Estimate of the remaining error after a change that removed the lowest power of an error from a
/// value: if the change is small relative to the value, the next power is smaller by the same
/// factor.
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

    /// The derivative of the frequency of a mode, with respect to a value of a size, from those of
    /// its eigenvalue on each mesh.
    pub(super) fn derivative(
        &self,
        mode: usize,
        size: f64,
        slope: impl Fn(usize) -> Slope,
    ) -> Derivative {
        let mut of_meshes = [0.0; MOST_MESHES];
        let (mut error, mut count) = (0.0_f64, 0);
        let powers = self.powers[mode];
        // One mesh more than the number of powers shows how well they are removed.
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
            // Without another mesh, the error relative to the beam is that of the frequency.
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
            error_hz_per_unit: error + of_mesh + self.left_by_chance(mode, size),
            mesh_hz_per_unit,
        }
    }

    /// Remaining mesh error of a derivative even if it hardly changes from one mesh to the next, Hz
    /// per unit of a value of this size.
    fn left_by_chance(&self, mode: usize, size: f64) -> f64 {
        let [own, coarser, ..] = &self.meshes[..] else {
            return 0.0;
        };
        let Some(&lowest) = self.powers[mode].first() else {
            return 0.0;
        };
        let change = (coarser.lambdas[mode] / own.lambdas[mode]).sqrt() - 1.0;
        let left = change / (2.0_f64.powi(lowest) - 1.0);
        let relative = OF_SQUARE * left * left + OF_CHANCE;
        relative * self.modes[mode].frequency_hz / size
    }

    /// Whether a change that couples these sets of motions separates a mode from another mode of
    /// the same frequency.
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

/// Limit of the number of meshes of a mode.
const MOST_MESHES: usize = 4;

/// The value without the powers of the error, and the remaining error, from meshes with halved
/// segments.
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
    // The remaining error decreases at least as fast as the first power that was removed.
    let spread = (value - from(1).0).abs();
    (value, spread * 2.0_f64.powi(-lowest))
}
