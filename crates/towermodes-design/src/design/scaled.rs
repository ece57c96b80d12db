//! The design in scaled numbers: variables in their units above the lower bound, mass relative to
//! that of the start, limits as functions that must not be positive.

use towermodes::{Options, Solution, SolveError, Solver, Tower, TowerDescription};

use super::error::DesignError;
use super::limits::{Limit, Row, rows};
use super::point::{End, Point, solved, tower_with};
use super::problem::{DesignProblem, Side};

/// Mass and limits of a tower, scaled.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Scaled {
    /// Mass relative to that of the start.
    pub(super) mass: f64,
    /// The limits in the order of [`Scale::limits`]; frequencies relative to their limit.
    pub(super) limits: Vec<f64>,
    /// The derivatives of both with respect to the free variables.
    pub(super) slopes: Option<ScaledSlopes>,
    /// The same in units.
    pub(super) point: Point,
}

/// The derivatives with respect to the free variables, scaled.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ScaledSlopes {
    pub(super) mass: Vec<f64>,
    pub(super) limits: Vec<Vec<f64>>,
}

/// A design with its scales, and the memory of its solves.
pub(super) struct Scale<'d> {
    pub(super) problem: &'d DesignProblem,
    pub(super) base: &'d TowerDescription,
    pub(super) options: &'d Options,
    solver: &'d mut Solver,
    rows: Vec<Row>,
    /// The ends of the bands of the goals, then the limits of the shape.
    pub(super) limits: Vec<Limit>,
    /// How much stricter each limit is for the search, scaled: what rounding and another mesh take.
    pub(super) room: Vec<f64>,
    /// The variables that are chosen; the others keep their values.
    pub(super) free: Vec<usize>,
    /// The unit of each variable.
    pub(super) units: Vec<f64>,
    /// The upper bound of each scaled variable, 1 unless the bounds are wide.
    pub(super) highest: Vec<f64>,
    /// Mass of the start, kg.
    pub(super) mass_kg: f64,
    /// How many towers were solved.
    pub(super) solves: usize,
    modes: usize,
    last: Option<(Vec<f64>, Scaled)>,
}

