//! Values in steps, such as plate thicknesses: the minimum is brought into steps and improved by
//! single steps and exchanges of two, whose effect the derivatives predict.

use super::dive::dive;
use super::error::DesignError;
use super::minimum::{MET, from_near, least_mass};
use super::moves::{Candidate, Stepped, candidates, violation};
use super::scaled::Scale;
use super::together::{improve_together, lighter_present};

/// Moves of one search.
const MOST_MOVES: usize = 200;
/// Repairs that are computed exactly before the search ends.
const MOST_REPAIRS: usize = 30;
/// Predicted improvements that are computed exactly before the search ends.
const MOST_TRIALS: usize = 200;
/// A predicted limit may be this wrong, relatively.
const PREDICTION: f64 = 2e-4;
/// A repair reduces the violation at least to this share.
const LEAST_GAIN: f64 = 1.0 - 1e-6;

/// Scaled values in which every variable with a step has a multiple of it, with all limits met, and
/// whether no single change is left that is predicted to be lighter; none if the search finds none.
pub(super) fn in_steps(
    scale: &mut Scale<'_>,
    minimum: &[f64],
    present: &[f64],
) -> Result<Option<(Vec<f64>, bool)>, DesignError> {
    let (variables, others) = parted(scale);
    let mut found = dive(scale, minimum, &variables)?;
    for rounding in [f64::round, f64::ceil, f64::floor] {
        if found.is_some() {
            break;
        }
        let stepped = Stepped::rounded(scale, variables.clone(), minimum, rounding);
        found = search(scale, stepped, &others, minimum)?;
    }
    let Some(mut scaled) = found else {
        return Ok(None);
    };
    let mut is_searched = improved(scale, (&variables, &others), &mut scaled)?;
    let stepped = Stepped::rounded(scale, variables.clone(), present, f64::round);
    if let Some(mut lighter) = lighter_present(scale, &stepped, present, &scaled)? {
        is_searched = improved(scale, (&variables, &others), &mut lighter)?;
        scaled = lighter;
    }
    Ok(Some((scaled, is_searched)))
}

/// The variables with steps, and the others.
fn parted(scale: &Scale<'_>) -> (Vec<usize>, Vec<usize>) {
    let is_stepped = |i: &usize| scale.problem.variables[*i].step.is_some();
    (0..scale.problem.variables.len()).partition(is_stepped)
}

/// Moves steps while that reduces the mass; false if the search ended before.
fn improved(
    scale: &mut Scale<'_>,
    (variables, others): (&[usize], &[usize]),
    scaled: &mut Vec<f64>,
) -> Result<bool, DesignError> {
    let mut stepped = Stepped::rounded(scale, variables.to_vec(), scaled, f64::round);
    match others.is_empty() {
        true => {
            scale.set_free(variables.to_vec());
            improve(scale, &mut stepped, scaled)
        }
        false => improve_together(scale, &mut stepped, others, scaled),
    }
}

/// Scaled values near given ones that meet all limits after these were tightened by a little; none
/// if there are none.
pub(super) fn met_again(
    scale: &mut Scale<'_>,
    scaled: &[f64],
) -> Result<Option<Vec<f64>>, DesignError> {
    /// Solves of one search, which begins near its end.
    const MOST_SOLVES: usize = 150;
    let (variables, others) = parted(scale);
    if !others.is_empty() {
        scale.set_free(others);
        let moved = moved_within(scale, scaled)?;
        if moved.is_some() {
            return Ok(moved);
        }
        let found = from_near(scale, scaled, MOST_SOLVES)?;
        if found.is_feasible() || variables.is_empty() {
            return Ok(found.is_feasible().then_some(found.scaled));
        }
    }
    let mut scaled = scaled.to_vec();
    let mut stepped = Stepped::rounded(scale, variables.clone(), &scaled, f64::round);
    scale.set_free(variables);
    let is_met = repair(scale, &mut stepped, &mut scaled)?;
    Ok(is_met.then_some(scaled))
}

/// The free variables moved by a little, so that the limits are met to first order: to each limit
/// that is violated in turn, by the shortest way (Kaczmarz 1937).
fn moved_within(scale: &mut Scale<'_>, scaled: &[f64]) -> Result<Option<Vec<f64>>, DesignError> {
    /// Turns until the limits are given up.
    const MOST_TURNS: usize = 10_000;
    let at = scale.at(scaled, true)?.clone();
    let Some(slopes) = at.slopes else {
        return Ok(None);
    };
    let mut next = scaled.to_vec();
    for _ in 0..MOST_TURNS {
        let limits = at.limits.iter().zip(&slopes.limits);
        let values = limits.map(|(value, row)| {
            let moves = row.iter().zip(&scale.free);
            let change: f64 = moves.map(|(d, &i)| d * (next[i] - scaled[i])).sum();
            (value + change, row)
        });
        let worst = values.max_by(|a, b| a.0.total_cmp(&b.0));
        let Some((value, row)) = worst.filter(|(value, _)| *value > 0.0) else {
            return Ok(Some(next));
        };
        let square: f64 = row.iter().map(|d| d * d).sum();
        if square == 0.0 {
            return Ok(None);
        }
        for (d, &i) in row.iter().zip(&scale.free) {
            // A little further, so that the last turns end.
            let moved = next[i] - 1.001 * value * d / square;
            next[i] = moved.clamp(0.0, scale.highest[i]);
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
        for one in all.iter().take(MOST_REPAIRS) {
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

/// Moves that reduce the mass and violate nothing, until there are none; false if the search ended
/// before.
fn improve(
    scale: &mut Scale<'_>,
    stepped: &mut Stepped,
    scaled: &mut [f64],
) -> Result<bool, DesignError> {
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
        return Ok(all.len() <= MOST_TRIALS);
    }
    Ok(false)
}
