//! Polynomials fitted to mode shapes.
//!
//! ElastoDyn's shapes have no deflection and no slope at the base and are 1 at the top. Therefore
//! the base motion is subtracted, and the result is divided by its value at the top. The fitted
//! function is
//!
//! φ(x) = x² + Σ cₖ (xᵏ − x²), k = 3 to 6,
//!
//! which is 1 at the top for any cₖ.

use thiserror::Error;

use super::least_squares::least_squares;
use super::polynomial::TowerPolynomial;
use super::shape_samples::ShapeSamples;
use towermodes::Plain;

/// The smallest deflection of the top as a fraction of the largest deflection. A shape with a
/// smaller one is refused, because scaled to 1 at the top it would have very large values
/// elsewhere.
pub const SMALLEST_TIP_SHARE: f64 = 1e-3;

/// A polynomial fitted to a mode shape, with its residuals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolynomialFit {
    /// The polynomial; its coefficients sum to 1.
    pub polynomial: TowerPolynomial,
    /// Root mean square of the residual over the height, for a top deflection of 1.
    pub rms_residual: f64,
    /// Largest residual at any sample, for a top deflection of 1.
    pub largest_residual: f64,
    /// Largest deflection of any sample, for a top deflection of 1: the scale of the residuals.
    pub largest_deflection: f64,
    /// The divisor of the samples: the deflection of the top without the contribution of the base
    /// motion.
    pub tip_deflection: f64,
    /// The condition number of the fit: the ratio of the largest to the smallest singular value of
    /// the columns xᵏ − x² at the samples, weighted as in the fit and scaled to length 1, from R of
    /// their QR decomposition.
    pub condition: f64,
}

impl PolynomialFit {
    /// Root mean square of the residual as a fraction of the largest deflection.
    pub fn relative_rms_residual(&self) -> f64 {
        self.rms_residual / self.largest_deflection
    }

    /// Largest residual as a fraction of the largest deflection.
    pub fn relative_largest_residual(&self) -> f64 {
        self.largest_residual / self.largest_deflection
    }
}

/// Why a polynomial cannot be fitted.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum FitError {
    /// Too few samples for the number of coefficients.
    #[error(
        "{found} samples are too few to fit five coefficients; at least 6 are needed, base and top among them"
    )]
    TooFew {
        /// The number of samples.
        found: usize,
    },
    /// A sample is not finite.
    #[error("sample {index} of the shape is not finite: {} at {}", Plain(*.value), Plain(*.x))]
    NotFinite {
        /// The index of the sample, from 0.
        index: usize,
        /// Its height.
        x: f64,
        /// Its value without the base motion.
        value: f64,
    },
    /// The samples do not begin at the base or end at the top.
    #[error("the samples go from {} to {} of the height; they must go from 0 to 1", Plain(*.first), Plain(*.last))]
    Ends {
        /// The first height.
        first: f64,
        /// The last height.
        last: f64,
    },
    /// The heights do not increase.
    #[error("sample {index} of the shape, at {}, is not above the one before, at {}", Plain(*.x), Plain(*.below))]
    NotRising {
        /// The index of the sample, from 0.
        index: usize,
        /// Its height.
        x: f64,
        /// The height of the previous sample.
        below: f64,
    },
    /// The deflection of the top is too small to divide by.
    #[error(
        "relative to the base, the displacement at the top of the shape is {}, but the largest displacement is {}; shapes of ElastoDyn must be 1 at the top",
        Plain(*.tip), Plain(*.largest)
    )]
    TipStill {
        /// The deflection of the top.
        tip: f64,
        /// The largest deflection.
        largest: f64,
    },
    /// The samples are so close together that the powers of x are linearly dependent.
    #[error("the samples are too close together to determine the coefficients of x² to x⁶")]
    Indistinct,
}

/// Fits a polynomial to a mode shape by least squares over the height.
///
/// Each sample is weighted by the part of the height closest to it (the trapezoidal rule), so that
/// the result does not depend on the spacing of the samples.
///
/// # Errors
/// [`FitError`]: too few samples, samples that are not finite or do not increase from 0 to 1, or a
/// top with too small a deflection.
pub fn fit(samples: &ShapeSamples) -> Result<PolynomialFit, FitError> {
    let (points, tip_deflection) = normalized(samples)?;
    let weights = trapezoidal(&points);
    let column = |power: i32| -> Vec<f64> {
        let rows = points.iter().zip(&weights);
        rows.map(|((x, _), weight)| weight.sqrt() * (x.powi(power) - x * x))
            .collect()
    };
    let rows = points.iter().zip(&weights);
    let b = rows.map(|((x, value), weight)| weight.sqrt() * (value - x * x));
    let columns = [column(3), column(4), column(5), column(6)];
    let found = least_squares(columns, b.collect()).ok_or(FitError::Indistinct)?;
    let [c3, c4, c5, c6] = found.solution;
    let polynomial = TowerPolynomial {
        coefficients: [1.0 - (c3 + c4 + c5 + c6), c3, c4, c5, c6],
    };
    let off = |(x, value): &(f64, f64)| polynomial.value(*x) - value;
    let squares = points.iter().zip(&weights);
    let mean_square: f64 = squares.map(|(point, w)| w * off(point).powi(2)).sum();
    Ok(PolynomialFit {
        polynomial,
        rms_residual: mean_square.sqrt(),
        largest_residual: largest(points.iter().map(off)),
        largest_deflection: largest(points.iter().map(|point| point.1)),
        tip_deflection,
        condition: found.condition,
    })
}

