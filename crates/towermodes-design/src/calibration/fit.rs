//! Weighted least squares by the method of Levenberg and Marquardt.

use towermodes::number::Rounded;
use towermodes::{ModeFrequency, ModeName, Operation, Options, Solver, TowerDescription};

use super::determined::{Undetermined, undetermined};
use super::error::CalibrationError;
use super::pairing::MOST_MODES;
use super::problem::Problem;
use super::remark::LARGE_RESIDUAL;
use super::result::AtBound;
use super::singular::{Singular, norm};
use super::variable::{Variable, apply};

/// Iterations at most.
const MOST_ITERATIONS: usize = 200;
/// The iteration ends when a step is expected to lower the sum of squares by less than this.
///
/// Its root is the length of the step in standard deviations.
const SMALL_GAIN: f64 = 1e-10;
/// The first damping, relative to the largest singular value squared.
const FIRST_DAMPING: f64 = 1e-3;
/// Below this damping a step is that of Gauss and Newton to rounding.
const LEAST_DAMPING: f64 = 1e-15;
/// Above this damping no step improves anything.
const MOST_DAMPING: f64 = 1e14;
/// The sum of squares of an answer falls by less than this along the undamped step, relative to
/// itself and 1.
const STATIONARY: f64 = 1e-6;
/// A residual that changes by more than this in the last step that was refused jumps.
const JUMP: f64 = 1e-3;
/// No logarithm moves by more than this in one step.
const LONGEST_STEP: f64 = 1.5;

/// The towers at the coordinates of the unknowns.
pub(super) struct Towers<'a> {
    problem: &'a Problem,
    pub(super) variables: &'a [Variable],
    names: &'a [ModeName],
    /// Whether some measured frequency changes with each unknown, if not to first order.
    pub(super) has_effect: Vec<bool>,
    pub(super) options: Options,
    solver: &'a mut Solver,
    description: TowerDescription,
}

/// One tower: the measured modes' frequencies and their derivatives.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Point {
    pub(super) x: Vec<f64>,
    /// The frequency of each measurement, Hz.
    pub(super) frequencies_hz: Vec<f64>,
    /// The names and frequencies (Hz) of all modes of the list.
    modes: Vec<(ModeName, f64)>,
    /// The residuals of the measurements, then of the priors, in standard deviations.
    pub(super) residuals: Vec<f64>,
    /// The derivatives of the residuals, a column for each unknown.
    pub(super) columns: Vec<Vec<f64>>,
}

/// The fit.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Found {
    pub(super) point: Point,
    /// Which unknowns are not at a bound.
    pub(super) is_free: Vec<bool>,
    /// Whether some measured frequency changes with each unknown, if not to first order.
    pub(super) has_effect: Vec<bool>,
    pub(super) iterations: usize,
}

impl<'a> Towers<'a> {
    pub(super) fn new(
        problem: &'a Problem,
        variables: &'a [Variable],
        names: &'a [ModeName],
        options: Options,
        solver: &'a mut Solver,
    ) -> Self {
        Self {
            description: problem.base.clone(),
            problem,
            has_effect: vec![true; variables.len()],
            variables,
            names,
            options,
            solver,
        }
    }

    /// The tower at a point.
    pub(super) fn evaluate(&mut self, x: &[f64]) -> Result<Point, CalibrationError> {
        self.description.clone_from(&self.problem.base);
        apply(self.variables, x, &mut self.description);
        let changes: Vec<_> = self.variables.iter().map(|v| v.change.clone()).collect();
        let found = loop {
            self.solver.options.clone_from(&self.options);
            let found = self.solver.sensitivities(&self.description, &changes)?;
            let is_there = |name: &ModeName| found.modes.iter().any(|mode| mode.name() == *name);
            let modes = self.options.modes;
            let is_last = modes >= MOST_MODES || found.modes.len() < modes;
            if is_last || self.names.iter().all(is_there) {
                break found;
            }
            // A mode that has moved up.
            self.options.modes = (2 * modes).min(MOST_MODES);
        };
        let (n, data) = (x.len(), self.names.len());
        let mut point = Point {
            x: x.to_vec(),
            frequencies_hz: Vec::with_capacity(data),
            modes: (found.modes.iter())
                .map(|mode| (mode.name(), mode.extrapolated_hz))
                .collect(),
            residuals: Vec::with_capacity(data + n),
            columns: vec![Vec::with_capacity(data + n); n],
        };
        for (index, (name, measured)) in self.names.iter().zip(&self.problem.measured).enumerate() {
            let is_it = |mode: &ModeFrequency| mode.name() == *name;
            let Some(mode) = found.modes.iter().position(is_it) else {
                return Err(CalibrationError::NoMode {
                    index,
                    mode: *name,
                    computed: found.modes.len(),
                    there: names(&found.modes),
                });
            };
            let hz = found.modes[mode].extrapolated_hz;
            point.frequencies_hz.push(hz);
            let deviation_hz = measured.deviation_hz;
            point
                .residuals
                .push((hz - measured.frequency_hz) / deviation_hz);
            for (j, (variable, change)) in self.variables.iter().zip(&found.changes).enumerate() {
                let derivative = change.modes[mode].map_err(|reason| {
                    let (mode, change) = (*name, variable.change.name().to_owned());
                    CalibrationError::NoDerivative {
                        mode,
                        change,
                        reason,
                    }
                })?;
                let per_value = match variable.change.operation() {
                    // The factor of the changed tower is 1.
                    Operation::Scale => derivative.hz_per_unit / variable.value(x[j]),
                    _ => derivative.hz_per_unit,
                };
                let slope = variable.slope(x[j]);
                point.columns[j].push(per_value * slope / deviation_hz);
            }
        }
        self.add_priors(&mut point);
        Ok(point)
    }

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

