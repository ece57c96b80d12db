//! Stepped values, such as plate thicknesses: the variables of a minimum are rounded to steps a few
//! at a time, and the result is improved by single steps and by exchanges of two steps, whose
//! effect the derivatives predict. The variables without steps are optimized again after each of
//! them.

use towermodes::Parameter;

use super::error::DesignError;
use super::limits::Limit;
use super::minimum::{MET, from_near};
use super::optimality::{Least, optimality};
use super::towers::Towers;

/// One of this many parts of the remaining variables is rounded to steps at a time, at least one
/// variable.
const PART: usize = 8;
/// Largest number of moves of one search.
const MOST_MOVES: usize = 200;
/// Largest number of solves of one search, about a second for a large tower.
const MOST_SOLVES: usize = 1500;
/// Largest number of solves of one optimization that begins near its result.
const MOST_SOLVES_NEAR: usize = 60;
/// A move is not tried if its predicted change of the relative mass is above this: the accuracy of
/// the prediction for whole steps.
const PREDICTED_MASS: f64 = 1e-5;
/// The relative error that a predicted limit may have.
const PREDICTED_LIMIT: f64 = 2e-4;
/// A smaller change of the relative mass counts as zero.
const LEAST_GAIN: f64 = 1e-9;

/// Scaled values in which every variable with a step is a multiple of it and all limits are met,
/// and whether no move is left that is predicted to be lighter; none if the search finds no such
/// values.
pub(super) fn in_steps(
    towers: &mut Towers<'_>,
    minimum: &[f64],
    present: &[f64],
) -> Result<Option<(Vec<f64>, bool)>, DesignError> {
    let (stepped, others) = parted(towers);
    let Some(mut found) = dive(towers, minimum, (&stepped, &others))? else {
        return Ok(None);
    };
    let mut is_searched = improve(towers, (&stepped, &others), &mut found)?;
    if let Some(mut lighter) = lighter_present(towers, &stepped, present, &found)? {
        is_searched = improve(towers, (&stepped, &others), &mut lighter)?;
        found = lighter;
    }
    Ok(Some((found, is_searched)))
}

/// The variables with steps, and the others.
pub(super) fn parted(towers: &Towers<'_>) -> (Vec<usize>, Vec<usize>) {
    let is_stepped = |i: &usize| towers.problem.variables[*i].step.is_some();
    (0..towers.problem.variables.len()).partition(is_stepped)
}

/// A multiple of a step, as the nearest number to its decimal form: 0.021 for 21 steps of 0.001.
pub(super) fn multiple(count: f64, step: f64) -> f64 {
    let per_unit = (1.0 / step).round();
    match (per_unit * step - 1.0).abs() < 1e-12 {
        true => count / per_unit,
        false => count * step,
    }
}

impl Towers<'_> {
    fn step(&self, variable: usize) -> f64 {
        self.problem.variables[variable].step.unwrap_or(1.0)
    }

    /// A scaled value as a number of steps.
    fn steps(&self, variable: usize, scaled: f64) -> f64 {
        let low = self.problem.variables[variable].low;
        (low + scaled * self.units[variable]) / self.step(variable)
    }

    /// The scaled value of this number of steps, or of the nearest number within the bounds.
    fn of_steps(&self, variable: usize, count: f64) -> f64 {
        let of = &self.problem.variables[variable];
        let [low, high] = of.multiples(self.step(variable));
        let value = multiple(count.clamp(low, high), self.step(variable));
        (value - of.low) / self.units[variable]
    }
}

