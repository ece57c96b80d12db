//! The towers of a design in scaled values: variables in their units above the lower bound, mass
//! relative to the start, limits as functions that must not be positive.

use std::rc::Rc;

use towermodes::modes::Holders;
use towermodes::{
    Change, ModeFrequency, ModeName, Operation, Options, Sensitivities, Solution, SolveError,
    Solver, Tower, TowerDescription,
};

use super::error::DesignError;
use super::limits::{Limit, Row, rows};
use super::problem::{DesignProblem, Goal, Side};

/// Largest number of modes computed to find the mode of a goal.
pub(super) const MOST_MODES: usize = 64;

/// Mass and limits of a tower.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Point {
    /// Mass relative to the mass at the start.
    pub(super) mass: f64,
    /// The limits in the order of [`Towers::limits`]; frequencies relative to their limit.
    pub(super) limits: Vec<f64>,
    /// The derivatives of both, if they were requested.
    pub(super) slopes: Option<Slopes>,
    /// For each goal, the modes with the lowest and with the highest frequency among those to which
    /// it applies.
    pub(super) ends: Vec<[End; 2]>,
    /// The frequency of the named mode of each goal, Hz.
    pub(super) named_hz: Vec<f64>,
}

impl Point {
    /// The largest violation of a limit; 0 if all are met.
    pub(super) fn violation(&self) -> f64 {
        self.limits.iter().copied().fold(0.0, f64::max)
    }
}

/// The mode that determines one end of a band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    pub(super) mode: ModeName,
    /// Its extrapolated frequency, Hz.
    pub(super) hz: f64,
}

/// The derivatives with respect to the scaled variables.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Slopes {
    pub(super) mass: Vec<f64>,
    pub(super) limits: Vec<Vec<f64>>,
}

/// The towers of a problem, and the memory for their solutions.
pub(super) struct Towers<'d> {
    pub(super) problem: &'d DesignProblem,
    pub(super) base: &'d TowerDescription,
    pub(super) options: &'d Options,
    solver: &'d mut Solver,
    /// Returns whether the design shall continue.
    goes_on: &'d mut dyn FnMut() -> bool,
    rows: Vec<Row>,
    /// The ends of the bands of the goals, then the limits of the shape.
    pub(super) limits: Vec<Limit>,
    /// The amount by which each limit is tightened in the search, scaled, because rounding and the
    /// other mesh of the final solve change its value.
    room: Vec<f64>,
    /// The unit of each variable.
    pub(super) units: Vec<f64>,
    /// The upper bound of each scaled variable, 1 unless the bounds are wide.
    pub(super) highest: Vec<f64>,
    /// Mass of the start, kg.
    pub(super) mass_kg: f64,
    /// Number of solved towers.
    pub(super) solves: usize,
    modes: usize,
    last: Option<(Vec<f64>, Rc<Point>)>,
}

impl<'d> Towers<'d> {
    pub(super) fn new(
        problem: &'d DesignProblem,
        base: &'d TowerDescription,
        options: &'d Options,
        (solver, goes_on): (&'d mut Solver, &'d mut dyn FnMut() -> bool),
    ) -> Self {
        let rows = rows(problem, base);
        let mut limits = Vec::new();
        for (goal, of) in problem.goals.iter().enumerate() {
            let sides = Side::ALL.into_iter();
            let limited = sides.filter(|side| of.limit_hz(*side).is_some());
            limits.extend(limited.map(|side| Limit::Frequency { goal, side }));
        }
        limits.extend(rows.iter().map(|row| row.limit));
        let variables = problem.variables.iter();
        let units: Vec<f64> = variables.map(|of| of.unit(base)).collect();
        let ranges = problem.variables.iter().zip(&units);
        Self {
            highest: ranges.map(|(of, unit)| (of.high - of.low) / unit).collect(),
            units,
            modes: options.modes.min(2 + 2 * problem.goals.len()),
            mass_kg: 1.0,
            solves: 0,
            last: None,
            room: vec![0.0; limits.len()],
            problem,
            base,
            options,
            solver,
            goes_on,
            rows,
            limits,
        }
    }

    /// The values of the variables from scaled values.
    pub(super) fn values(&self, scaled: &[f64]) -> Vec<f64> {
        let all = self.problem.variables.iter().zip(scaled).enumerate();
        all.map(|(i, (of, z))| match *z {
            // The ends exactly.
            0.0 => of.low,
            z if z == self.highest[i] => of.high,
            z => of.low + z * self.units[i],
        })
        .collect()
    }