    /// Refuses a fit in which every unknown is at a bound, and given bounds keep a frequency from
    /// its measurement: nothing was fitted. That a mass is not negative is no given bound.
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

    /// Refuses a point that is no minimum: the sum of squares would fall further on, but a measured
    /// name passes to another mode there, and its frequency jumps. `rejected` is the last point
    /// beyond.
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

    fn add_priors(&self, point: &mut Point) {
        for (j, variable) in self.variables.iter().enumerate() {
            let Some([mean, deviation]) = variable.prior else {
                continue;
            };
            point.residuals.push((point.x[j] - mean) / deviation);
            for (k, column) in point.columns.iter_mut().enumerate() {
                column.push(if k == j { 1.0 / deviation } else { 0.0 });
            }
        }
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

/// The names of modes, in a list.
fn names(modes: &[ModeFrequency]) -> String {
    let name = |mode: &ModeFrequency| {
        let (family, order) = (mode.family, mode.order);
        ModeName { family, order }.to_string()
    };
    modes.iter().map(name).collect::<Vec<_>>().join(", ")
}

impl Point {
    /// The sum of the squares of the residuals.
    pub(super) fn chi_square(&self) -> f64 {
        self.residuals.iter().map(|r| r * r).sum()
    }

    /// The columns of some unknowns, each for one unit of its coordinate.
    pub(super) fn scaled(&self, units: &[f64], is_free: &[bool]) -> Vec<Vec<f64>> {
        let all = self.columns.iter().zip(units).zip(is_free);
        let free = all.filter(|(_, is_free)| **is_free);
        free.map(|((column, unit), _)| column.iter().map(|c| c * unit).collect())
            .collect()
    }

    /// The length of each column.
    pub(super) fn lengths(&self) -> Vec<f64> {
        self.columns.iter().map(|column| norm(column)).collect()
    }

    /// The unit of each coordinate: its scale. A coordinate without one has the unit with which the
    /// measurements change as much as with the unit of the others.
    fn units(&self, variables: &[Variable]) -> Vec<f64> {
        let all = variables.iter().zip(self.lengths());
        let of_scales = all
            .clone()
            .map(|(v, length)| v.scale.unwrap_or(0.0) * length);
        let longest = Some(of_scales.fold(0.0, f64::max)).filter(|longest| *longest > 0.0);
        let unit = |(variable, length): (&Variable, f64)| match (variable.scale, length > 0.0) {
            (Some(scale), _) => scale,
            (None, true) => longest.unwrap_or(1.0) / length,
            (None, false) => 1.0,
        };
        all.map(unit).collect()
    }

    /// The unknowns at bounds beyond which a frequency would be nearer to its measurement.
    pub(super) fn held_by(&self, variables: &[Variable], index: usize) -> Vec<(usize, AtBound)> {
        let all = variables.iter().zip(&self.x).zip(&self.columns).enumerate();
        let held = all.filter_map(|(j, ((variable, x), column))| {
            let [low, high] = variable.bounds;
            let gradient = self.residuals[index] * column[index];
            match gradient {
                g if g > 0.0 && *x <= low => Some((j, AtBound::Lower)),
                g if g < 0.0 && *x >= high => Some((j, AtBound::Upper)),
                _ => None,
            }
        });
        held.collect()
    }

    /// The unknowns that are not at a bound towards which the sum of squares falls.
    fn free(&self, variables: &[Variable]) -> Vec<bool> {
        let of = |j: usize| {
            let column = self.columns[j].iter().zip(&self.residuals);
            let gradient: f64 = column.map(|(c, r)| c * r).sum();
            let [low, high] = variables[j].bounds;
            !(self.x[j] <= low && gradient >= 0.0 || self.x[j] >= high && gradient <= 0.0)
        };
        (0..self.x.len()).map(of).collect()
    }
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

/// The next point, and by how much the linearized sum of squares falls on the way to it.
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
