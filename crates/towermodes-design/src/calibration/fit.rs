//! Weighted least squares by the method of Levenberg and Marquardt.

use towermodes::ModeName;
use towermodes::number::Rounded;

use super::determined::{Undetermined, undetermined};
use super::error::CalibrationError;
use super::point::{LARGE_RESIDUAL, Point, Towers};
use super::singular::Singular;
use super::variable::Variable;

/// Largest number of iterations.
const MOST_ITERATIONS: usize = 200;
/// The iteration ends when the expected decrease of the sum of squares by a step is smaller than
/// this.
///
/// Its root is the length of the step in standard deviations.
const SMALL_GAIN: f64 = 1e-10;
/// The first damping, relative to the largest singular value squared.
const FIRST_DAMPING: f64 = 1e-3;
/// With a damping below this, a step is equal to a Gauss–Newton step up to rounding.
const LEAST_DAMPING: f64 = 1e-15;
/// Above this damping no step improves anything.
const MOST_DAMPING: f64 = 1e14;
/// At a solution the undamped step decreases the sum of squares by less than this, relative to
/// 1 + the sum of squares.
const STATIONARY: f64 = 1e-6;
/// A residual has a jump if it changes by more than this in the last rejected step.
const JUMP: f64 = 1e-3;
/// No logarithm moves by more than this in one step.
const LONGEST_STEP: f64 = 1.5;

/// The fit.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Found {
    pub(super) point: Point,
    /// For each unknown, whether it is not at a bound.
    pub(super) is_free: Vec<bool>,
    /// Whether at least one measured frequency changes with each unknown, possibly only to second
    /// order.
    pub(super) has_effect: Vec<bool>,
    pub(super) iterations: usize,
}

impl Towers<'_> {
    /// The fit that ends at a point.
    fn found(
        &self,
        point: Point,
        is_free: Vec<bool>,
        iterations: usize,
    ) -> Result<Found, CalibrationError> {
        let undetermined = undetermined(&point, self.variables, (&is_free, &self.has_effect));
        let residuals = point.residuals.iter().take(self.names.len());
        let residuals = residuals.map(|residual| residual.abs()).enumerate();
        let worst = residuals.max_by(|a, b| a.1.total_cmp(&b.1));
        let worst = worst.filter(|(_, residual)| *residual > LARGE_RESIDUAL);
        if let Some((index, _)) = worst {
            self.check_bounds(&point, &is_free, index)?;
        }
        let values = || values_at(self.variables, &point.x);
        match (undetermined, worst) {
            (None, _) => Ok(Found {
                point,
                is_free,
                has_effect: self.has_effect.clone(),
                iterations,
            }),
            (Some(Undetermined::NoSize(names)), _) => Err(CalibrationError::NoSize {
                names,
                values: values(),
            }),
            // A frequency that cannot be reached drives an unknown to where it has no effect.
            (Some(_), Some((index, _))) => Err(CalibrationError::Unreachable {
                index,
                mode: self.names[index],
                measured_hz: self.problem.measured[index].frequency_hz,
                nearest_hz: point.frequencies_hz[index],
                values: values(),
            }),
            (
                Some(Undetermined::NoEffect {
                    names,
                    is_stationary,
                }),
                None,
            ) => Err(CalibrationError::NoEffect {
                names,
                is_stationary,
                values: values(),
            }),
            (Some(Undetermined::Dependent(names)), None) => {
                Err(CalibrationError::Undetermined { names })
            }
        }
    }

    /// Refuses a fit in which every unknown is at a bound and bounds of the problem keep a
    /// frequency away from its measurement: nothing was fitted. The condition that a mass is not
    /// negative is not such a bound.
    fn check_bounds(
        &self,
        point: &Point,
        is_free: &[bool],
        index: usize,
    ) -> Result<(), CalibrationError> {
        let held = point.held_by(self.variables, index);
        let is_given = |(j, _): &(usize, _)| self.problem.unknowns[*j].bounds.is_some();
        if !held.iter().any(is_given) || is_free.contains(&true) {
            return Ok(());
        }
        let bounds = held.iter().map(|&(j, bound)| {
            let variable = &self.variables[j];
            let value = Rounded(variable.value(point.x[j]));
            format!("the {bound} bound {value} of {}", variable.change.name())
        });
        let bounds: Vec<String> = bounds.collect();
        Err(CalibrationError::OutsideBounds {
            index,
            mode: self.names[index],
            measured_hz: self.problem.measured[index].frequency_hz,
            nearest_hz: point.frequencies_hz[index],
            bounds: bounds.join(" and "),
        })
    }

    /// Refuses a point that is no minimum: the sum of squares would decrease further, but two modes
    /// exchange their names there, and the frequency with a measured name jumps. `rejected` is the
    /// last rejected point, beyond the exchange.
    fn check_jump(&self, point: &Point, rejected: Option<&Point>) -> Result<(), CalibrationError> {
        let Some(beyond) = rejected else {
            return Ok(());
        };
        let jump = |index: &usize| (point.residuals[*index] - beyond.residuals[*index]).abs();
        let largest = (0..self.names.len()).max_by(|a, b| jump(a).total_cmp(&jump(b)));
        let Some(index) = largest.filter(|index| jump(index) > JUMP) else {
            return Ok(());
        };
        let (mode, jump_hz) = (
            self.names[index],
            [point, beyond].map(|point| point.frequencies_hz[index]),
        );
        // The mode that the name passes to has another name on this side.
        let distance = |of: &&(ModeName, f64)| (of.1 - jump_hz[1]).abs();
        let others = point.modes.iter().filter(|(name, _)| *name != mode);
        let other = others.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        Err(CalibrationError::Exchanged {
            index,
            mode,
            other: other.map_or(mode, |(name, _)| *name),
            measured_hz: self.problem.measured[index].frequency_hz,
            jump_hz,
            values: values_at(self.variables, &point.x),
        })
    }
}

