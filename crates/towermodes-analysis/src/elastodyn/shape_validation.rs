//! Validation of the shapes in an ElastoDyn tower file against the modes of the tower.

use super::decimal::SUM_TOLERANCE;
use super::fit::trapezoidal;
use super::model::{ModelError, PlaneModes, TowerModel};
use super::polynomial::TowerPolynomial;
use super::shapes::{TowerShape, TowerShapes};
use crate::mac::mac;
use crate::verdict::Verdict;
use towermodes::tower::{Plane, Planes};

/// The limits of a validation: up to the first number a shape passes, up to the second it warns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ValidationLimits {
    /// Root mean square of the difference, as a fraction of the largest deflection of the shape.
    pub rms: [f64; 2],
    /// 1 − MAC.
    pub mac: [f64; 2],
    /// Relative difference of the frequencies that ElastoDyn computes from the shapes.
    pub frequency: [f64; 2],
}

impl Default for ValidationLimits {
    fn default() -> Self {
        Self {
            rms: [0.01, 0.05],
            mac: [0.001, 0.01],
            frequency: [0.01, 0.05],
        }
    }
}

/// A shape of a tower file compared with the mode of the tower.
#[derive(Debug, Clone, PartialEq)]
pub struct ValidatedShape {
    /// The plane it bends in.
    pub plane: Plane,
    /// 1 or 2.
    pub number: usize,
    /// Frequency of the tower's own mode, with all that it carries and stands on, Hz.
    pub mode_hz: f64,
    /// What the coefficients add up to; OpenFAST refuses what is farther than 0.0015 from 1.
    pub sum: f64,
    /// Root of the mean square over the height of the difference to the mode, as a share of the
    /// mode's largest deflection, the shape being multiplied by what makes it least: a top that
    /// hardly moves would make the difference of shapes that are 1 there as large as one likes.
    pub rms: f64,
    /// The same of the best polynomial.
    pub best_rms: f64,
    /// The same of what both shapes of the plane together cannot follow: ElastoDyn mixes them.
    pub rms_of_both: f64,
    /// Modal assurance criterion (Σab)²/(Σa² Σb²) with the mode.
    pub mac: f64,
    /// Frequency that ElastoDyn makes of the shape, of the tower without what it carries, Hz.
    pub implied_hz: f64,
    /// The same of the best polynomial.
    pub best_implied_hz: f64,
    /// Whether it passes.
    pub verdict: Verdict,
}

impl ValidatedShape {
    /// How many times as far off as the best polynomial.
    pub fn rms_ratio(&self) -> f64 {
        self.rms / self.best_rms
    }
}

/// Judges the shapes of a tower file by the tower's own. `shipped` has what the file says of each
/// plane.
///
/// # Errors
/// [`ModelError`] for what ElastoDyn cannot take.
pub fn validate_shapes(
    model: &TowerModel,
    shipped: &Planes<PlaneModes>,
    own: &TowerShapes,
    limits: &ValidationLimits,
) -> Result<[ValidatedShape; 4], ModelError> {
    let implied = |plane: Plane| -> Result<_, ModelError> {
        let modes = shipped.of(plane);
        let best = PlaneModes {
            shapes: own.polynomials(plane),
            ..modes
        };
        let frequencies = |modes: &PlaneModes| {
            let of_modes = model.generalized(plane, modes);
            of_modes.map(|quantities| quantities.frequency_alone_hz)
        };
        Ok((frequencies(&modes)?, frequencies(&best)?))
    };
    let implied = [implied(Plane::ForeAft)?, implied(Plane::SideSide)?];
    Ok(std::array::from_fn(|i| {
        let (shape, (shipped_hz, best_hz)) = (&own.shapes[i], implied[i / 2]);
        let shapes = shipped.of(shape.plane).shapes;
        let mut judgement = compared(shape, &shapes, i % 2);
        judgement.implied_hz = shipped_hz[i % 2];
        judgement.best_implied_hz = best_hz[i % 2];
        judgement.verdict = judgement.by(limits);
        judgement
    }))
}

/// A shape of a file beside its mode; frequencies and verdict are still missing.
fn compared(shape: &TowerShape, shapes: &[TowerPolynomial; 2], number: usize) -> ValidatedShape {
    let points: Vec<(f64, f64)> = shape.samples.bent().collect();
    let mode: Vec<f64> = points.iter().map(|(_, w)| *w).collect();
    let sampled = |polynomial: &TowerPolynomial| -> Vec<f64> {
        points.iter().map(|(x, _)| polynomial.value(*x)).collect()
    };
    let file = shapes.map(|polynomial| sampled(&polynomial));
    let best = sampled(&shape.fit.polynomial);
    let weights = trapezoidal(&points);
    let size = (shape.fit.largest_deflection * shape.fit.tip_deflection).abs();
    let left = |basis: &[&[f64]]| what_is_left(&mode, basis, &weights).sqrt() / size;
    ValidatedShape {
        plane: shape.plane,
        number: shape.number,
        mode_hz: shape.frequency_hz,
        sum: shapes[number].sum(),
        rms: left(&[&file[number]]),
        best_rms: left(&[&best]),
        rms_of_both: left(&[&file[0], &file[1]]),
        mac: mac(&mode, &file[number], None).unwrap_or(0.0),
        implied_hz: f64::NAN,
        best_implied_hz: f64::NAN,
        verdict: Verdict::Fail,
    }
}

/// The mean square of what is left of a vector without its parts along others, by Gram and Schmidt.
fn what_is_left(vector: &[f64], basis: &[&[f64]], weights: &[f64]) -> f64 {
    let dot = |a: &[f64], b: &[f64]| -> f64 {
        let terms = a.iter().zip(b).zip(weights);
        terms.map(|((a, b), weight)| weight * a * b).sum()
    };
    let without = |mut vector: Vec<f64>, others: &[Vec<f64>]| {
        // Twice is enough.
        for other in others.iter().chain(others) {
            let share = dot(&vector, other) / dot(other, other);
            if share.is_finite() {
                vector
                    .iter_mut()
                    .zip(other)
                    .for_each(|(v, o)| *v -= share * o);
            }
        }
        vector
    };
    let mut orthogonal: Vec<Vec<f64>> = Vec::with_capacity(basis.len());
    for vector in basis {
        let next = without(vector.to_vec(), &orthogonal);
        orthogonal.push(next);
    }
    let left = without(vector.to_vec(), &orthogonal);
    dot(&left, &left)
}

impl ValidatedShape {
    /// The worst of what its numbers say.
    fn by(&self, limits: &ValidationLimits) -> Verdict {
        if (self.sum - 1.0).abs() > SUM_TOLERANCE {
            return Verdict::Fail;
        }
        let frequency = (self.implied_hz / self.best_implied_hz - 1.0).abs();
        let measured = [
            (self.rms, limits.rms),
            (1.0 - self.mac, limits.mac),
            (frequency, limits.frequency),
        ];
        let within = |which: usize| measured.iter().all(|(value, limit)| *value <= limit[which]);
        if within(0) {
            Verdict::Pass
        } else if within(1) {
            Verdict::Warn
        } else {
            Verdict::Fail
        }
    }
}