    /// The scaled values of the variables.
    pub(super) fn scaled(&self, values: &[f64]) -> Vec<f64> {
        let all = self.problem.variables.iter().zip(values).enumerate();
        all.map(|(i, (of, value))| ((value - of.low) / self.units[i]).clamp(0.0, self.highest[i]))
            .collect()
    }

    /// The tower with scaled values of the variables.
    pub(super) fn tower(&self, scaled: &[f64]) -> TowerDescription {
        self.problem.tower(self.base, &self.values(scaled))
    }

    /// Mass and limits at scaled values, and their derivatives if requested. If the tower was the
    /// last one solved, it is not solved again.
    pub(super) fn at(&mut self, scaled: &[f64], slopes: bool) -> Result<Rc<Point>, DesignError> {
        if let Some((at, known)) = &self.last
            && at.as_slice() == scaled
            && (known.slopes.is_some() || !slopes)
        {
            return Ok(Rc::clone(known));
        }
        self.last = None;
        let found = Rc::new(self.compute(scaled, slopes)?);
        self.last = Some((scaled.to_vec(), Rc::clone(&found)));
        Ok(found)
    }

    /// Takes the mass at scaled values as the unit of mass.
    pub(super) fn begin_at(&mut self, scaled: &[f64]) -> Result<(), DesignError> {
        self.mass_kg *= self.at(scaled, false)?.mass;
        self.last = None;
        Ok(())
    }

    /// Tightens the limits whose values are above `tolerated`.
    pub(super) fn tighten(&mut self, limits: &[f64], tolerated: f64) {
        /// Additional tightening, because the next values have other rounding errors.
        const MORE: f64 = 2e-9;
        for (room, value) in self.room.iter_mut().zip(limits) {
            if *value > tolerated {
                *room += 2.0 * value + MORE;
            }
        }
        self.last = None;
    }

    /// The solution of a tower with the options of `solve`, with as many modes as `has_all` needs.
    pub(super) fn solution(
        &mut self,
        tower: &Tower,
        options: Options,
        has_all: impl FnMut(&Solution) -> bool,
    ) -> Result<Solution, SolveError> {
        let solve = |solver: &mut Solver| {
            self.solves += 1;
            solver.solve(tower)
        };
        let all = |solver: &mut Solver| solver.until(MOST_MODES, solve, has_all);
        self.solver.with(options, all)
    }

    /// A limit in its unit, and its scaled change per unit of relaxation.
    pub(super) fn unit(&self, limit: &Limit, tower: &TowerDescription) -> (f64, f64) {
        match *limit {
            Limit::Bound { variable, side } => {
                let bound = self.problem.variables[variable].bound(side);
                (bound, 1.0 / self.units[variable])
            }
            Limit::Frequency { .. } => {
                let hz = self.of_goal(limit).map_or(1.0, |(_, _, hz)| hz);
                (hz, 1.0 / hz)
            }
            _ => {
                let row = self.rows.iter().find(|row| row.limit == *limit);
                row.map_or((0.0, 0.0), |row| row.unit(self.problem, tower))
            }
        }
    }

    /// The limits for a tower with these frequencies at the ends of the bands: positive if they are
    /// violated.
    pub(super) fn limit_values(&self, ends: &[[End; 2]], tower: &TowerDescription) -> Vec<f64> {
        let goals = self.limits.iter().filter_map(|limit| {
            let (goal, side, limit_hz) = self.of_goal(limit)?;
            let hz = ends[goal][side as usize].hz;
            Some(sign(side) * (hz / limit_hz - 1.0))
        });
        let rows = self.rows.iter().map(|row| row.value(tower));
        goals.chain(rows).collect()
    }

    fn compute(&mut self, scaled: &[f64], slopes: bool) -> Result<Point, DesignError> {
        if !(self.goes_on)() {
            return Err(DesignError::GivenUp);
        }
        self.solves += 1;
        let values = self.values(scaled);
        let tower = self.problem.tower(self.base, &values);
        let (found, places) = self.solved(&tower, slopes)?;
        let end = |place: usize| End {
            mode: found.modes[place].name(),
            hz: found.modes[place].extrapolated_hz,
        };
        let ends: Vec<[End; 2]> = places.iter().map(|places| places.map(end)).collect();
        let named_hz = |goal: &Goal| {
            let mut modes = found.modes.iter();
            let named = modes.find(|mode| mode.name() == goal.mode);
            named.map_or(f64::NAN, |mode| mode.extrapolated_hz)
        };
        let limits = self.limit_values(&ends, &tower);
        let limits = limits
            .iter()
            .zip(&self.room)
            .map(|(value, room)| value + room);
        let slopes = slopes.then(|| self.slopes(&values, &found, &places));
        Ok(Point {
            mass: Tower::new(tower)?.structure_mass_kg() / self.mass_kg,
            limits: limits.collect(),
            slopes: slopes.transpose()?,
            ends,
            named_hz: self.problem.goals.iter().map(named_hz).collect(),
        })
    }

