//! Legendre polynomials, their integrals, and the Gauss points that integrate them exactly.

use std::f64::consts::PI;

/// P_k, I_k and J_k at a point ξ of [−1, 1], for k = 0, 1, 2, …
///
/// An element's strain is Σ c_k P_k(ξ); with I_k = ∫₋₁ P_k and J_k = ∫₋₁ I_k its rotation and its
/// deflection are sums of I_k and J_k. I_k vanishes at both ends from k = 1, J_k from k = 2: those
/// are the bubbles (1 − ξ²) and (1 − ξ²)² times a polynomial.
///
/// (k+1) P_{k+1} = (2k+1) ξ P_k − k P_{k−1}; (2k+1) I_k = P_{k+1} − P_{k−1}; (2k+1) J_k = I_{k+1} −
/// I_{k−1}; I₀ = ξ + 1, J₀ = (ξ + 1)²/2.
#[derive(Debug, Clone)]
pub struct Legendre {
    xi: f64,
    k: f64,
    /// P_k, P_{k+1}, P_{k+2}.
    values: [f64; 3],
    /// I_{k−1}, I_k, I_{k+1}.
    firsts: [f64; 3],
}

/// One polynomial and its integrals at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Term {
    /// P_k(ξ).
    pub value: f64,
    /// I_k(ξ).
    pub first: f64,
    /// J_k(ξ).
    pub second: f64,
}

impl Legendre {
    /// The terms at ξ from k = 0.
    pub fn at(xi: f64) -> Self {
        let square = 1.5 * xi * xi - 0.5;
        Self {
            xi,
            k: 0.0,
            values: [1.0, xi, square],
            firsts: [0.0, xi + 1.0, (square - 1.0) / 3.0],
        }
    }
}

impl Iterator for Legendre {
    type Item = Term;

    #[inline]
    fn next(&mut self) -> Option<Term> {
        let (k, [value, next, after]) = (self.k, self.values);
        let [below, first, above] = self.firsts;
        let second = if k == 0.0 {
            0.5 * first * first
        } else {
            (above - below) / (2.0 * k + 1.0)
        };
        let beyond = ((2.0 * k + 5.0) * self.xi * after - (k + 2.0) * next) / (k + 3.0);
        self.values = [next, after, beyond];
        self.firsts = [first, above, (beyond - next) / (2.0 * k + 5.0)];
        self.k += 1.0;
        Some(Term {
            value,
            first,
            second,
        })
    }
}

/// The Gauss-Legendre points and weights on [−1, 1], exact to degree 2·`count` − 1, from the left.
///
/// Newton's method on P_n from cos(π (i + 3/4)/(n + 1/2)), which lies next to the i-th root (Davis
/// & Rabinowitz 1984, ch. 2.7).
pub fn gauss_points(count: usize) -> Vec<(f64, f64)> {
    let n = count as f64;
    let mut points = vec![(0.0, 2.0); count];
    for i in 0..count.div_ceil(2) {
        let mut x = (PI * (i as f64 + 0.75) / (n + 0.5)).cos();
        let mut derivative = 1.0;
        // Quadratic convergence: the fourth step no longer changes anything, a few more cost
        // nothing.
        for _ in 0..6 {
            let (value, below) = legendre_pair(count, x);
            derivative = n * (x * value - below) / (x * x - 1.0);
            x -= value / derivative;
        }
        let weight = 2.0 / ((1.0 - x * x) * derivative * derivative);
        points[i] = (-x, weight);
        points[count - 1 - i] = (x, weight);
    }
    points
}

/// P_n(x) and P_{n−1}(x).
fn legendre_pair(count: usize, x: f64) -> (f64, f64) {
    let (mut value, mut below) = (1.0, 0.0);
    for k in 0..count {
        let n = k as f64;
        (value, below) = (((2.0 * n + 1.0) * x * value - n * below) / (n + 1.0), value);
    }
    (value, below)
}

#[cfg(test)]
mod tests {
    use super::{Legendre, gauss_points};

    #[test]
    fn gauss_points_integrate_powers_exactly() {
        for count in [1, 2, 3, 8, 21, 60] {
            let rule = gauss_points(count);
            for power in 0..2 * count {
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(power as i32)).sum();
                let exact = if power % 2 == 0 {
                    2.0 / (power as f64 + 1.0)
                } else {
                    0.0
                };
                assert!((sum - exact).abs() < 1e-13, "{count} points, x^{power}");
            }
        }
    }

    #[test]
    fn integrals_are_the_integrals_of_the_polynomials() {
        for xi in [-1.0, -0.3, 0.9, 1.0] {
            let half = 0.5 * (xi + 1.0);
            for (k, at) in Legendre::at(xi).take(9).enumerate() {
                let (mut first, mut second) = (0.0, 0.0);
                for (x, w) in gauss_points(12) {
                    let inner = Legendre::at(half * (x + 1.0) - 1.0)
                        .nth(k)
                        .expect("endless");
                    first += half * w * inner.value;
                    second += half * w * inner.first;
                }
                assert!((at.first - first).abs() < 1e-14, "I_{k}({xi})");
                assert!((at.second - second).abs() < 1e-14, "J_{k}({xi})");
            }
        }
        let fourth = Legendre::at(0.3).nth(4).expect("endless").value;
        let exact = (35.0 * 0.3_f64.powi(4) - 30.0 * 0.09 + 3.0) / 8.0;
        assert!((fourth - exact).abs() < 1e-15);
    }
}
