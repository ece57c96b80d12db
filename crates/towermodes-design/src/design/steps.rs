//! Values in steps, such as plate thicknesses: the minimum is rounded, repaired and improved by
//! single steps and exchanges of two, whose effect the derivatives predict.

use super::error::DesignError;
use super::minimum::{MET, least_mass};
use super::moves::{Candidate, Stepped, candidates, violation};
use super::scaled::Scale;
use super::together::{improve_together, lighter_present};

/// Moves of one search.
const MOST_MOVES: usize = 200;
/// Predicted improvements that are computed exactly before the search ends.
const MOST_TRIALS: usize = 30;
/// A predicted limit may be this wrong, relatively.
const PREDICTION: f64 = 2e-3;
/// A repair reduces the violation at least to this share.
const LEAST_GAIN: f64 = 1.0 - 1e-6;

/// Scaled values in which every variable with a step has a multiple of it, with all limits met;
/// none if the search finds none.
pub(super) fn in_steps(
    scale: &mut Scale<'_>,
    minimum: &[f64],
    present: &[f64],
) -> Result<Option<Vec<f64>>, DesignError> {
    let is_stepped = |i: &usize| scale.problem.variables[*i].step.is_some();
    let all = 0..scale.problem.variables.len();
    let (variables, others): (Vec<usize>, Vec<usize>) = all.partition(is_stepped);
    let mut found = None;
    for rounding in [f64::round, f64::ceil, f64::floor] {
        let stepped = Stepped::rounded(scale, variables.clone(), minimum, rounding);
        found = search(scale, stepped, &others, minimum)?;
        if found.is_some() {
            break;
        }
    }
    let Some(mut scaled) = found else {
        return Ok(None);
    };
    if !others.is_empty() {
        let mut stepped = Stepped::rounded(scale, variables.clone(), &scaled, f64::round);
        improve_together(scale, &mut stepped, &others, &mut scaled)?;
    }
    let mut stepped = Stepped::rounded(scale, variables, present, f64::round);
    let Some(mut lighter) = lighter_present(scale, &stepped, present, &scaled)? else {
        return Ok(Some(scaled));
    };
    match others.is_empty() {
        true => {
            scale.set_free(stepped.variables.clone());
            improve(scale, &mut stepped, &mut lighter)?;
        }
        false => improve_together(scale, &mut stepped, &others, &mut lighter)?,
    }
    Ok(Some(lighter))
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
