//! Values in steps by fixing a few variables at a time: those that are nearest to a step, while the
//! others are optimized again.

use super::error::DesignError;
use super::minimum::{MET, from_near};
use super::moves::Stepped;
use super::scaled::Scale;

/// Of the variables that are left this part is fixed at a time, one at least.
const PART: usize = 8;
/// Solves after each fixing, which begins near its end.
const MOST_SOLVES: usize = 60;

/// Scaled values in steps that meet all limits, from those of the minimum without steps; none if
/// the limits cannot be met with the variables that are left.
pub(super) fn dive(
    scale: &mut Scale<'_>,
    minimum: &[f64],
    stepped: &[usize],
) -> Result<Option<Vec<f64>>, DesignError> {
    let mut scaled = minimum.to_vec();
    let mut loose = stepped.to_vec();
    let mut fixed: Vec<usize> = Vec::new();
    while !loose.is_empty() {
        let values = scale.values(&scaled);
        let from_step = |i: usize| {
            let steps = values[i] / scale.problem.variables[i].step.unwrap_or(1.0);
            (steps - steps.round()).abs()
        };
        loose.sort_by(|a, b| from_step(*a).total_cmp(&from_step(*b)));
        let later = loose.split_off(loose.len().div_ceil(PART));
        match fixed_at_steps(scale, scaled, (&mut fixed, &loose))? {
            Some(next) => scaled = next,
            None => return Ok(None),
        }
        loose = later;
    }
    Ok(Some(scaled))
}

/// Fixes variables at the nearest steps; half of them at a time where that meets not all limits,
/// and one alone at the step on its other side.
fn fixed_at_steps(
    scale: &mut Scale<'_>,
    scaled: Vec<f64>,
    (fixed, now): (&mut Vec<usize>, &[usize]),
) -> Result<Option<Vec<f64>>, DesignError> {
    let before = fixed.len();
    fixed.extend(now);
    let sides: &[fn(f64) -> f64] = match now.len() {
        1 => &[f64::round, f64::ceil, f64::floor],
        _ => &[f64::round],
    };
    for rounding in sides {
        let mut trial = scaled.clone();
        Stepped::rounded(scale, now.to_vec(), &scaled, *rounding).put_into(&mut trial, scale);
        if let Some(next) = met_with(scale, trial, fixed)? {
            return Ok(Some(next));
        }
    }
    if now.len() < 2 {
        return Ok(None);
    }
    fixed.truncate(before);
    let (first, second) = now.split_at(now.len().div_ceil(2));
    match fixed_at_steps(scale, scaled, (fixed, first))? {
        Some(next) => fixed_at_steps(scale, next, (fixed, second)),
        None => Ok(None),
    }
}

/// The least mass with fixed variables, if the limits are met.
fn met_with(
    scale: &mut Scale<'_>,
    trial: Vec<f64>,
    fixed: &[usize],
) -> Result<Option<Vec<f64>>, DesignError> {
    let all = 0..scale.problem.variables.len();
    let free: Vec<usize> = all.filter(|i| !fixed.contains(i)).collect();
    if free.is_empty() {
        let at = scale.at(&trial, false)?;
        let is_met = at.limits.iter().all(|limit| *limit <= MET);
        return Ok(is_met.then_some(trial));
    }
    scale.set_free(free);
    // A tower that cannot be solved meets no limits.
    let found = from_near(scale, &trial, MOST_SOLVES).ok();
    let found = found.filter(|found| found.is_feasible());
    Ok(found.map(|found| found.scaled))
}
