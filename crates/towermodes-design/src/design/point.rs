//! A tower of a design with its mass and frequencies, and their derivatives.

use towermodes::modes::Holders;
use towermodes::{
    Change, ChangeSensitivity, ModeFrequency, ModeName, Operation, Options, Sensitivities, Solver,
    Tower, TowerDescription,
};

use super::error::DesignError;
use super::problem::{DesignProblem, Goal, Side, Variable};

/// More modes than this are not searched for a goal.
const MOST_MODES: usize = 64;

/// Mass and frequencies of a tower.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Point {
    /// Mass, kg.
    pub(super) mass_kg: f64,
    /// Of the modes that hold the name of each goal the one with the lowest frequency, and the one
    /// with the highest.
    pub(super) ends: Vec<[End; 2]>,
    /// The derivatives with respect to some variables.
    pub(super) slopes: Option<Slopes>,
}

/// The mode that decides on one end of a band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct End {
    pub(super) mode: ModeName,
    /// Its extrapolated frequency, Hz.
    pub(super) hz: f64,
}

/// The derivatives with respect to the values of some variables.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Slopes {
    /// Of the mass, kg per unit of each variable.
    pub(super) mass: Vec<f64>,
    /// Of the lowest and the highest frequency of each goal, Hz per unit of each variable; of those
    /// without a limit nothing.
    pub(super) ends: Vec<[Vec<f64>; 2]>,
}

impl Point {
    /// What decides on one end of the band of a goal.
    pub(super) fn end(&self, goal: usize, side: Side) -> End {
        self.ends[goal][side as usize]
    }
}

/// The original tower with other values of the variables.
pub(super) fn tower_with(
    problem: &DesignProblem,
    base: &TowerDescription,
    values: &[f64],
) -> TowerDescription {
    let mut tower = base.clone();
    for (variable, value) in problem.variables.iter().zip(values) {
        variable.change.apply(&mut tower, *value);
    }
    tower
}

/// Solves a tower; with the derivatives with respect to `variables`, whose values are given.
/// `modes` is increased until it contains all modes that hold the names of the goals.
pub(super) fn solved(
    tower: &TowerDescription,
    problem: &DesignProblem,
    variables: Option<&[(&Variable, f64)]>,
    (options, modes): (&Options, &mut usize),
    solver: &mut Solver,
) -> Result<Point, DesignError> {
    let changes = variables.unwrap_or_default().iter();
    let changes: Vec<Change> = changes.map(|(of, _)| of.change.clone()).collect();
    let (found, ends) = loop {
        let options = Options {
            modes: *modes,
            ..options.clone()
        };
        let found = solver.with(options, |solver| solver.sensitivities(tower, &changes))?;
        let is_last = *modes >= MOST_MODES || found.modes.len() < *modes;
        match ends(problem, &found.modes, is_last) {
            Ok(ends) => break (found, ends),
            Err(mode) if is_last => {
                return Err(DesignError::NoMode {
                    mode,
                    modes: found.modes.len(),
                });
            }
            Err(_) => *modes = (2 * *modes).min(MOST_MODES),
        }
    };
    let end = |place: usize| End {
        mode: found.modes[place].name(),
        hz: found.modes[place].extrapolated_hz,
    };
    let slopes = variables.map(|of| slopes(problem, of, &found, &ends));
    Ok(Point {
        mass_kg: Tower::new(tower.clone())?.mass_kg(),
        ends: ends.iter().map(|places| places.map(end)).collect(),
        slopes: slopes.transpose()?,
    })
}

/// The places in the list of the holders of each goal's name with the lowest and the highest
/// frequency.
///
/// # Errors
/// The name whose mode, or of which a holder, may be above the list, unless that is the last one.
fn ends(
    problem: &DesignProblem,
    modes: &[ModeFrequency],
    is_last: bool,
) -> Result<Vec<[usize; 2]>, ModeName> {
    let of_goal = |goal: &Goal| {
        let all = modes.iter().map(|mode| (mode.name(), &mode.shares));
        let holders = Holders::of(goal.mode, all);
        let holders = holders.filter(|holders| holders.is_complete || is_last);
        let places = holders.ok_or(goal.mode)?.places;
        let hz = |place: &usize| modes[*place].extrapolated_hz;
        let by_hz = |a: &usize, b: &usize| hz(a).total_cmp(&hz(b));
        let lowest = places.iter().copied().min_by(by_hz);
        let highest = places.iter().copied().max_by(by_hz);
        Ok([lowest, highest].map(Option::unwrap_or_default))
    };
    problem.goals.iter().map(of_goal).collect()
}

fn slopes(
    problem: &DesignProblem,
    variables: &[(&Variable, f64)],
    found: &Sensitivities,
    ends: &[[usize; 2]],
) -> Result<Slopes, DesignError> {
    // The factor of a tower that is scaled already is relative to its present value.
    let per_value = |index: usize| {
        let (variable, value) = variables[index];
        match variable.change.operation() {
            Operation::Scale => 1.0 / value,
            Operation::Set | Operation::Add => 1.0,
        }
    };
    let all = found.changes.iter().enumerate();
    let mass = all.map(|(index, of)| of.mass_kg_per_unit * per_value(index));
    let row = |place: usize| -> Result<Vec<f64>, DesignError> {
        let of_change = |(index, of): (usize, &ChangeSensitivity)| {
            let derivative = of.modes[place].as_ref();
            let derivative = derivative.map_err(|reason| DesignError::NoDerivative {
                mode: found.modes[place].name(),
                variable: of.change.name().to_owned(),
                reason: *reason,
            })?;
            Ok(derivative.hz_per_unit * per_value(index))
        };
        found.changes.iter().enumerate().map(of_change).collect()
    };
    let mut rows = Vec::with_capacity(ends.len());
    for (goal, places) in problem.goals.iter().zip(ends) {
        let of_end = |side: Side| match goal.limit_hz(side) {
            Some(_) => row(places[side as usize]),
            None => Ok(Vec::new()),
        };
        rows.push([of_end(Side::Lowest)?, of_end(Side::Highest)?]);
    }
    Ok(Slopes {
        mass: mass.collect(),
        ends: rows,
    })
}
