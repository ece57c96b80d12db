//! A tower of a design with its mass and frequencies, and their derivatives.

use towermodes::{
    Change, ModeFrequency, ModeName, Operation, Options, Sensitivities, Tower, TowerDescription,
    Workspace, sensitivities,
};

use super::error::DesignError;
use super::problem::{DesignProblem, Variable};

/// More modes than this are not searched for a goal.
const MOST_MODES: usize = 64;

/// Mass and frequencies of a tower.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Point {
    /// Mass, kg.
    pub(super) mass_kg: f64,
    /// The extrapolated frequency of each goal, Hz.
    pub(super) frequencies_hz: Vec<f64>,
    /// The derivatives with respect to some variables.
    pub(super) slopes: Option<Slopes>,
}

/// The derivatives with respect to the values of some variables.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Slopes {
    /// Of the mass, kg per unit of each variable.
    pub(super) mass: Vec<f64>,
    /// Of each frequency, Hz per unit of each variable.
    pub(super) frequencies: Vec<Vec<f64>>,
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
/// `modes` is increased until it contains the goals.
pub(super) fn solved(
    tower: &TowerDescription,
    problem: &DesignProblem,
    variables: Option<&[(&Variable, f64)]>,
    (options, modes): (&Options, &mut usize),
    workspace: &mut Workspace,
) -> Result<Point, DesignError> {
    let changes = variables.unwrap_or_default().iter();
    let changes: Vec<Change> = changes.map(|(of, _)| of.change.clone()).collect();
    let (found, places) = loop {
        let options = Options {
            modes: *modes,
            ..options.clone()
        };
        let found = sensitivities(tower, &changes, &options, workspace)?;
        match places(problem, &found.modes) {
            Ok(places) => break (found, places),
            Err(mode) if *modes >= MOST_MODES || found.modes.len() < *modes => {
                return Err(DesignError::NoMode {
                    mode,
                    modes: found.modes.len(),
                });
            }
            Err(_) => *modes = (2 * *modes).min(MOST_MODES),
        }
    };
    let frequencies_hz = places.iter().map(|at| found.modes[*at].extrapolated_hz);
    let frequencies_hz = frequencies_hz.collect();
    let slopes = variables.map(|of| slopes(problem, of, &found, &places));
    Ok(Point {
        mass_kg: Tower::new(tower.clone())?.mass_kg(),
        frequencies_hz,
        slopes: slopes.transpose()?,
    })
}

/// The place of each goal's mode in the list.
fn places(problem: &DesignProblem, modes: &[ModeFrequency]) -> Result<Vec<usize>, ModeName> {
    let place = |name: ModeName| {
        let is_it = |mode: &ModeFrequency| mode.family == name.family && mode.order == name.order;
        modes.iter().position(is_it).ok_or(name)
    };
    problem.goals.iter().map(|goal| place(goal.mode)).collect()
}

fn slopes(
    problem: &DesignProblem,
    variables: &[(&Variable, f64)],
    found: &Sensitivities,
    places: &[usize],
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
    let mut frequencies = Vec::with_capacity(places.len());
    for (goal, place) in problem.goals.iter().zip(places) {
        let mut row = Vec::with_capacity(variables.len());
        for (index, of) in found.changes.iter().enumerate() {
            let derivative = of.modes[*place].as_ref();
            let derivative = derivative.map_err(|reason| DesignError::NoDerivative {
                mode: goal.mode,
                variable: of.change.name().to_owned(),
                reason: *reason,
            })?;
            row.push(derivative.hz_per_unit * per_value(index));
        }
        frequencies.push(row);
    }
    Ok(Slopes {
        mass: mass.collect(),
        frequencies,
    })
}
