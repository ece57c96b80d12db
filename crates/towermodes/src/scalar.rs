//! Numbers as entries of vectors and matrices: real, complex, or several side by side.

use std::iter::Sum;
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// A complex number re + i im.
///
/// # Example
/// ```
/// use towermodes::turbine::Complex;
///
/// let i = Complex::new(0.0, 1.0);
/// assert_eq!(i * i, Complex::new(-1.0, 0.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Complex {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
}

impl Complex {
    /// re + i im.
    #[inline]
    pub const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    /// |x|² = re² + im².
    #[inline]
    pub const fn norm_squared(self) -> f64 {
        self.re * self.re + self.im * self.im
    }
}

/// An entry of a vector or matrix.
pub trait Number:
    Copy
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + AddAssign
    + SubAssign
{
    /// A real number.
    fn real(value: f64) -> Self;

    /// The product with a real number.
    #[must_use]
    fn times(self, factor: f64) -> Self;
}

/// An entry of a Hermitian matrix: real, or complex.
///
/// A matrix that is real is then symmetric, and its conjugate transpose is its transpose, so that
/// one algorithm serves both.
pub trait Scalar: Number + Sum {
    /// The real part.
    fn re(self) -> f64;

    /// The conjugate.
    #[must_use]
    fn conj(self) -> Self;

    /// The quotient by a real number.
    #[must_use]
    fn over(self, divisor: f64) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn real(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn times(self, factor: f64) -> Self {
        self * factor
    }
}

impl Scalar for f64 {
    #[inline]
    fn re(self) -> f64 {
        self
    }

    #[inline]
    fn conj(self) -> Self {
        self
    }

    #[inline]
    fn over(self, divisor: f64) -> Self {
        self / divisor
    }
}

impl Number for Complex {
    #[inline]
    fn real(value: f64) -> Self {
        Self::new(value, 0.0)
    }

    #[inline]
    fn times(self, factor: f64) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }
}

impl Scalar for Complex {
    #[inline]
    fn re(self) -> f64 {
        self.re
    }

    #[inline]
    fn conj(self) -> Self {
        Self::new(self.re, -self.im)
    }

    #[inline]
    fn over(self, divisor: f64) -> Self {
        self.times(1.0 / divisor)
    }
}

impl Add for Complex {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl Sub for Complex {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Mul for Complex {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.re * other.re - self.im * other.im,
            self.re * other.im + self.im * other.re,
        )
    }
}

impl Neg for Complex {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}

impl AddAssign for Complex {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Complex {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Sum for Complex {
    #[inline]
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Self::default(), Add::add)
    }
}
