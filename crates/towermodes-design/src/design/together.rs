//! Variables with steps beside others: a move of steps is judged by the mass after the others are
//! optimized again.

use super::error::DesignError;
use super::limits::Limit;
use super::minimum::{Least, MET, from_near};
use super::moves::{Stepped, candidates};
use super::optimality::optimality;
use super::scaled::{Scale, Scaled};

/// Moves of one search.
const MOST_MOVES: usize = 50;
/// Moves that are tried from one point.
const MOST_TRIALS: usize = 40;
/// Solves of one search, about a second for a large tower.
const MOST_SOLVES: usize = 1500;
/// Solves of a trial, which begins near its end.
const MOST_SOLVES_OF_TRIAL: usize = 40;
/// A move whose predicted change of the relative mass is above this is not tried: whole steps are
/// predicted to this accuracy.
const PREDICTION: f64 = 1e-5;
/// A smaller change of the relative mass is none.
const LEAST_GAIN: f64 = 1e-9;

/// Moves steps, with the other variables optimized after each move, until none that is predicted
/// to reduce the mass does so; false if the search ended before. The limits are met before and
/// after.
pub(super) fn improve_together(
    scale: &mut Scale<'_>,
    stepped: &mut Stepped,
    others: &[usize],
    scaled: &mut Vec<f64>,
) -> Result<bool, DesignError> {
    let last = scale.solves + MOST_SOLVES;
    'moves: for _ in 0..MOST_MOVES {
        let (at, rows) = with_multipliers(scale, stepped, others, scaled)?;
        let mut all = candidates(scale, stepped, &at);
        all.retain(|one| one.mass < PREDICTION);
        all.sort_by(|a, b| a.mass.total_cmp(&b.mass));
        all.dedup_by(|a, b| a.moves == b.moves);
        for one in all.iter().take(MOST_TRIALS) {
            if scale.solves > last {
                return Ok(false);
            }
            let trial = stepped.moved(&one.moves);
            let mut next = scaled.clone();
            trial.put_into(&mut next, scale);
            scale.set_free(others.to_vec());
            if !can_be_met(scale, &next, (others, &rows)) {
                continue;
            }
            // A tower that cannot be solved is no improvement.
            let Ok(found) = from_near(scale, &next, MOST_SOLVES_OF_TRIAL) else {
                continue;
            };
            if found.is_feasible() && found.mass < at.mass - LEAST_GAIN {
                *stepped = trial;
                *scaled = found.scaled;
                continue 'moves;
            }
        }
        return Ok(all.len() <= MOST_TRIALS);
    }
    Ok(false)
}

/// The point with the derivatives with respect to the variables with steps, in which the mass is
/// that after the others are optimized again: dm/ds + Σ λᵢ dgᵢ/ds with the multipliers of the
/// others; and the derivatives of the limits with respect to the others.
fn with_multipliers(
    scale: &mut Scale<'_>,
    stepped: &Stepped,
    others: &[usize],
    scaled: &[f64],
) -> Result<(Scaled, Vec<Vec<f64>>), DesignError> {
    scale.set_free(others.to_vec());
    let of_others = scale.at(scaled, true)?.clone();
    let proof = optimality(
        &of_others,
        &scale.limits,
        others,
        [scaled, &scale.highest],
        (Least::Mass, 0.0),
    );
    scale.set_free(stepped.variables.clone());
    let mut at = scale.at(scaled, true)?.clone();
    if let Some(slopes) = &mut at.slopes {
        for (limit, row) in scale.limits.iter().zip(&slopes.limits) {
            let of_limit = proof.active.iter().find(|(active, _)| active == limit);
            let Some((_, multiplier)) = of_limit else {
                continue;
            };
            let entries = slopes.mass.iter_mut().zip(row);
            entries.for_each(|(mass, slope)| *mass += multiplier * slope);
        }
    }
    let rows = of_others.slopes.map(|slopes| slopes.limits);
    Ok((at, rows.unwrap_or_default()))
}

/// Whether the others, within their bounds, can meet each limit of the shape, which is linear in
/// them with these rows.
fn can_be_met(
    scale: &mut Scale<'_>,
    scaled: &[f64],
    (others, rows): (&[usize], &[Vec<f64>]),
) -> bool {
    let Ok(at) = scale.at(scaled, false) else {
        return false;
    };
    let values = at.limits.clone();
    let least = |row: &[f64]| -> f64 {
        let ends = row.iter().zip(others);
        ends.map(|(slope, &i)| (slope * -scaled[i]).min(slope * (scale.highest[i] - scaled[i])))
            .sum()
    };
    let mut limits = scale.limits.iter().zip(values).zip(rows);
    limits.all(|((limit, value), row)| {
        matches!(limit, Limit::Frequency { .. }) || value + least(row) <= MET
    })
}

/// The present values, if they are in steps, meet all limits and make a lighter tower than `found`.
pub(super) fn lighter_present(
    scale: &mut Scale<'_>,
    stepped: &Stepped,
    present: &[f64],
    found: &[f64],
) -> Result<Option<Vec<f64>>, DesignError> {
    /// Of the range of a variable.
    const ROUNDING: f64 = 1e-9;
    let mut in_steps = present.to_vec();
    stepped.put_into(&mut in_steps, scale);
    let mut pairs = present.iter().zip(&in_steps);
    if pairs.any(|(a, b)| (a - b).abs() > ROUNDING) {
        return Ok(None);
    }
    let least = scale.at(found, false)?.mass;
    // A present tower that cannot be solved is not lighter.
    let Ok(at) = scale.at(&in_steps, false) else {
        return Ok(None);
    };
    let is_met = at.limits.iter().all(|limit| *limit <= MET);
    Ok((is_met && at.mass < least).then_some(in_steps))
}