/// The samples without the motion of the base, scaled to a top deflection of 1, and the divisor.
fn normalized(samples: &ShapeSamples) -> Result<(Vec<(f64, f64)>, f64), FitError> {
    let mut points: Vec<_> = samples.bent().collect();
    check_heights(&points)?;
    let largest = largest(points.iter().map(|point| point.1));
    let tip = points.last().map_or(0.0, |(_, value)| *value);
    // A largest of zero, or one too small to divide by, must be refused too.
    if !(tip.abs() >= SMALLEST_TIP_SHARE * largest && tip.is_normal()) {
        return Err(FitError::TipStill { tip, largest });
    }
    points.iter_mut().for_each(|(_, value)| *value /= tip);
    Ok((points, tip))
}

fn check_heights(points: &[(f64, f64)]) -> Result<(), FitError> {
    let found = points.len();
    if found < 6 {
        return Err(FitError::TooFew { found });
    }
    let is_finite = |(x, value): &(f64, f64)| x.is_finite() && value.is_finite();
    if let Some(index) = points.iter().position(|point| !is_finite(point)) {
        let (x, value) = points[index];
        return Err(FitError::NotFinite { index, x, value });
    }
    let (first, last) = (points[0].0, points[found - 1].0);
    if first != 0.0 || last != 1.0 {
        return Err(FitError::Ends { first, last });
    }
    match points.windows(2).position(|pair| pair[1].0 <= pair[0].0) {
        Some(below) => Err(FitError::NotRising {
            index: below + 1,
            x: points[below + 1].0,
            below: points[below].0,
        }),
        None => Ok(()),
    }
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |largest, value| value.abs().max(largest))
}

/// The weights of the samples: the part of the height that belongs to each (trapezoidal rule).
pub(super) fn trapezoidal(points: &[(f64, f64)]) -> Vec<f64> {
    let last = points.len() - 1;
    let weight = |i: usize| 0.5 * (points[(i + 1).min(last)].0 - points[i.saturating_sub(1)].0);
    (0..points.len()).map(weight).collect()
}

#[cfg(test)]
mod tests {
    use super::{FitError, PolynomialFit, ShapeSamples, TowerPolynomial, fit};

    fn sampled(heights: &[f64], shape: impl Fn(f64) -> f64) -> ShapeSamples {
        ShapeSamples {
            points: heights.iter().map(|&x| (x, shape(x))).collect(),
            ..ShapeSamples::default()
        }
    }

    fn equal(n: usize) -> Vec<f64> {
        (0..n).map(|i| i as f64 / (n - 1) as f64).collect()
    }

    fn assert_coefficients(fit: &PolynomialFit, expected: [f64; 5], tolerance: f64) {
        for (c, exact) in fit.polynomial.coefficients.iter().zip(expected) {
            assert!((c - exact).abs() < tolerance, "{c} {exact}");
        }
    }

    /// A cantilever's exact shape for a root β of cosh β cos β = −1, not normalized.
    fn cantilever(beta: f64) -> impl Fn(f64) -> f64 {
        let ratio = (beta.cosh() + beta.cos()) / (beta.sinh() + beta.sin());
        move |x| {
            let b = beta * x;
            b.cosh() - b.cos() - ratio * (b.sinh() - b.sin())
        }
    }

    #[test]
    fn polynomials_come_back() {
        let shapes = [
            [1.0, 0.0, 0.0, 0.0, 0.0],
            [0.7, 2.2, -5.6, 6.2, -2.5],
            [-70.5, -63.75, 290.0, -176.5, 21.75],
        ];
        for coefficients in shapes {
            let shape = TowerPolynomial { coefficients };
            let uneven: Vec<f64> = equal(40).iter().map(|x| x * x).collect();
            for heights in [equal(6), equal(101), uneven] {
                // Whatever it is multiplied by.
                let samples = sampled(&heights, |x| -0.02 * shape.value(x));
                let fit = fit(&samples).expect("a fit");
                let size = coefficients.iter().fold(1.0_f64, |a, c| a.max(c.abs()));
                // The condition number, some thousands, times rounding.
                assert_coefficients(&fit, coefficients, 3e-12 * size);
                assert!(fit.largest_residual < 1e-13 * size && fit.rms_residual < 1e-13 * size);
                assert!((fit.polynomial.sum() - 1.0).abs() < 1e-13 * size);
                assert!((fit.tip_deflection + 0.02).abs() < 1e-14);
            }
        }
    }

