//! Several numbers side by side, for vectors of one chain that are treated in step.
//!
//! Each operation of an elimination waits for the one before. Operations of other vectors, or of
//! matrices with other shifts, fill the waiting time. Each lane has the operations of a single
//! number, so its result is equal to that of a single number, bit for bit.

use std::ops::{Add, AddAssign, Mul, Sub, SubAssign};

use wide::f64x4;

use crate::scalar::Number;

/// One number or several.
pub trait Lanes: Number {
    /// 1/x.
    #[must_use]
    fn inverse(self) -> Self;

    /// −`tiny` if |x| < `tiny`, else x.
    #[must_use]
    fn off_zero(self, tiny: f64) -> Self;

    /// Whether all are zero.
    fn are_zero(self) -> bool;

    /// 1 if x < 0, else 0.
    #[must_use]
    fn one_if_negative(self) -> Self;

    /// The number in a lane.
    fn lane(self, lane: usize) -> f64;
}

impl Lanes for f64 {
    #[inline(always)]
    fn inverse(self) -> Self {
        1.0 / self
    }

    #[inline(always)]
    fn off_zero(self, tiny: f64) -> Self {
        if self.abs() < tiny { -tiny } else { self }
    }

    #[inline(always)]
    fn are_zero(self) -> bool {
        self == 0.0
    }

    #[inline(always)]
    fn one_if_negative(self) -> Self {
        if self < 0.0 { 1.0 } else { 0.0 }
    }

    #[inline(always)]
    fn lane(self, _lane: usize) -> f64 {
        self
    }
}

/// How many vectors are treated in step.
pub const LANES: usize = 4;

/// A number of each lane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Row(f64x4);

impl Row {
    /// The numbers of the lanes.
    pub fn new(lanes: [f64; LANES]) -> Self {
        Self(f64x4::new(lanes))
    }

    /// Sets the number of a lane.
    pub fn set(&mut self, lane: usize, x: f64) {
        self.0.as_mut_array()[lane] = x;
    }
}

impl Number for Row {
    #[inline(always)]
    fn real(value: f64) -> Self {
        Self(f64x4::splat(value))
    }

    #[inline(always)]
    fn times(self, factor: f64) -> Self {
        Self(self.0 * f64x4::splat(factor))
    }
}

impl Lanes for Row {
    #[inline(always)]
    fn inverse(self) -> Self {
        Self(f64x4::ONE / self.0)
    }

    #[inline(always)]
    fn off_zero(self, tiny: f64) -> Self {
        let is_tiny = self.0.abs().simd_lt(f64x4::splat(tiny));
        Self(is_tiny.bitselect(f64x4::splat(-tiny), self.0))
    }

    #[inline(always)]
    fn are_zero(self) -> bool {
        self.0 == f64x4::ZERO
    }

    #[inline(always)]
    fn one_if_negative(self) -> Self {
        Self(self.0.simd_lt(f64x4::ZERO) & f64x4::ONE)
    }

    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        self.0.as_array()[lane]
    }
}

impl Add for Row {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Row {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Row {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl AddAssign for Row {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.0 += other.0;
    }
}

impl SubAssign for Row {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        self.0 -= other.0;
    }
}