/// Stepped values from the minimum without steps: the variables nearest to a step are rounded
/// first, while the others are optimized again. None if the limits cannot be met with the remaining
/// variables.
fn dive(
    towers: &mut Towers<'_>,
    minimum: &[f64],
    (stepped, others): (&[usize], &[usize]),
) -> Result<Option<Vec<f64>>, DesignError> {
    let mut scaled = minimum.to_vec();
    let mut loose = stepped.to_vec();
    while !loose.is_empty() {
        let from_step = |i: usize| {
            let steps = towers.steps(i, scaled[i]);
            (steps - steps.round()).abs()
        };
        loose.sort_by(|a, b| from_step(*a).total_cmp(&from_step(*b)));
        // Fewer at a time where that meets not all limits; one alone also at its other side.
        let mut count = loose.len().div_ceil(PART);
        let next = loop {
            let (now, later) = loose.split_at(count);
            let free = [later, others].concat();
            let sides: &[fn(f64) -> f64] = match count {
                1 => &[f64::round, f64::ceil, f64::floor],
                _ => &[f64::round],
            };
            let mut next = None;
            for rounded in sides {
                let mut trial = scaled.clone();
                for &i in now {
                    trial[i] = towers.of_steps(i, rounded(towers.steps(i, scaled[i])));
                }
                next = met_near(towers, trial, &free)?;
                if next.is_some() {
                    break;
                }
            }
            if next.is_some() || count == 1 {
                break next;
            }
            count = count.div_ceil(2);
        };
        let Some((next, _)) = next else {
            return Ok(None);
        };
        scaled = next;
        loose.drain(..count);
    }
    Ok(Some(scaled))
}

/// The least mass near a trial over the free variables with its values, if all limits are met.
fn met_near(
    towers: &mut Towers<'_>,
    trial: Vec<f64>,
    free: &[usize],
) -> Result<Option<(Vec<f64>, f64)>, DesignError> {
    if free.is_empty() {
        // A tower that cannot be solved meets no limits.
        let Ok(at) = towers.at(&trial, false) else {
            return Ok(None);
        };
        return Ok((at.violation() <= MET).then_some((trial, at.mass)));
    }
    let found = from_near(towers, &trial, free, MOST_SOLVES_NEAR).ok();
    let found = found.filter(|found| found.is_feasible());
    Ok(found.map(|found| (found.scaled, found.mass)))
}

/// Changes variables by steps, and optimizes the others after each move, until no move that is
/// predicted to reduce the mass does so; false if the search ended before. The limits are met
/// before and after.
fn improve(
    towers: &mut Towers<'_>,
    (stepped, others): (&[usize], &[usize]),
    scaled: &mut Vec<f64>,
) -> Result<bool, DesignError> {
    let last = towers.solves + MOST_SOLVES;
    'moves: for _ in 0..MOST_MOVES {
        let mass = towers.at(scaled, true)?.mass;
        for trial in lighter(towers, (stepped, others), scaled)? {
            if towers.solves > last {
                return Ok(false);
            }
            if let Some((next, lighter)) = met_near(towers, trial, others)?
                && lighter < mass - LEAST_GAIN
            {
                *scaled = next;
                continue 'moves;
            }
        }
        return Ok(true);
    }
    Ok(false)
}

/// The values after each single step and each exchange of two steps that is predicted to reduce the
/// mass and to meet the limits, the lightest first.
///
/// The prediction is linear. If there are variables without steps, the predicted mass is that after
/// their optimization, dm/ds + Σ λᵢ dgᵢ/ds with the multipliers λ of their minimum; only the limits
/// of the shape are checked, for the best values of these variables within their bounds.
fn lighter(
    towers: &mut Towers<'_>,
    (stepped, others): (&[usize], &[usize]),
    scaled: &[f64],
) -> Result<Vec<Vec<f64>>, DesignError> {
    let at = towers.at(scaled, true)?;
    let Some(slopes) = &at.slopes else {
        return Ok(Vec::new());
    };
    let mut mass = slopes.mass.clone();
    let reduced = optimality(towers, slopes, (&at, scaled), others, (Least::Mass, 0.0));
    for (limit, row) in towers.limits.iter().zip(&slopes.limits) {
        let of_limit = reduced.active.iter().find(|(active, _)| active == limit);
        let multiplier = of_limit.map_or(0.0, |(_, multiplier)| *multiplier);
        let entries = mass.iter_mut().zip(row);
        entries.for_each(|(mass, slope)| *mass += multiplier * slope);
    }
    let along = |row: &[f64], moved: &[f64]| -> f64 {
        let entries = stepped.iter().map(|&i| row[i] * (moved[i] - scaled[i]));
        entries.sum()
    };
    let can_be_met = |moved: &[f64]| {
        let mut limits = towers.limits.iter().zip(&at.limits).zip(&slopes.limits);
        limits.all(|((limit, value), row)| {
            let best = others.iter().map(|&i| {
                let ends = [-scaled[i], towers.highest[i] - scaled[i]];
                ends.map(|by| row[i] * by)
                    .into_iter()
                    .fold(f64::INFINITY, f64::min)
            });
            let is_open = matches!(limit, Limit::Frequency { .. }) && !others.is_empty();
            is_open || value + along(row, moved) + best.sum::<f64>() <= PREDICTED_LIMIT
        })
    };
    let moves = moves(towers, stepped, scaled).into_iter();
    let all = moves.map(|moved| (along(&mass, &moved), moved));
    let mut all: Vec<(f64, Vec<f64>)> = all
        .filter(|(mass, moved)| *mass < PREDICTED_MASS && can_be_met(moved))
        .collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.dedup_by(|a, b| a.1 == b.1);
    Ok(all.into_iter().map(|(_, moved)| moved).collect())
}