    /// Expected values: the same least-squares problem by the normal equations with 60 digits.
    #[test]
    fn a_cantilever_is_fitted_as_well_as_it_can_be() {
        let first = fit(&sampled(&equal(101), cantilever(1.875_104_068_711_961))).expect("a fit");
        let expected = [
            1.757279052818381,
            -0.799414402817984,
            -0.026332349927123,
            0.045143372091041,
            0.023324327835685,
        ];
        assert_coefficients(&first, expected, 1e-11);
        assert!((first.rms_residual - 1.486_729_951e-6).abs() < 1e-12);
        assert!((first.largest_residual - 2.737_832_74e-6).abs() < 1e-12);
        assert!((first.condition / 2_260.311_246_6 - 1.0).abs() < 1e-9);
        assert_eq!(first.largest_deflection, 1.0);

        let second = fit(&sampled(&equal(101), cantilever(4.694_091_132_974_175))).expect("a fit");
        let expected = [
            -10.787910495031087,
            14.999066522456157,
            10.783138147922632,
            -22.181_957_402_200_61,
            8.187663226852909,
        ];
        assert_coefficients(&second, expected, 1e-10);
        assert!((second.rms_residual - 2.970_795_085e-4).abs() < 1e-11);
        assert!((second.largest_residual - 6.315_266_22e-4).abs() < 1e-11);
    }

    #[test]
    fn the_base_s_motion_is_taken_off_exactly() {
        let shape = TowerPolynomial {
            coefficients: [2.0, -3.0, 5.0, -7.0, 4.0],
        };
        let (base_translation, base_slope) = (0.75, -0.3);
        let moved = |x: f64| 0.1 * shape.value(x) + base_translation + base_slope * x;
        let samples = ShapeSamples {
            base_translation,
            base_slope,
            ..sampled(&equal(31), moved)
        };
        let fit = fit(&samples).expect("a fit");
        assert_coefficients(&fit, shape.coefficients, 1e-10);
        assert!((fit.tip_deflection - 0.1).abs() < 1e-15);
    }

    #[test]
    fn samples_that_crowd_do_not_count_more() {
        let even = fit(&sampled(&equal(2001), cantilever(4.694_091_132_974_175))).expect("a fit");
        // Five times as many in the upper half.
        let lower = (0..1000).map(|i| i as f64 / 2000.0);
        let upper = (0..=5000).map(|i| 0.5 + i as f64 / 10000.0);
        let heights: Vec<f64> = lower.chain(upper).collect();
        let uneven = fit(&sampled(&heights, cantilever(4.694_091_132_974_175))).expect("a fit");
        // The trapezoidal rule is off by the square of the spacing, 2.5e-7, of a residual of 3e-4,
        // times the condition.
        assert_coefficients(&uneven, even.polynomial.coefficients, 1e-5);
    }

    #[test]
    fn what_cannot_be_fitted_is_refused_with_its_numbers() {
        let square = |x: f64| x * x;
        let refused = |samples: ShapeSamples| fit(&samples).expect_err("no fit");
        assert_eq!(
            refused(sampled(&equal(5), square)),
            FitError::TooFew { found: 5 }
        );
        assert_eq!(refused(sampled(&[], square)), FitError::TooFew { found: 0 });
        let (first, last) = (0.0, 0.5);
        let half: Vec<f64> = equal(11).iter().map(|x| 0.5 * x).collect();
        assert_eq!(
            refused(sampled(&half, square)),
            FitError::Ends { first, last }
        );
        let falling = [0.0, 0.2, 0.4, 0.3, 0.6, 0.8, 1.0];
        let (index, x, below) = (3, 0.3, 0.4);
        assert_eq!(
            refused(sampled(&falling, square)),
            FitError::NotRising { index, x, below }
        );
        let nan = sampled(&equal(11), |x| if x == 0.5 { f64::NAN } else { x });
        assert!(matches!(refused(nan), FitError::NotFinite { index: 5, .. }));
        let crowded = [0.0, 1e-9, 2e-9, 3e-9, 4e-9, 1.0];
        assert_eq!(refused(sampled(&crowded, square)), FitError::Indistinct);
    }

    #[test]
    fn a_top_that_stands_still_is_refused() {
        // x²(1 − x) + t x²: the top at t, the largest about 4/27.
        let shape = |t: f64| move |x: f64| x * x * (1.0 - x) + t * x * x;
        assert!(fit(&sampled(&equal(100), shape(2e-4))).is_ok());
        let still = fit(&sampled(&equal(100), shape(1e-4))).expect_err("still");
        assert!(matches!(still, FitError::TipStill { tip, .. } if (tip - 1e-4).abs() < 1e-15));
        assert!(fit(&sampled(&equal(100), |_| 0.0)).is_err());
        let huge = fit(&sampled(&equal(100), |x| 1e308 * x * x)).expect("a fit");
        assert_coefficients(&huge, [1.0, 0.0, 0.0, 0.0, 0.0], 1e-11);
    }
}
