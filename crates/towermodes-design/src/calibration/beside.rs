//! Start values next to a stationary start, at which the frequencies do not change with an unknown
//! to first order.
//!
//! A tower that is symmetric about a plane has a stationary frequency: if the centre of mass of the
//! RNA is at y = 0, the derivative with respect to y is 0, although a larger change of y changes
//! the frequency. Such a start is a stationary point of the sum of squares, and often a local
//! maximum.

use super::determined::NO_EFFECT;
use super::error::CalibrationError;
use super::fit::{Found, fit};
use super::point::{Point, Towers};

/// The step away from the start, relative to the known size of the unknown: the standard deviation
/// of its prior, otherwise the width of its bounds, otherwise its value; for a logarithm relative
/// to 1.
const STEP: f64 = 0.25;
/// A step that gives no possible tower is halved at most this many times.
const MOST_HALVINGS: usize = 10;
/// Relative changes of a frequency below this are rounding.
const ROUNDING: f64 = 1e-9;
/// A fit that ends nearer to the start than this, relative to the step, has returned to the start.
const BACK: f64 = 0.01;

/// The best fit from the start and, if the start is stationary in some unknowns, from a point next
/// to it. The unknowns are increased, if their bounds allow it.
pub(super) fn fit_beside(
    towers: &mut Towers<'_>,
    start: &Point,
) -> Result<Found, CalibrationError> {
    let mut beside = start.x.clone();
    for (j, beside) in beside.iter_mut().enumerate() {
        if !is_stationary(towers, start, j) {
            continue;
        }
        let moved = moved(towers, start, j);
        towers.has_effect[j] = moved.is_some();
        *beside = moved.unwrap_or(*beside);
    }
    if beside == start.x {
        return fit(towers, &start.x);
    }
    let from_beside = fit(towers, &beside);
    let is_back = |found: &Found| {
        let all = found.point.x.iter().zip(&start.x).zip(&beside);
        let mut moving = all.filter(|((_, start), beside)| start != beside);
        moving.all(|((x, start), beside)| (x - start).abs() <= BACK * (beside - start).abs())
    };
    match (fit(towers, &start.x), from_beside) {
        // The start is the minimum.
        (of_start, Ok(other)) if is_back(&other) => of_start,
        (Ok(of_start), Ok(other)) if of_start.point.chi_square() <= other.point.chi_square() => {
            Ok(of_start)
        }
        (Ok(of_start), Err(_)) => Ok(of_start),
        (_, from_beside) => from_beside,
    }
}

/// Whether no measured frequency changes with an unknown of known size to first order.
fn is_stationary(towers: &Towers<'_>, start: &Point, j: usize) -> bool {
    let data = start.frequencies_hz.len();
    let changes = start.columns[j].iter().take(data);
    let change = changes.fold(0.0_f64, |sum, change| sum.hypot(*change));
    match towers.variables[j].scale {
        Some(scale) => change * scale <= NO_EFFECT,
        None => false,
    }
}

/// The coordinate of an unknown one step away from the start, if this step changes a measured
/// frequency.
fn moved(towers: &mut Towers<'_>, start: &Point, j: usize) -> Option<f64> {
    let [low, high] = towers.variables[j].bounds;
    let mut step = STEP * towers.variables[j].scale?;
    for _ in 0..MOST_HALVINGS {
        for coordinate in [start.x[j] + step, start.x[j] - step] {
            let mut x = start.x.clone();
            x[j] = coordinate;
            let is_within = (low..=high).contains(&coordinate);
            let there = is_within.then(|| towers.evaluate(&x));
            if let Some(Ok(there)) = there {
                return is_moved(start, &there).then_some(coordinate);
            }
        }
        step *= 0.5;
    }
    None
}

fn is_moved(start: &Point, there: &Point) -> bool {
    let hz = start.frequencies_hz.iter().zip(&there.frequencies_hz);
    let deviations = start.residuals.iter().zip(&there.residuals);
    let mut all = hz.zip(deviations);
    all.any(|((before, after), (residual, residual_there))| {
        (after - before).abs() > ROUNDING * before && (residual_there - residual).abs() > NO_EFFECT
    })
}
