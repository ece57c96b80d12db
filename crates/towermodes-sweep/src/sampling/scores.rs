//! Distributions as functions of a standard normal score: moments, expansion in Hermite
//! polynomials.

use towermodes_files::Distribution;

use super::values::Values;

/// The quadrature goes to this score on both sides: the probability beyond is 2⁻⁵².
const FARTHEST: f64 = 8.2;
/// Points for each unit of the score. The trapezoidal rule of an analytic function times the normal
/// density has all digits with fewer.
const POINTS: i32 = 64;
/// Terms of an expansion by quadrature. Their squares decrease as 2⁻ᵏ for uniform values, and as
/// k^(−7/2) for triangular ones.
const TERMS: usize = 80;

/// The expectation of a function of a standard normal score.
fn expectation(mut of: impl FnMut(f64) -> f64) -> f64 {
    let last = (FARTHEST * f64::from(POINTS)) as i32;
    let weight = 1.0 / libm::sqrt(2.0 * std::f64::consts::PI) / f64::from(POINTS);
    (-last..=last)
        .map(|point| {
            let z = f64::from(point) / f64::from(POINTS);
            weight * libm::exp(-0.5 * z * z) * of(z)
        })
        .sum()
}

/// Mean and standard deviation of a distribution.
pub(super) fn moments(distribution: &Distribution, values: &Values) -> [f64; 2] {
    match distribution {
        Distribution::Uniform { low, high } => {
            [low + 0.5 * (high - low), (high - low) / libm::sqrt(12.0)]
        }
        Distribution::Normal {
            mean,
            deviation,
            truncated: None,
        }
        | Distribution::LogNormal {
            mean,
            deviation,
            truncated: None,
        } => [*mean, *deviation],
        Distribution::Triangular { low, mode, high } => {
            let sides = [mode - low, high - mode, high - low];
            let squares: f64 = sides.iter().map(|side| side * side).sum();
            [
                low + ((mode - low) + (high - low)) / 3.0,
                libm::sqrt(squares / 36.0),
            ]
        }
        Distribution::Values(list) => {
            let of = |sum: f64| sum / list.len() as f64;
            let mean = of(list.iter().sum());
            let squares = list.iter().map(|value| (value - mean) * (value - mean));
            [mean, libm::sqrt(of(squares.sum()))]
        }
        // With limits.
        Distribution::Normal { .. } | Distribution::LogNormal { .. } => {
            let middle = values.of_score(0.0);
            let mean = middle + expectation(|z| values.of_score(z) - middle);
            let squares = expectation(|z| (values.of_score(z) - mean).powi(2));
            [mean, libm::sqrt(squares)]
        }
    }
}

/// A distribution as a series of normalized Hermite polynomials hₖ of its score z,
/// x(z) = mean + σ Σ cₖ hₖ(z), with Σ cₖ² = 1.
///
/// Two scores with the correlation r have E[hᵢ(z₁) hⱼ(z₂)] = rⁱ for i = j and 0 otherwise (Mehler
/// 1866), so the correlation of the values is the power series Σ cₖ dₖ rᵏ.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Series {
    /// From k = 1.
    coefficients: Vec<f64>,
}

impl Series {
    pub(super) fn new(distribution: &Distribution, values: &Values) -> Self {
        let mut coefficients = match distribution {
            Distribution::Normal {
                truncated: None, ..
            } => vec![1.0],
            Distribution::LogNormal {
                mean,
                deviation,
                truncated: None,
            } => lognormal(deviation / mean),
            _ => by_quadrature(values),
        };
        let norm = libm::sqrt(coefficients.iter().map(|c| c * c).sum());
        coefficients.iter_mut().for_each(|c| *c /= norm);
        // Limits so close that rounding leaves one value: what it is correlated with is no matter.
        if norm == 0.0 {
            coefficients = vec![1.0];
        }
        Self { coefficients }
    }

    /// The correlation of the values of two numbers whose scores have the correlation r.
    pub(super) fn correlation(&self, other: &Self, r: f64) -> f64 {
        let products = self.coefficients.iter().zip(&other.coefficients).rev();
        products.fold(0.0, |sum, (c, d)| (sum + c * d) * r)
    }