/// The values after one step of one variable, and of two in opposite directions, within the bounds.
/// If a step violates a required order of input values, the neighbours are changed too.
fn moves(towers: &Towers<'_>, stepped: &[usize], scaled: &[f64]) -> Vec<Vec<f64>> {
    let pairs = ordered(towers, stepped);
    let mut all = Vec::new();
    for &i in stepped {
        for by in [-1.0, 1.0] {
            // With itself: one step alone.
            for &j in stepped {
                let mut counts: Vec<f64> = (0..scaled.len())
                    .map(|k| towers.steps(k, scaled[k]))
                    .collect();
                counts[i] = counts[i].round() + by;
                if j != i {
                    counts[j] = counts[j].round() - by;
                }
                in_order(towers, &pairs, scaled, &mut counts);
                let mut moved = scaled.to_vec();
                for &k in stepped {
                    moved[k] = towers.of_steps(k, counts[k].round());
                }
                let is_within = stepped.iter().all(|&k| {
                    let [low, high] = towers.problem.variables[k].multiples(towers.step(k));
                    (low..=high).contains(&counts[k].round())
                });
                if is_within && moved != scaled {
                    all.push(moved);
                }
            }
        }
    }
    all
}

/// The variables of which the second must not exceed the first.
fn ordered(towers: &Towers<'_>, stepped: &[usize]) -> Vec<[usize; 2]> {
    let of = |number: &Parameter| {
        let mut all = stepped.iter().copied();
        all.find(|i| {
            towers.problem.variables[*i]
                .change
                .parameters()
                .contains(number)
        })
    };
    let pairs = towers.limits.iter().filter_map(|limit| match limit {
        Limit::Falling { below, above } => Some([of(below)?, of(above)?]),
        _ => None,
    });
    pairs.collect()
}

/// Changes the neighbours in a falling order with a move: after an increase those below, after a
/// decrease those above.
fn in_order(towers: &Towers<'_>, pairs: &[[usize; 2]], scaled: &[f64], counts: &mut [f64]) {
    let value = |counts: &[f64], i: usize| counts[i] * towers.step(i);
    for _ in 0..counts.len() {
        let broken = pairs
            .iter()
            .find(|[below, above]| value(counts, *above) > value(counts, *below) * (1.0 + 1e-9));
        match broken {
            None => break,
            Some(&[below, above]) if counts[above] > towers.steps(above, scaled[above]) + 0.5 => {
                counts[below] += 1.0;
            }
            Some(&[_, above]) => counts[above] -= 1.0,
        }
    }
}

/// The present values, if they are in steps, meet all limits and make a lighter tower than `found`.
fn lighter_present(
    towers: &mut Towers<'_>,
    stepped: &[usize],
    present: &[f64],
    found: &[f64],
) -> Result<Option<Vec<f64>>, DesignError> {
    /// Rounding error as a fraction of the range of a variable.
    const ROUNDING: f64 = 1e-9;
    let mut in_steps = present.to_vec();
    for &i in stepped {
        in_steps[i] = towers.of_steps(i, towers.steps(i, present[i]).round());
        if (in_steps[i] - present[i]).abs() > ROUNDING {
            return Ok(None);
        }
    }
    let least = towers.at(found, false)?.mass;
    let met = met_near(towers, in_steps, &[])?;
    Ok(met
        .filter(|(_, mass)| *mass < least)
        .map(|(present, _)| present))
}
