//! The first-order conditions of a minimum (Karush, Kuhn and Tucker).
//!
//! At a local minimum the gradient of the mass is −Σ λᵢ ∇gᵢ with the gradients of the active limits
//! and λᵢ ≥ 0 (Nocedal & Wright, Numerical Optimization, 2006, theorem 12.1). The multipliers are
//! found from the exact gradients by nonnegative least squares, independently of the optimizer.

use super::limits::Limit;
use super::nonnegative::{nonnegative, residual};
use super::problem::Side;
use super::towers::{Point, Slopes, Towers};

/// A limit is active if its scaled distance is smaller than this.
const ACTIVE: f64 = 1e-6;
/// The same tolerance for the bound of a variable.
const ACTIVE_BOUND: f64 = 1e-8;

/// The quantity that is minimized.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Least {
    /// The mass, within all limits.
    Mass,
    /// The largest violation of a frequency, within the limits of the shape.
    FrequencyViolation,
    /// The largest violation of a limit of the shape; frequencies are then not considered.
    ShapeViolation,
}

impl Optimality {
    /// No multipliers and an infinite residual.
    pub(super) fn none() -> Self {
        Self {
            active: Vec::new(),
            residual: f64::INFINITY,
        }
    }
}

impl Least {
    /// Whether a limit may be violated by the minimized violation.
    pub(super) fn relaxes(self, limit: &Limit) -> bool {
        let is_frequency = matches!(limit, Limit::Frequency { .. });
        match self {
            Self::Mass => false,
            Self::FrequencyViolation => is_frequency,
            Self::ShapeViolation => !is_frequency,
        }
    }

    /// Whether a limit is considered in this minimization.
    pub(super) fn counts(self, limit: &Limit) -> bool {
        self != Self::ShapeViolation || self.relaxes(limit)
    }
}

/// The multipliers of the active limits, and the residual of the conditions with them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Optimality {
    /// The active limits with their scaled multipliers.
    pub(super) active: Vec<(Limit, f64)>,
    /// |∇m + Σ λᵢ ∇gᵢ| / |∇m| in scaled variables.
    pub(super) residual: f64,
}

/// The first-order conditions of the least mass, or of the least violation (`violation`), with
/// respect to the free variables.
pub(super) fn optimality(
    towers: &Towers<'_>,
    slopes: &Slopes,
    (at, scaled): (&Point, &[f64]),
    free: &[usize],
    (least, violation): (Least, f64),
) -> Optimality {
    let of_free = |row: &[f64]| free.iter().map(|i| row[*i]).collect::<Vec<f64>>();
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut active: Vec<Limit> = Vec::new();
    for ((limit, value), slope) in towers.limits.iter().zip(&at.limits).zip(&slopes.limits) {
        let is_relaxed = least.relaxes(limit);
        let distance = value - if is_relaxed { violation } else { 0.0 };
        if least.counts(limit) && distance >= -ACTIVE {
            let mut column = of_free(slope);
            column.push(if is_relaxed { -1.0 } else { 0.0 });
            columns.push(column);
            active.push(*limit);
        }
    }
    for (place, &variable) in free.iter().enumerate() {
        let below = scaled[variable];
        let above = towers.highest[variable] - below;
        for (side, sign, distance) in [(Side::Lowest, -1.0, below), (Side::Highest, 1.0, above)] {
            if distance <= ACTIVE_BOUND {
                let mut column = vec![0.0; free.len() + 1];
                column[place] = sign;
                columns.push(column);
                active.push(Limit::Bound { variable, side });
            }
        }
    }
    let mut target: Vec<f64> = match least {
        Least::Mass => of_free(&slopes.mass).iter().map(|slope| -slope).collect(),
        _ => vec![0.0; free.len()],
    };
    target.push(if least == Least::Mass { 0.0 } else { -1.0 });
    let multipliers = nonnegative(&columns, &target);
    let rest = residual(&columns, &multipliers, &target);
    let size = |v: &[f64]| v.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    let residual = size(&rest) / size(&target).max(f64::MIN_POSITIVE);
    Optimality {
        active: active.into_iter().zip(multipliers).collect(),
        // What overflows says nothing.
        residual: match residual.is_nan() {
            true => f64::INFINITY,
            false => residual,
        },
    }
}
