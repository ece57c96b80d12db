//! Checks of single values: finite, of a possible sign, and of a magnitude that permits
//! computation.

use crate::tower::error::{Place, Problem, TowerError};

/// Smallest and largest magnitude of nonzero values, in SI units: products of several values stay
/// far from the limits of double precision.
const SIZES: [f64; 2] = [1e-30, 1e30];
/// Smallest and largest length, m: fourth powers of lengths are in every stiffness.
const LENGTHS_M: [f64; 2] = [1e-15, 1e9];

pub(super) fn error<T>(place: Place, problem: Problem) -> Result<T, TowerError> {
    Err(TowerError { place, problem })
}

/// Checks that a value is finite, positive, negative or zero.
pub(super) fn finite(
    place: Place,
    quantity: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<(), TowerError> {
    in_scale(place, quantity, value, unit, [0.0, SIZES[1]])
}

/// Checks a height or another coordinate, m: finite, positive, negative or zero.
pub(super) fn coordinate(
    place: Place,
    quantity: &'static str,
    value_m: f64,
) -> Result<(), TowerError> {
    in_scale(place, quantity, value_m, " m", [0.0, LENGTHS_M[1]])
}

/// Checks that a length, m, is positive.
pub(super) fn length(place: Place, quantity: &'static str, value_m: f64) -> Result<(), TowerError> {
    above_zero(place, quantity, value_m, " m")?;
    in_scale(place, quantity, value_m, " m", LENGTHS_M)
}

pub(super) fn positive(
    place: Place,
    quantity: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<(), TowerError> {
    above_zero(place, quantity, value, unit)?;
    in_scale(place, quantity, value, unit, SIZES)
}

pub(super) fn not_negative(
    place: Place,
    quantity: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<(), TowerError> {
    if value == 0.0 {
        return Ok(());
    }
    in_scale(place, quantity, value, unit, [0.0, SIZES[1]])?;
    if value > 0.0 {
        return in_scale(place, quantity, value, unit, SIZES);
    }
    let problem = Problem::Negative {
        quantity,
        value,
        unit,
    };
    error(place, problem)
}

/// Checks a stiffness to the ground: not negative, and of any finite magnitude, because unknowns
/// are scaled with the springs; a very large one is rigid.
pub(super) fn stiffness(
    place: Place,
    quantity: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<(), TowerError> {
    if !value.is_finite() {
        return error(place, Problem::NotFinite { quantity, value });
    }
    if value >= 0.0 {
        return Ok(());
    }
    let problem = Problem::Negative {
        quantity,
        value,
        unit,
    };
    error(place, problem)
}

pub(super) fn above_zero(
    place: Place,
    quantity: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<(), TowerError> {
    if value > 0.0 || !value.is_finite() {
        return Ok(());
    }
    let problem = Problem::NotPositive {
        quantity,
        value,
        unit,
    };
    error(place, problem)
}

fn in_scale(
    place: Place,
    quantity: &'static str,
    value: f64,
    unit: &'static str,
    [least, most]: [f64; 2],
) -> Result<(), TowerError> {
    if !value.is_finite() {
        return error(place, Problem::NotFinite { quantity, value });
    }
    if (least..=most).contains(&value.abs()) {
        return Ok(());
    }
    let problem = Problem::OutOfScale {
        quantity,
        value,
        unit,
        least: least.max(SIZES[0]),
        most,
    };
    error(place, problem)
}
