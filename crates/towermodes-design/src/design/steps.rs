//! Values in steps, such as plate thicknesses: the minimum is rounded, repaired and improved by
//! single steps and exchanges of two, whose effect the derivatives predict.

use towermodes::Parameter;

use super::error::DesignError;
use super::limits::Limit;
use super::minimum::{MET, least_mass};
use super::scaled::{Scale, Scaled};

/// Moves of one search.
const MOST_MOVES: usize = 200;
/// Predicted improvements that are computed exactly before the search ends.
const MOST_TRIALS: usize = 30;
/// A predicted limit may be this wrong, relatively.
const PREDICTION: f64 = 2e-3;
/// A repair reduces the violation at least to this share.
const LEAST_GAIN: f64 = 1.0 - 1e-6;

/// The variables with steps, and the steps at which they are.
struct Stepped {
    variables: Vec<usize>,
    /// Multiples of the step.
    counts: Vec<f64>,
}

/// Scaled values in which every variable with a step has a multiple of it, with all limits met;
/// none if the search finds none.
pub(super) fn in_steps(
    scale: &mut Scale<'_>,
    minimum: &[f64],
) -> Result<Option<Vec<f64>>, DesignError> {
    let is_stepped = |i: &usize| scale.problem.variables[*i].step.is_some();
    let all = 0..scale.problem.variables.len();
    let (variables, others): (Vec<usize>, Vec<usize>) = all.partition(is_stepped);
    for rounding in [f64::round, f64::ceil, f64::floor] {
        let stepped = Stepped::rounded(scale, variables.clone(), minimum, rounding);
        let found = search(scale, stepped, &others, minimum)?;
        if found.is_some() {
            return Ok(found);
        }
    }
    Ok(None)
}

/// The search from a rounded minimum; `others` are the variables without steps.
fn search(
    scale: &mut Scale<'_>,
    mut stepped: Stepped,
    others: &[usize],
    minimum: &[f64],
) -> Result<Option<Vec<f64>>, DesignError> {
    let mut scaled = minimum.to_vec();
    stepped.put_into(&mut scaled, scale);
    let mut best: Option<(Vec<f64>, f64)> = None;
    /// Searches between which the other variables are optimized again.
    const MOST_ROUNDS: usize = 4;
    for _ in 0..MOST_ROUNDS {
        scale.set_free(stepped.variables.clone());
        let is_met = repair(scale, &mut stepped, &mut scaled)?;
        if is_met {
            improve(scale, &mut stepped, &mut scaled)?;
        }
        let mut is_feasible = is_met;
        if !others.is_empty() {
            scale.set_free(others.to_vec());
            let found = least_mass(scale, std::slice::from_ref(&scaled))?;
            is_feasible = found.is_feasible();
            scaled = found.scaled;
        }
        let mass = scale.at(&scaled, false)?.mass;
        let is_better = best.as_ref().is_none_or(|(_, least)| mass < least - 1e-9);
        if !is_feasible || !is_better {
            break;
        }
        best = Some((scaled.clone(), mass));
        if others.is_empty() {
            break;
        }
    }
    Ok(best.map(|(scaled, _)| scaled))
}

impl Stepped {
    fn rounded(
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

    fn put_into(&self, scaled: &mut [f64], scale: &Scale<'_>) {
        for (&i, count) in self.variables.iter().zip(&self.counts) {
            let variable = &scale.problem.variables[i];
            let value = multiple(*count, variable.step.unwrap_or(1.0));
            scaled[i] = (value - variable.low) / (variable.high - variable.low);
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

    fn moved(&self, moves: &[f64]) -> Self {
        Self {
            variables: self.variables.clone(),
            counts: self.counts.iter().zip(moves).map(|(a, b)| a + b).collect(),
        }
    }

    /// The change of each scaled variable per step.
    fn sizes(&self, scale: &Scale<'_>) -> Vec<f64> {
        let size = |i: &usize| {
            let variable = &scale.problem.variables[*i];
            variable.step.unwrap_or(1.0) / (variable.high - variable.low)
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
struct Candidate {
    moves: Vec<f64>,
    /// Change of the scaled mass.
    mass: f64,
    /// Sum of the violations after it.
    violation: f64,
}

fn violation(limits: impl Iterator<Item = f64>) -> f64 {
    limits.map(|limit| (limit - MET).max(0.0)).sum()
}

/// Moves until all limits are met; false if no move helps.
fn repair(
    scale: &mut Scale<'_>,
    stepped: &mut Stepped,
    scaled: &mut [f64],
) -> Result<bool, DesignError> {
    'moves: for _ in 0..MOST_MOVES {
        let at = scale.at(scaled, true)?.clone();
        let now = violation(at.limits.iter().copied());
        if now == 0.0 {
            return Ok(true);
        }
        let mut all = candidates(scale, stepped, &at);
        all.retain(|one| one.violation < now * LEAST_GAIN);
        // The cheapest of those that meet all limits, then those that cost least per violation.
        let cost = |one: &Candidate| match one.violation == 0.0 {
            true => (0, one.mass),
            false => (1, one.mass.max(1e-12) / (now - one.violation)),
        };
        all.sort_by(|a, b| {
            let (a, b) = (cost(a), cost(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        for one in all.iter().take(MOST_TRIALS) {
            let trial = stepped.moved(&one.moves);
            let mut next = scaled.to_vec();
            trial.put_into(&mut next, scale);
            let after = violation(scale.at(&next, false)?.limits.iter().copied());
            if after < now * LEAST_GAIN {
                *stepped = trial;
                scaled.copy_from_slice(&next);
                continue 'moves;
            }
        }
        return Ok(false);
    }
    Ok(false)
}

/// Moves that reduce the mass and violate nothing, until there are none.
fn improve(
    scale: &mut Scale<'_>,
    stepped: &mut Stepped,
    scaled: &mut [f64],
) -> Result<(), DesignError> {
    'moves: for _ in 0..MOST_MOVES {
        let at = scale.at(scaled, true)?.clone();
        let mut all = candidates(scale, stepped, &at);
        all.retain(|one| one.mass < -1e-9 && one.violation < PREDICTION);
        all.sort_by(|a, b| a.mass.total_cmp(&b.mass));
        for one in all.iter().take(MOST_TRIALS) {
            let trial = stepped.moved(&one.moves);
            let mut next = scaled.to_vec();
            trial.put_into(&mut next, scale);
            let of_next = scale.at(&next, false)?;
            let is_met = of_next.limits.iter().all(|limit| *limit <= MET);
            if is_met && of_next.mass < at.mass {
                *stepped = trial;
                scaled.copy_from_slice(&next);
                continue 'moves;
            }
        }
        return Ok(());
    }
    Ok(())
}

/// One step of one variable, and of two in opposite directions. Where that would break an order of
/// numbers, the neighbours move along.
fn candidates(scale: &Scale<'_>, stepped: &Stepped, at: &Scaled) -> Vec<Candidate> {
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