impl<'d> Scale<'d> {
    pub(super) fn new(
        problem: &'d DesignProblem,
        base: &'d TowerDescription,
        options: &'d Options,
        solver: &'d mut Solver,
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
            free: (0..problem.variables.len()).collect(),
            modes: options.modes.min(2 + 2 * problem.goals.len()),
            mass_kg: 1.0,
            solves: 0,
            last: None,
            room: vec![0.0; limits.len()],
            problem,
            base,
            options,
            solver,
            rows,
            limits,
        }
    }

    /// The values of the variables of scaled ones.
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

    /// The scaled variables of values.
    pub(super) fn scaled(&self, values: &[f64]) -> Vec<f64> {
        let all = self.problem.variables.iter().zip(values).enumerate();
        all.map(|(i, (of, value))| ((value - of.low) / self.units[i]).clamp(0.0, self.highest[i]))
            .collect()
    }

    /// The tower with scaled values of the variables.
    pub(super) fn tower(&self, scaled: &[f64]) -> TowerDescription {
        tower_with(self.problem, self.base, &self.values(scaled))
    }

    /// Chooses the free variables.
    pub(super) fn set_free(&mut self, free: Vec<usize>) {
        if free != self.free {
            self.free = free;
            self.last = None;
        }
    }

    /// Mass and limits at scaled values, and their derivatives if requested. A tower that was
    /// solved last is not solved again.
    pub(super) fn at(&mut self, scaled: &[f64], slopes: bool) -> Result<&Scaled, DesignError> {
        let is_known = self.last.as_ref().is_some_and(|(at, known)| {
            at.as_slice() == scaled && (known.slopes.is_some() || !slopes)
        });
        if !is_known {
            self.last = None;
            let found = self.solve(scaled, slopes)?;
            self.last = Some((scaled.to_vec(), found));
        }
        match &self.last {
            Some((_, found)) => Ok(found),
            None => Err(DesignError::NoVariables),
        }
    }

    /// A tower, solved as any other.
    pub(super) fn solution(
        &mut self,
        tower: &Tower,
        options: &Options,
    ) -> Result<Solution, SolveError> {
        self.solves += 1;
        let solve = |solver: &mut Solver| solver.solve(tower);
        self.solver.with(options.clone(), solve)
    }

    /// Forgets the last tower, whose scales have changed.
    pub(super) fn forget(&mut self) {
        self.last = None;
    }

    /// A limit in its unit, and its scaled change per unit by which it is relaxed.
    pub(super) fn unit(&self, limit: &Limit, tower: &TowerDescription) -> (f64, f64) {
        match *limit {
            Limit::Bound { variable, side } => {
                let of = &self.problem.variables[variable];
                let bound = match side {
                    Side::Lowest => of.low,
                    Side::Highest => of.high,
                };
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

    fn solve(&mut self, scaled: &[f64], slopes: bool) -> Result<Scaled, DesignError> {
        self.solves += 1;
        let values = self.values(scaled);
        let tower = tower_with(self.problem, self.base, &values);
        let free = self.free.iter();
        let of: Vec<_> = free
            .map(|i| (&self.problem.variables[*i], values[*i]))
            .collect();
        let of = slopes.then_some(of.as_slice());
        let options = (self.options, &mut self.modes);
        let point = solved(&tower, self.problem, of, options, self.solver)?;
        let values = self.limit_values(&point.ends, &tower);
        let limits = values
            .iter()
            .zip(&self.room)
            .map(|(value, room)| value + room);
        Ok(Scaled {
            mass: point.mass_kg / self.mass_kg,
            limits: limits.collect(),
            slopes: point.slopes.is_some().then(|| self.slopes(&point)),
            point,
        })
    }

    /// The limits on a tower with these frequencies at the ends of the bands: positive where they
    /// are violated.
    pub(super) fn limit_values(&self, ends: &[[End; 2]], tower: &TowerDescription) -> Vec<f64> {
        let goals = self.limits.iter().filter_map(|limit| {
            let (goal, side, limit_hz) = self.of_goal(limit)?;
            let hz = ends[goal][side as usize].hz;
            Some(sign(side) * (hz / limit_hz - 1.0))
        });
        goals
            .chain(self.rows.iter().map(|row| row.value(tower)))
            .collect()
    }

    fn slopes(&self, point: &Point) -> ScaledSlopes {
        let Some(slopes) = &point.slopes else {
            return ScaledSlopes {
                mass: Vec::new(),
                limits: Vec::new(),
            };
        };
        let range = |index: usize| self.units[self.free[index]];
        let scaled = |row: &[f64], by: f64| -> Vec<f64> {
            let entries = row.iter().enumerate();
            entries.map(|(index, d)| d * range(index) * by).collect()
        };
        let goals = self.limits.iter().filter_map(|limit| {
            let (goal, side, limit_hz) = self.of_goal(limit)?;
            Some(scaled(
                &slopes.ends[goal][side as usize],
                sign(side) / limit_hz,
            ))
        });
        let rows = self.rows.iter().map(|row| {
            let free = self.free.iter().map(|i| &self.problem.variables[*i]);
            let row: Vec<f64> = free.map(|of| row.derivative(of, self.base)).collect();
            scaled(&row, 1.0)
        });
        ScaledSlopes {
            mass: scaled(&slopes.mass, 1.0 / self.mass_kg),
            limits: goals.chain(rows).collect(),
        }
    }

    /// Goal, side and frequency of an end of a band.
    pub(super) fn of_goal(&self, limit: &Limit) -> Option<(usize, Side, f64)> {
        let Limit::Frequency { goal, side } = *limit else {
            return None;
        };
        let limit_hz = self.problem.goals[goal].limit_hz(side)?;
        Some((goal, side, limit_hz))
    }
}

/// Of (frequency/limit − 1), so that it is positive where the limit is violated.
fn sign(side: Side) -> f64 {
    match side {
        Side::Lowest => -1.0,
        Side::Highest => 1.0,
    }
}