    /// The correlation of the scores with which the values have a given one.
    ///
    /// # Errors
    /// The lowest and the highest correlation that the values can have.
    pub(super) fn score_correlation(&self, other: &Self, of_values: f64) -> Result<f64, [f64; 2]> {
        /// Of the sum of the series at its ends.
        const ROUNDING: f64 = 1e-12;
        let limits = [-1.0, 1.0].map(|r| self.correlation(other, r));
        if of_values < limits[0] - ROUNDING || of_values > limits[1] + ROUNDING {
            return Err(limits);
        }
        if self.coefficients.len() == 1 && other.coefficients.len() == 1 {
            return Ok(of_values);
        }
        // The correlation of the values rises with that of the scores.
        let mut range = [-1.0, 1.0];
        for _ in 0..80 {
            let middle = 0.5 * (range[0] + range[1]);
            let is_below = self.correlation(other, middle) < of_values;
            range[usize::from(!is_below)] = middle;
        }
        Ok(0.5 * (range[0] + range[1]))
    }
}

/// The coefficients of a lognormal distribution, sᵏ/√(k!) with the deviation s of the logarithm, up
/// to a factor. Their squares are the probabilities of a Poisson distribution with the mean s².
fn lognormal(variation: f64) -> Vec<f64> {
    let variance = libm::log1p(variation * variation);
    let deviation = libm::sqrt(variance);
    let terms = (variance + 12.0 * deviation + 60.0) as usize;
    let next = |c: &mut f64, k: usize| {
        *c *= deviation / libm::sqrt(k as f64);
        Some(*c)
    };
    (1..=terms).scan(libm::exp(-0.5 * variance), next).collect()
}

/// The expectations of x(z) hₖ(z), by the recurrence √(k+1) hₖ₊₁ = z hₖ − √k hₖ₋₁.
fn by_quadrature(values: &Values) -> Vec<f64> {
    let middle = values.of_score(0.0);
    let range = values.of_score(FARTHEST) - values.of_score(-FARTHEST);
    let scale = if range > 0.0 { 1.0 / range } else { 0.0 };
    let mut sums = vec![0.0; TERMS];
    expectation(|z| {
        let value = scale * (values.of_score(z) - middle);
        let weight = libm::exp(-0.5 * z * z);
        let (mut before, mut now) = (0.0, 1.0);
        for (k, sum) in sums.iter_mut().enumerate() {
            let next = z * now - libm::sqrt(k as f64) * before;
            (before, now) = (now, next / libm::sqrt((k + 1) as f64));
            *sum += weight * value * now;
        }
        0.0
    });
    sums
}

#[cfg(test)]
mod tests {
    use towermodes_files::Distribution;

    use super::{Series, moments};
    use crate::sampling::values::Values;

    const UNIFORM: Distribution = Distribution::Uniform {
        low: 1.0,
        high: 7.0,
    };

    fn normal(truncated: Option<[f64; 2]>) -> Distribution {
        Distribution::Normal {
            mean: 2.0,
            deviation: 0.5,
            truncated,
        }
    }

    fn lognormal(variation: f64) -> Distribution {
        Distribution::LogNormal {
            mean: 3.0,
            deviation: 3.0 * variation,
            truncated: None,
        }
    }

    fn triangular(mode: f64) -> Distribution {
        Distribution::Triangular {
            low: 0.0,
            mode,
            high: 6.0,
        }
    }

    fn values(distribution: &Distribution) -> Values {
        Values::new(distribution).expect("a distribution")
    }

    fn series(distribution: &Distribution) -> Series {
        Series::new(distribution, &values(distribution))
    }

