//! Validation of the shapes in an ElastoDyn tower file against the modes of the tower.

use super::decimal::SUM_TOLERANCE;
use super::fit::trapezoidal;
use super::model::{ModelError, PlaneModes, TowerModel};
use super::polynomial::TowerPolynomial;
use super::shapes::{TowerShape, TowerShapes};
use crate::mac::mac;
use crate::verdict::Verdict;
use towermodes::tower::{Plane, Planes};

/// The limits of a validation: up to the first number a shape passes, up to the second it gets a
/// warning.
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
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ValidatedShape {
    /// The bending plane of the mode.
    pub plane: Plane,
    /// Number of the shape: 1 or 2.
    pub number: usize,
    /// Frequency of the mode of the tower with its rotor-nacelle assembly and foundation, Hz.
    pub mode_hz: f64,
    /// The sum of the coefficients; OpenFAST refuses a sum that differs from 1 by more than 0.0015.
    pub sum: f64,
    /// Root mean square over the height of the difference from the mode, as a fraction of the
    /// largest deflection of the mode. The shape is scaled for the smallest difference; if shapes
    /// were scaled to 1 at the top, the difference could be arbitrarily large for a mode whose top
    /// hardly moves.
    pub rms: f64,
    /// Rms error of the best polynomial.
    pub best_rms: f64,
    /// Rms error of the best combination of both shapes of the plane, because ElastoDyn superposes
    /// them.
    pub rms_of_both: f64,
    /// The ratio of `rms` to `best_rms`.
    pub rms_ratio: f64,
    /// Modal assurance criterion (Σab)²/(Σa² Σb²) with the mode.
    pub mac: f64,
    /// Frequency that ElastoDyn computes from the shape, for the tower without its rotor-nacelle
    /// assembly, Hz.
    pub implied_hz: f64,
    /// Implied frequency with the best polynomial, Hz.
    pub best_implied_hz: f64,
    /// The verdict on the shape.
    pub verdict: Verdict,
}

/// The validation of the four shapes of a tower file.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ShapeValidation {
    /// The worst verdict of all shapes.
    pub verdict: Verdict,
    /// First and second fore-aft shape, first and second side-side shape.
    pub shapes: [ValidatedShape; 4],
}

/// Validates the shapes of a tower file (`shipped`) against the modes of the tower (`own`).
///
/// # Errors
/// [`ModelError`] for values that ElastoDyn does not accept.
pub fn validate_shapes(
    model: &TowerModel,
    shipped: &Planes<PlaneModes>,
    own: &TowerShapes,
    limits: &ValidationLimits,
) -> Result<ShapeValidation, ModelError> {
    let implied_hz = |plane: Plane| -> Result<_, ModelError> {
        let modes = shipped.of(plane);
        let best = PlaneModes {
            shapes: own.polynomials(plane),
            ..modes
        };
        let alone_hz = |modes| Ok(model.generalized(plane, modes)?.frequency_alone_hz);
        Ok((alone_hz(&modes)?, alone_hz(&best)?))
    };
    let implied_hz = [implied_hz(Plane::ForeAft)?, implied_hz(Plane::SideSide)?];
    let shapes: [ValidatedShape; 4] = std::array::from_fn(|i| {
        let (shape, (shipped_hz, best_hz)) = (&own.shapes[i], implied_hz[i / 2]);
        let shapes = shipped.of(shape.plane).shapes;
        let mut validated = compared(shape, &shapes, i % 2);
        validated.implied_hz = shipped_hz[i % 2];
        validated.best_implied_hz = best_hz[i % 2];
        validated.verdict = validated.by(limits);
        validated
    });
    let worst = shapes.iter().map(|shape| shape.verdict).max();
    Ok(ShapeValidation {
        verdict: worst.unwrap_or(Verdict::Fail),
        shapes,
    })
}

/// A shape of a file compared with its mode; frequencies and verdict are set later.
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
    let left = |basis: &[&[f64]]| orthogonal_mean_square(&mode, basis, &weights).sqrt() / size;
    let (rms, best_rms) = (left(&[&file[number]]), left(&[&best]));
    ValidatedShape {
        plane: shape.plane,
        number: shape.number,
        mode_hz: shape.frequency_hz,
        sum: shapes[number].sum(),
        rms,
        best_rms,
        rms_of_both: left(&[&file[0], &file[1]]),
        rms_ratio: rms / best_rms,
        mac: mac(&mode, &file[number], None).unwrap_or(0.0),
        implied_hz: f64::NAN,
        best_implied_hz: f64::NAN,
        verdict: Verdict::Fail,
    }
}

/// The mean square of the component of a vector orthogonal to others, by the Gram-Schmidt process.
fn orthogonal_mean_square(vector: &[f64], basis: &[&[f64]], weights: &[f64]) -> f64 {
    let dot = |a: &[f64], b: &[f64]| -> f64 {
        let terms = a.iter().zip(b).zip(weights);
        terms.map(|((a, b), weight)| weight * a * b).sum()
    };
    let without = |mut vector: Vec<f64>, others: &[Vec<f64>]| {
        // Two passes are orthogonal to working precision.
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
    /// The verdict according to the limits.
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
