//! The tower at one point of a fit: the computed frequencies of the measured modes, and their
//! derivatives.

use std::fmt;

use towermodes::{
    ModeFrequency, ModeName, Operation, Options, Sensitivities, Solver, TowerDescription,
};

use super::error::CalibrationError;
use super::pairing::MOST_MODES;
use super::problem::Problem;
use super::singular::norm;
use super::variable::{Variable, apply};

/// A residual above this is unlikely.
pub(super) const LARGE_RESIDUAL: f64 = 3.0;

/// The bound that an unknown has reached.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AtBound {
    /// The lower bound.
    Lower,
    /// The upper bound.
    Upper,
}

impl fmt::Display for AtBound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Lower => "lower",
            Self::Upper => "upper",
        })
    }
}

/// The towers at the coordinates of the unknowns.
pub(super) struct Towers<'a> {
    pub(super) problem: &'a Problem,
    pub(super) variables: &'a [Variable],
    pub(super) names: &'a [ModeName],
    /// Whether at least one measured frequency changes with each unknown, possibly only to second
    /// order.
    pub(super) has_effect: Vec<bool>,
    pub(super) options: Options,
    solver: &'a mut Solver,
    description: TowerDescription,
}

/// One tower: the frequencies of the measured modes and their derivatives.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Point {
    pub(super) x: Vec<f64>,
    /// The frequency of each measurement, Hz.
    pub(super) frequencies_hz: Vec<f64>,
    /// The names and frequencies (Hz) of all modes of the list.
    pub(super) modes: Vec<(ModeName, f64)>,
    /// The residuals of the measurements, then of the priors, in standard deviations.
    pub(super) residuals: Vec<f64>,
    /// The derivatives of the residuals, a column for each unknown.
    pub(super) columns: Vec<Vec<f64>>,
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
        // A mode may have moved up.
        let has_all = |found: &Sensitivities| {
            let is_there = |name: &ModeName| found.modes.iter().any(|mode| mode.name() == *name);
            self.names.iter().all(is_there)
        };
        let solve = |solver: &mut Solver| solver.sensitivities(&self.description, &changes);
        self.solver.options.clone_from(&self.options);
        let found = self.solver.until(MOST_MODES, solve, has_all)?;
        self.options.modes = self.solver.options.modes;
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

    /// The columns of some unknowns, each multiplied by the unit of its coordinate.
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

    /// The unit of each coordinate: its scale. A coordinate without a scale gets the unit for which
    /// its column is as long as the columns of the others.
    pub(super) fn units(&self, variables: &[Variable]) -> Vec<f64> {
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

    /// The unknowns at bounds that prevent this frequency from being nearer to its measurement.
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

    /// The unknowns, without those at a bound beyond which the sum of squares would decrease.
    pub(super) fn free(&self, variables: &[Variable]) -> Vec<bool> {
        let of = |j: usize| {
            let column = self.columns[j].iter().zip(&self.residuals);
            let gradient: f64 = column.map(|(c, r)| c * r).sum();
            let [low, high] = variables[j].bounds;
            !(self.x[j] <= low && gradient >= 0.0 || self.x[j] >= high && gradient <= 0.0)
        };
        (0..self.x.len()).map(of).collect()
    }
}