    #[track_caller]
    fn check(distribution: &Distribution, expected: [f64; 2], tolerance: f64) {
        let found = moments(distribution, &values(distribution));
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() <= tolerance, "{found} {expected}");
        }
    }

    #[test]
    fn moments_are_those_of_textbooks() {
        check(&UNIFORM, [4.0, 3_f64.sqrt()], 1e-15);
        // (0² + 3² + 6² − 0·3 − 0·6 − 3·6)/18 = 27/18.
        check(&triangular(3.0), [3.0, 1.5_f64.sqrt()], 1e-15);
        check(&Distribution::Values(vec![1.0, 3.0]), [2.0, 1.0], 0.0);
        check(&normal(None), [2.0, 0.5], 0.0);
        check(&lognormal(0.4), [3.0, 1.2], 1e-15);
        // scipy 1.17: truncnorm(-1, 1, 2, 0.5), truncnorm(-0.2, 2.2, 2, 0.5).
        check(
            &normal(Some([1.5, 2.5])),
            [2.0, 0.269_780_046_877_448_4],
            1e-9,
        );
        check(
            &normal(Some([1.9, 3.1])),
            [2.314_463_750_625_277_4, 0.286_387_464_386_599],
            1e-9,
        );
    }

    /// Liu and Der Kiureghian 1986: two uniform values have (6/π) asin(r/2), two lognormal ones
    /// (exp(r s₁ s₂) − 1)/√((exp s₁² − 1)(exp s₂² − 1)), a lognormal and a normal one
    /// r s/√(exp s² − 1).
    #[test]
    fn correlations_of_values_are_the_closed_forms() {
        for r in [-1.0, -0.7, 0.0, 0.3, 0.95, 1.0_f64] {
            let uniform = series(&UNIFORM);
            let expected = 6.0 / std::f64::consts::PI * (0.5 * r).asin();
            let found = uniform.correlation(&uniform, r);
            assert!((found - expected).abs() < 1e-12, "{r} {found} {expected}");
            let squares = [0.3_f64, 0.8].map(|variation| (variation * variation).ln_1p());
            let [one, other] = squares.map(f64::sqrt);
            let norm = (squares[0].exp_m1() * squares[1].exp_m1()).sqrt();
            let expected = (r * one * other).exp_m1() / norm;
            let found = series(&lognormal(0.3)).correlation(&series(&lognormal(0.8)), r);
            assert!((found - expected).abs() < 1e-14, "{r} {found} {expected}");
            let expected = r * one / squares[0].exp_m1().sqrt();
            let found = series(&lognormal(0.3)).correlation(&series(&normal(None)), r);
            assert!((found - expected).abs() < 1e-14, "{r} {found} {expected}");
        }
    }

    /// A variation of a million million, and limits between which there is one number.
    #[test]
    fn extreme_distributions_have_correlations() {
        let (wide, other) = (series(&lognormal(1e12)), series(&lognormal(1e11)));
        let squares = [1e12_f64, 1e11].map(|variation| (variation * variation).ln_1p());
        let norm = (squares[0].exp_m1() * squares[1].exp_m1()).sqrt();
        let r = 0.9;
        let expected = (r * (squares[0] * squares[1]).sqrt()).exp_m1() / norm;
        let found = wide.correlation(&other, r);
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
        let low = 3.5e5_f64;
        let one = Distribution::Uniform {
            low,
            high: low.next_up(),
        };
        let of_one = series(&one)
            .score_correlation(&series(&normal(None)), 0.0)
            .expect("none");
        assert!(of_one.abs() < 1e-12, "{of_one}");
    }

    /// With equal scores a value has the correlation 1 with itself, whatever its distribution.
    #[test]
    fn score_correlations_are_the_inverse() {
        let all = [
            UNIFORM,
            normal(None),
            normal(Some([1.9, 3.1])),
            lognormal(0.5),
            triangular(1.0),
            triangular(0.0),
        ];
        for one in &all {
            let one = series(one);
            let itself = one.score_correlation(&one, 1.0).expect("itself");
            assert!((itself - 1.0).abs() < 1e-9, "{itself}");
            for other in all.iter().map(series) {
                let [low, high] = [-1.0, 1.0].map(|r| one.correlation(&other, r));
                for share in [0.01, 0.3, 0.5, 0.99] {
                    let of_values = low + share * (high - low);
                    let r = one.score_correlation(&other, of_values).expect("reached");
                    assert!((one.correlation(&other, r) - of_values).abs() < 1e-14);
                    assert_eq!(one.score_correlation(&other, high + 1e-3), Err([low, high]));
                }
            }
        }
    }
}
