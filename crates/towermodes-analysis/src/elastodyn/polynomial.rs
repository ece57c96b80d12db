//! The polynomials that ElastoDyn uses for mode shapes.

/// A mode shape φ(x) = Σ cₖ xᵏ, k = 2 to 6. The height x is a fraction of the flexible tower, 0 at
/// its base and 1 at its top.
///
/// Deflection and slope are 0 at the base; coefficients that sum to 1 give a top deflection of 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TowerPolynomial {
    /// The coefficients of x², x³, x⁴, x⁵, x⁶.
    pub coefficients: [f64; 5],
}

impl TowerPolynomial {
    /// φ(x).
    pub fn value(&self, x: f64) -> f64 {
        x * x * self.horner(x, |_| 1.0)
    }

    /// dφ/dx.
    pub fn slope(&self, x: f64) -> f64 {
        x * self.horner(x, |k| k)
    }

    /// d²φ/dx².
    pub fn curvature(&self, x: f64) -> f64 {
        self.horner(x, |k| k * (k - 1.0))
    }

    /// Σ cₖ = φ(1).
    pub fn sum(&self) -> f64 {
        self.coefficients.iter().sum()
    }

    /// Σ cₖ factor(k) xᵏ⁻².
    fn horner(&self, x: f64, factor: impl Fn(f64) -> f64) -> f64 {
        let powers = [6.0, 5.0, 4.0, 3.0, 2.0];
        let terms = self.coefficients.iter().rev().zip(powers);
        terms.fold(0.0, |sum, (c, k)| sum * x + c * factor(k))
    }
}

#[cfg(test)]
mod tests {
    use super::TowerPolynomial;

    #[test]
    fn values_slopes_and_curvatures_are_those_by_hand() {
        let shape = TowerPolynomial {
            coefficients: [2.0, -3.0, 5.0, -7.0, 4.0],
        };
        // 2/4 − 3/8 + 5/16 − 7/32 + 4/64; 2 − 9/4 + 20/8 − 35/16 + 24/32; 4 − 9 + 60/4 − 140/8 +
        // 120/16.
        assert_eq!(shape.value(0.5), 0.28125);
        assert_eq!(shape.slope(0.5), 0.8125);
        assert_eq!(shape.curvature(0.5), 0.0);
        assert_eq!(shape.curvature(0.0), 4.0);
        assert_eq!((shape.sum(), shape.value(1.0)), (1.0, 1.0));
    }
}