    /// The modes of a tower, with all derivatives if requested, and the indices of the modes at the
    /// ends of each goal. The number of modes is increased until the list contains all modes to
    /// which the goals apply.
    fn solved(
        &mut self,
        tower: &TowerDescription,
        slopes: bool,
    ) -> Result<(Sensitivities, Vec<[usize; 2]>), DesignError> {
        let variables = self.problem.variables.iter().filter(|_| slopes);
        let changes: Vec<Change> = variables.map(|of| of.change.clone()).collect();
        let goals = &self.problem.goals;
        let options = Options {
            modes: self.modes,
            ..self.options.clone()
        };
        let solve = |solver: &mut Solver| solver.sensitivities(tower, &changes);
        let has_all = |found: &Sensitivities| ends(goals, &found.modes, false).is_ok();
        let found = self.solver.with(options, |solver| {
            let found = solver.until(MOST_MODES, solve, has_all);
            self.modes = solver.options.modes;
            found
        })?;
        match ends(goals, &found.modes, true) {
            Ok(ends) => Ok((found, ends)),
            Err(mode) => {
                let modes = found.modes.len();
                Err(DesignError::NoMode { mode, modes })
            }
        }
    }

    fn slopes(
        &self,
        values: &[f64],
        found: &Sensitivities,
        ends: &[[usize; 2]],
    ) -> Result<Slopes, DesignError> {
        let variables = self.problem.variables.iter().zip(values).zip(&self.units);
        // The factor of a tower that is scaled already is relative to its present value.
        let scales = variables.map(|((of, value), unit)| match of.change.operation() {
            Operation::Scale => unit / value,
            Operation::Set | Operation::Add => *unit,
        });
        let scales: Vec<f64> = scales.collect();
        let changes = || found.changes.iter().zip(&scales);
        let mass = changes().map(|(of, scale)| of.mass_kg_per_unit * scale / self.mass_kg);
        let mut limits = Vec::with_capacity(self.limits.len());
        for (goal, side, limit_hz) in self.limits.iter().filter_map(|limit| self.of_goal(limit)) {
            let place = ends[goal][side as usize];
            let row = changes().map(|(of, scale)| {
                let derivative = of.modes[place].as_ref();
                let derivative = derivative.map_err(|reason| DesignError::NoDerivative {
                    mode: found.modes[place].name(),
                    variable: of.change.name().to_owned(),
                    reason: *reason,
                })?;
                Ok(sign(side) * derivative.hz_per_unit * scale / limit_hz)
            });
            limits.push(row.collect::<Result<Vec<f64>, DesignError>>()?);
        }
        for row in &self.rows {
            let variables = self.problem.variables.iter().zip(&self.units);
            let of = variables.map(|(of, unit)| row.derivative(of, self.base) * unit);
            limits.push(of.collect());
        }
        Ok(Slopes {
            mass: mass.collect(),
            limits,
        })
    }

    /// Goal, side and frequency of an end of a band.
    fn of_goal(&self, limit: &Limit) -> Option<(usize, Side, f64)> {
        let Limit::Frequency { goal, side } = *limit else {
            return None;
        };
        let limit_hz = self.problem.goals[goal].limit_hz(side)?;
        Some((goal, side, limit_hz))
    }
}

/// The sign of (frequency/limit − 1) for which a positive value means a violation.
fn sign(side: Side) -> f64 {
    match side {
        Side::Lowest => -1.0,
        Side::Highest => 1.0,
    }
}

/// The indices of the modes with the lowest and the highest frequency to which each goal applies.
///
/// # Errors
/// The name of a goal for which one of these modes may be above the list, unless `is_last`.
fn ends(
    goals: &[Goal],
    modes: &[ModeFrequency],
    is_last: bool,
) -> Result<Vec<[usize; 2]>, ModeName> {
    let of_goal = |goal: &Goal| {
        let all = modes.iter().map(|mode| (mode.name(), &mode.shares));
        let holders = Holders::bound(goal.mode, all);
        let holders = holders.filter(|holders| holders.is_complete || is_last);
        let places = holders.ok_or(goal.mode)?.places;
        let hz = |place: &usize| modes[*place].extrapolated_hz;
        let by_hz = |a: &usize, b: &usize| hz(a).total_cmp(&hz(b));
        let lowest = places.iter().copied().min_by(by_hz);
        let highest = places.iter().copied().max_by(by_hz);
        Ok([lowest, highest].map(Option::unwrap_or_default))
    };
    goals.iter().map(of_goal).collect()
}
