//! The proof of a minimum by the conditions of Karush, Kuhn and Tucker.
//!
//! At a minimum the gradient of the mass is a combination −Σ λᵢ ∇gᵢ of those of the active limits
//! with λᵢ ≥ 0 (Nocedal & Wright, Numerical Optimization, 2006, theorem 12.1). The multipliers are
//! found from the exact gradients by nonnegative least squares, independently of the optimizer.

use super::limits::Limit;
use super::minimum::{Least, is_relaxed};
use super::nonnegative::{nonnegative, residual};
use super::problem::Side;
use super::scaled::Scaled;

/// A limit nearer than this, scaled, is active.
const ACTIVE: f64 = 1e-6;
/// The same of a bound. The optimizer ends on bounds exactly, and a unit may be ten times the
/// value.
const ACTIVE_BOUND: f64 = 1e-8;

/// The multipliers of the active limits, and how well they prove the minimum.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Optimality {
    /// The active limits with their scaled multipliers.
    pub(super) active: Vec<(Limit, f64)>,
    /// |∇m + Σ λᵢ ∇gᵢ| / |∇m| in scaled variables.
    pub(super) residual: f64,
}

/// The proof of the minimum of the mass, or of the violation, which is given, at a point with its
/// upper bounds.
pub(super) fn optimality(
    at: &Scaled,
    limits: &[Limit],
    free: &[usize],
    [scaled, highest]: [&[f64]; 2],
    (least, violation): (Least, f64),
) -> Optimality {
    let Some(slopes) = &at.slopes else {
        return Optimality {
            active: Vec::new(),
            residual: f64::INFINITY,
        };
    };
    let count = free.len();
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut active: Vec<Limit> = Vec::new();
    for ((limit, value), slope) in limits.iter().zip(&at.limits).zip(&slopes.limits) {
        let is_relaxed = is_relaxed(limit, least);
        let is_kept = least != Least::ShapeViolation || is_relaxed;
        let distance = value - if is_relaxed { violation } else { 0.0 };
        if is_kept && distance >= -ACTIVE {
            let mut column = slope.clone();
            column.push(if is_relaxed { -1.0 } else { 0.0 });
            columns.push(column);
            active.push(*limit);
        }
    }
    for (place, &variable) in free.iter().enumerate() {
        let sides = [(Side::Lowest, -1.0), (Side::Highest, 1.0)];
        for (side, sign) in sides {
            let distance = match side {
                Side::Lowest => scaled[variable],
                Side::Highest => highest[variable] - scaled[variable],
            };
            if distance <= ACTIVE_BOUND {
                let mut column = vec![0.0; count + 1];
                column[place] = sign;
                columns.push(column);
                active.push(Limit::Bound { variable, side });
            }
        }
    }
    let mut target: Vec<f64> = match least {
        Least::Mass => slopes.mass.iter().map(|slope| -slope).collect(),
        _ => vec![0.0; count],
    };
    target.push(if least == Least::Mass { 0.0 } else { -1.0 });
    let multipliers = nonnegative(&columns, &target);
    let rest = residual(&columns, &multipliers, &target);
    let size = |v: &[f64]| v.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    let residual = size(&rest) / size(&target).max(f64::MIN_POSITIVE);
    Optimality {
        active: active.into_iter().zip(multipliers).collect(),
        // What overflows proves nothing.
        residual: match residual.is_nan() {
            true => f64::INFINITY,
            false => residual,
        },
    }
}