/// The unknowns with their values at coordinates.
fn values_at(variables: &[Variable], x: &[f64]) -> String {
    let values = variables.iter().zip(x).map(|(variable, x)| {
        let digits = format!("{:.3e}", variable.value(*x));
        let value = Rounded(digits.parse().unwrap_or(variable.value(*x)));
        format!("{} = {value}", variable.change.name())
    });
    values.collect::<Vec<_>>().join(", ")
}

/// The point with the least sum of squares.
pub(super) fn fit(towers: &mut Towers<'_>, start: &[f64]) -> Result<Found, CalibrationError> {
    let variables = towers.variables;
    let mut point = towers.evaluate(start)?;
    let mut damping = FIRST_DAMPING;
    let mut rejected = None;
    for iterations in 0..MOST_ITERATIONS {
        let is_free = point.free(variables);
        let units = point.units(variables);
        let singular = Singular::of(point.scaled(&units, &is_free));
        let largest = singular.values.first().copied().unwrap_or(0.0);
        let mut last_error = None;
        let along = |point: &Point, damping: f64| {
            let absolute = damping * largest * largest;
            step(point, (variables, &units), &is_free, &singular, absolute)
        };
        loop {
            let (x, gain) = along(&point, damping);
            let is_end = gain <= SMALL_GAIN * (1.0 + point.chi_square());
            if is_end || x == point.x || damping > MOST_DAMPING {
                // No shorter step leads to a possible tower.
                if let Some(error) = last_error {
                    return Err(error);
                }
                let (_, gain) = along(&point, LEAST_DAMPING);
                if gain > STATIONARY * (1.0 + point.chi_square()) {
                    towers.check_jump(&point, rejected.as_ref())?;
                }
                return towers.found(point, is_free, iterations);
            }
            match towers.evaluate(&x) {
                Ok(next) if next.chi_square() < point.chi_square() => {
                    // Nielsen 1999: less damping where the linearization is right.
                    let ratio = (point.chi_square() - next.chi_square()) / gain;
                    let factor = 1.0 - (2.0 * ratio.min(1.0) - 1.0).powi(3);
                    damping = (damping * factor.max(0.1)).max(LEAST_DAMPING);
                    point = next;
                    break;
                }
                Ok(beyond) => rejected = Some(beyond),
                Err(error) => last_error = Some(error),
            }
            damping *= 8.0;
        }
    }
    Err(CalibrationError::NotConverged {
        iterations: MOST_ITERATIONS,
        values: values_at(variables, &point.x),
    })
}

/// The next point, and the decrease of the linearized sum of squares by this step.
fn step(
    point: &Point,
    (variables, units): (&[Variable], &[f64]),
    is_free: &[bool],
    singular: &Singular,
    damping: f64,
) -> (Vec<f64>, f64) {
    let target: Vec<f64> = point.residuals.iter().map(|r| -r).collect();
    let solution = singular.damped_solution(&target, damping);
    let free = (0..point.x.len()).filter(|j| is_free[*j]);
    let moves: Vec<(usize, f64)> = free
        .zip(&solution)
        .map(|(j, d)| (j, d * units[j]))
        .collect();
    let logarithms = moves.iter().filter(|(j, _)| variables[*j].is_logarithm);
    let longest = logarithms.fold(0.0_f64, |most, (_, d)| most.max(d.abs()));
    let shortened = (LONGEST_STEP / longest).min(1.0);
    let mut x = point.x.clone();
    for (j, d) in moves {
        let [low, high] = variables[j].bounds;
        x[j] = (x[j] + shortened * d).clamp(low, high);
    }
    let mut linear = point.residuals.clone();
    for (j, column) in point.columns.iter().enumerate() {
        let moved = x[j] - point.x[j];
        for (r, c) in linear.iter_mut().zip(column) {
            *r += c * moved;
        }
    }
    let expected: f64 = linear.iter().map(|r| r * r).sum();
    (x, point.chi_square() - expected)
}
