//! Moves of variables with steps: one step of one, or an exchange of two, with the effect that the
//! derivatives predict.

use towermodes::Parameter;

use super::limits::Limit;
use super::minimum::MET;
use super::scaled::{Scale, Scaled};

/// The variables with steps, and the steps at which they are.
pub(super) struct Stepped {
    pub(super) variables: Vec<usize>,
    /// Multiples of the step.
    counts: Vec<f64>,
}

impl Stepped {
    pub(super) fn rounded(
        scale: &Scale<'_>,
        variables: Vec<usize>,
        scaled: &[f64],
        rounding: fn(f64) -> f64,
    ) -> Self {
        let values = scale.values(scaled);
        let counts = variables.iter().map(|&i| {
            let variable = &scale.problem.variables[i];
            let step = variable.step.unwrap_or(1.0);
            let [low, high] = variable.multiples(step);
            rounding(values[i] / step).clamp(low, high)
        });
        let counts = counts.collect();
        Self { variables, counts }
    }

    pub(super) fn put_into(&self, scaled: &mut [f64], scale: &Scale<'_>) {
        for (&i, count) in self.variables.iter().zip(&self.counts) {
            let variable = &scale.problem.variables[i];
            let value = multiple(*count, variable.step.unwrap_or(1.0));
            scaled[i] = (value - variable.low) / scale.units[i];
        }
    }

    /// Whether all variables stay within their bounds after a move.
    fn allows(&self, moves: &[f64], scale: &Scale<'_>) -> bool {
        let all = self.variables.iter().zip(&self.counts).zip(moves);
        all.into_iter().all(|((&i, count), by)| {
            let variable = &scale.problem.variables[i];
            let [low, high] = variable.multiples(variable.step.unwrap_or(1.0));
            (low..=high).contains(&(count + by))
        })
    }

    pub(super) fn moved(&self, moves: &[f64]) -> Self {
        Self {
            variables: self.variables.clone(),
            counts: self.counts.iter().zip(moves).map(|(a, b)| a + b).collect(),
        }
    }

    /// The change of each scaled variable per step.
    fn sizes(&self, scale: &Scale<'_>) -> Vec<f64> {
        let size = |i: &usize| {
            let variable = &scale.problem.variables[*i];
            variable.step.unwrap_or(1.0) / scale.units[*i]
        };
        self.variables.iter().map(size).collect()
    }
}

/// A multiple of a step: of 0.001 the number that is written 0.021, not its neighbour.
pub(super) fn multiple(count: f64, step: f64) -> f64 {
    let per_unit = (1.0 / step).round();
    match (per_unit * step - 1.0).abs() < 1e-12 {
        true => count / per_unit,
        false => count * step,
    }
}

/// A move with what the derivatives predict of it.
pub(super) struct Candidate {
    pub(super) moves: Vec<f64>,
    /// Change of the scaled mass.
    pub(super) mass: f64,
    /// Sum of the violations after it.
    pub(super) violation: f64,
}

pub(super) fn violation(limits: impl Iterator<Item = f64>) -> f64 {
    limits.map(|limit| (limit - MET).max(0.0)).sum()
}

/// One step of one variable, and of two in opposite directions. Where that would break an order of
/// numbers, the neighbours move along.
pub(super) fn candidates(scale: &Scale<'_>, stepped: &Stepped, at: &Scaled) -> Vec<Candidate> {
    let count = stepped.variables.len();
    let sizes = stepped.sizes(scale);
    let mut all = Vec::new();
    let mut push = |moves: Vec<f64>| {
        let moves = in_order(moves, scale, stepped);
        if stepped.allows(&moves, scale) && moves.iter().any(|by| *by != 0.0) {
            all.extend(predicted(moves, &sizes, at));
        }
    };
    for i in 0..count {
        for by in [-1.0, 1.0] {
            let mut moves = vec![0.0; count];
            moves[i] = by;
            push(moves.clone());
            for j in (0..count).filter(|j| *j != i) {
                let mut moves = moves.clone();
                moves[j] = -by;
                push(moves);
            }
        }
    }
    all
}

/// Lets the neighbours in a falling order follow a move: upwards those below, downwards those
/// above.
fn in_order(mut moves: Vec<f64>, scale: &Scale<'_>, stepped: &Stepped) -> Vec<f64> {
    let of = |number: &Parameter| {
        let mut all = stepped.variables.iter();
        all.position(|i| {
            let numbers = scale.problem.variables[*i].change.parameters();
            numbers.contains(number)
        })
    };
    let pairs = scale.limits.iter().filter_map(|limit| match limit {
        Limit::Falling { below, above } => Some((of(below)?, of(above)?)),
        _ => None,
    });
    let pairs: Vec<(usize, usize)> = pairs.collect();
    let value = |moves: &[f64], i: usize| {
        let step = scale.problem.variables[stepped.variables[i]].step;
        (stepped.counts[i] + moves[i]) * step.unwrap_or(1.0)
    };
    for _ in 0..stepped.variables.len() {
        let broken = pairs
            .iter()
            .find(|(below, above)| value(&moves, *above) > value(&moves, *below) * (1.0 + 1e-9));
        match broken {
            None => break,
            Some((below, above)) if moves[*above] > 0.0 => moves[*below] += 1.0,
            Some((_, above)) => moves[*above] -= 1.0,
        }
    }
    moves
}

fn predicted(moves: Vec<f64>, sizes: &[f64], at: &Scaled) -> Option<Candidate> {
    let slopes = at.slopes.as_ref()?;
    let along = |row: &[f64]| -> f64 {
        let entries = row.iter().zip(&moves).zip(sizes);
        entries.map(|((slope, by), size)| slope * by * size).sum()
    };
    let limits = at.limits.iter().zip(&slopes.limits);
    let violation = violation(limits.map(|(value, row)| value + along(row)));
    Some(Candidate {
        mass: along(&slopes.mass),
        violation,
        moves,
    })
}
