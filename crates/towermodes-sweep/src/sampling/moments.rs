//! Means, standard deviations and correlations of values from their normal scores.

use towermodes_files::Distribution;

use super::values::Values;

/// The quadrature extends to this score on both sides; the probability beyond it is 2⁻⁵².
const FARTHEST: f64 = 8.2;
/// Number of points per unit of the score. For an analytic function times the normal density the
/// trapezoidal rule is exact to all digits with fewer points.
const POINTS: i32 = 16;

/// The expectation of a function of a standard normal score.
fn expectation(of: impl Fn(f64) -> f64) -> f64 {
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

/// The correlation of two values, each with its moments, whose scores have the correlation r: the
/// second score is r z + √(1 − r²) w, with the first score z and an independent score w.
pub(super) fn of_values([first, second]: [(&Values, [f64; 2]); 2], r: f64) -> f64 {
    if first.0.is_normal() && second.0.is_normal() {
        return r;
    }
    let rest = libm::sqrt(1.0 - r * r);
    let standard = |(values, [mean, deviation]): (&Values, [f64; 2]), score| {
        (values.of_score(score) - mean) / deviation
    };
    expectation(|z| standard(first, z) * expectation(|w| standard(second, r * z + rest * w)))
}

#[cfg(test)]
mod tests {
    use towermodes_files::Distribution;

    use super::{moments, of_values};
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

    fn values(distribution: &Distribution) -> Values {
        Values::new(distribution).expect("a distribution")
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
        let correlation = |pair: [&Distribution; 2], r| {
            let values = pair.map(values);
            let scaled = [0, 1].map(|i| (&values[i], moments(pair[i], &values[i])));
            of_values(scaled, r)
        };
        let squares = [0.3_f64, 0.8].map(|variation| (variation * variation).ln_1p());
        let [one, other] = squares.map(f64::sqrt);
        let norm = (squares[0].exp_m1() * squares[1].exp_m1()).sqrt();
        for r in [-1.0, -0.7, 0.0, 0.3, 0.95, 1.0_f64] {
            let pairs = [
                (
                    [UNIFORM, UNIFORM],
                    6.0 / std::f64::consts::PI * (0.5 * r).asin(),
                ),
                (
                    [lognormal(0.3), lognormal(0.8)],
                    (r * one * other).exp_m1() / norm,
                ),
                (
                    [lognormal(0.3), normal(None)],
                    r * one / squares[0].exp_m1().sqrt(),
                ),
            ];
            for (pair, expected) in pairs {
                let found = correlation([&pair[0], &pair[1]], r);
                assert!((found - expected).abs() < 1e-9, "{r} {found} {expected}");
            }
        }
        assert_eq!(correlation([&normal(None), &normal(None)], 0.37), 0.37);
    }
}
