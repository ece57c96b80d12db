//! From a number in (0, 1) to a value of a distribution.

use towermodes_files::{Distribution, SamplingError};

use super::normal;

/// A distribution with precomputed constants.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Values {
    Uniform { low: f64, high: f64 },
    Gaussian(Gaussian),
    List(Vec<f64>),
}

/// A normal distribution of a value or of its logarithm, between limits.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Gaussian {
    mean: f64,
    deviation: f64,
    is_logarithm: bool,
    /// The limits of the value.
    limits: [f64; 2],
    /// The probabilities of values below the limits, accurate in all digits below the mean.
    below: [f64; 2],
    /// The probabilities of values above the limits, accurate in all digits above the mean.
    above: [f64; 2],
}

impl Values {
    /// The values of a distribution.
    ///
    /// # Errors
    /// [`SamplingError`] for impossible parameters of a distribution, or limits that exclude all
    /// values.
    pub(super) fn new(distribution: &Distribution) -> Result<Self, SamplingError> {
        distribution.check()?;
        Ok(match *distribution {
            Distribution::Uniform { low, high } => Self::Uniform { low, high },
            Distribution::Normal {
                mean,
                deviation,
                truncated,
            } => Self::Gaussian(Gaussian::new(mean, deviation, false, truncated)?),
            Distribution::LogNormal {
                mean,
                deviation,
                truncated,
            } => {
                let [mean, deviation] = of_logarithm(mean, deviation);
                Self::Gaussian(Gaussian::new(mean, deviation, true, truncated)?)
            }
            Distribution::Values(ref values) => Self::List(values.clone()),
        })
    }

    /// The quantile at the probability u, 0 < u < 1.
    pub(super) fn at(&self, u: f64) -> f64 {
        match self {
            Self::Uniform { low, high } => (low + u * (high - low)).min(*high),
            Self::Gaussian(gaussian) => gaussian.at(u),
            Self::List(values) => {
                let index = (u * values.len() as f64) as usize;
                values[index.min(values.len() - 1)]
            }
        }
    }

    /// The quantile at the probability of a standard normal score.
    pub(super) fn of_score(&self, score: f64) -> f64 {
        match self {
            // A score has more digits than its probability.
            Self::Gaussian(gaussian) if gaussian.has_no_limits() => gaussian.of_score(score),
            _ => self
                .at(normal::probability(score).clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON / 2.0)),
        }
    }

    /// Whether the value is a linear function of the standard normal score.
    pub(super) fn is_normal(&self) -> bool {
        matches!(self, Self::Gaussian(of) if of.has_no_limits() && !of.is_logarithm)
    }

    /// A value of a grid: one of the list, or one of equally spaced values from the lowest to the
    /// highest.
    pub(super) fn level(&self, level: u64, levels: u64) -> f64 {
        match self {
            Self::Uniform { high, .. } if level + 1 == levels => *high,
            Self::Uniform { low, high } => {
                low + (high - low) * (level as f64 / (levels - 1) as f64)
            }
            Self::List(values) => values[level as usize],
            // `Sampling::check` refuses a grid of other distributions.
            other => other.at((level as f64 + 0.5) / levels as f64),
        }
    }
}

/// Mean and standard deviation of the logarithm of a lognormal value with this mean and standard
/// deviation.
fn of_logarithm(mean: f64, deviation: f64) -> [f64; 2] {
    let variation = deviation / mean;
    let variance = libm::log1p(variation * variation);
    [libm::log(mean) - 0.5 * variance, libm::sqrt(variance)]
}

impl Gaussian {
    fn new(
        mean: f64,
        deviation: f64,
        is_logarithm: bool,
        truncated: Option<[f64; 2]>,
    ) -> Result<Self, SamplingError> {
        let limits = truncated.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        let standard = limits.map(|limit| {
            let limit = match is_logarithm {
                true => libm::log(limit.max(0.0)),
                false => limit,
            };
            (limit - mean) / deviation
        });
        let below = standard.map(normal::probability);
        let above = standard.map(|limit| normal::probability(-limit));
        if below[0] < below[1] || above[1] < above[0] {
            Ok(Self {
                mean,
                deviation,
                is_logarithm,
                limits,
                below,
                above,
            })
        } else {
            let [low, high] = limits;
            Err(SamplingError::Excluded { low, high })
        }
    }

    fn at(&self, u: f64) -> f64 {
        // By the nearer tail: a probability near 1 has few digits, and rounds to 1 in the end.
        let [low, high] = self.below;
        let below = low + u * (high - low);
        let standard = match below <= 0.5 {
            true => normal::quantile(below.max(f64::MIN_POSITIVE)),
            false => {
                let [low, high] = self.above;
                let above = high + (1.0 - u) * (low - high);
                -normal::quantile(above.max(f64::MIN_POSITIVE))
            }
        };
        self.of_score(standard)
            .clamp(self.limits[0], self.limits[1])
    }

    fn has_no_limits(&self) -> bool {
        self.limits == [f64::NEG_INFINITY, f64::INFINITY]
    }

    fn of_score(&self, score: f64) -> f64 {
        let value = self.mean + self.deviation * score;
        match self.is_logarithm {
            true => libm::exp(value),
            false => value,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Values;
    use towermodes_files::{Distribution, SamplingError};

    const AT: [f64; 5] = [1e-6, 0.02, 0.5, 0.9, 0.999_999];

    fn values(distribution: &Distribution) -> Values {
        Values::new(distribution).expect("a distribution")
    }

    /// `scipy.stats` 1.17, each with the command beside it, at u = 1e-6, 0.02, 0.5, 0.9, 0.999999.
    #[test]
    fn values_are_those_of_scipy() {
        for (distribution, expected) in scipy() {
            for (u, expected) in AT.into_iter().zip(expected) {
                let value = values(&distribution).at(u);
                let error = (value / expected - 1.0).abs();
                assert!(error < 1e-12, "{distribution:?} {u}: {value} {expected}");
            }
        }
    }

    #[rustfmt::skip]
    fn scipy() -> Vec<(Distribution, [f64; 5])> {
        let normal = |mean, deviation, truncated| Distribution::Normal { mean, deviation, truncated };
        let lognormal = |mean, deviation, truncated| Distribution::LogNormal { mean, deviation, truncated };
        vec![
            // uniform(2, 3)
            (Distribution::Uniform { low: 2.0, high: 5.0 }, [2.000003, 2.06, 3.5, 4.7, 4.9999970000000005]),
            // norm(2.1e11, 3e9)
            (normal(2.1e11, 3e9, None), [195739727073.5313, 203838753268.10452, 210000000000.0, 213844654696.6338, 224260272926.45126]),
            // truncnorm((0.9 - 1)/0.1, (1.3 - 1)/0.1, 1, 0.1)
            (normal(1.0, 0.1, Some([0.9, 1.3])), [0.900000347146702, 0.9067174943292525, 1.0198447899603447, 1.1369961994679039, 1.2999810517858101]),
            // truncnorm(8, 9)
            (normal(0.0, 1.0, Some([8.0, 9.0])), [8.000000123109688, 8.002486767861425, 8.08488889901817, 8.278609037011552, 8.999396586071983]),
            // truncnorm(-9, -8)
            (normal(0.0, 1.0, Some([-9.0, -8.0])), [-8.999396586071999, -8.467344634140217, -8.08488889901817, -8.012960571504212, -8.000000123109688]),
            // lognorm(sqrt(log1p(0.4**2)), scale=5e7/sqrt(1 + 0.4**2))
            (lognormal(5e7, 2e7, None), [7437547.956470215, 21043668.35900169, 46423834.54426291, 76060935.82657619, 289769212.434241]),
            // exp(truncnorm((log(3e7) - mu)/s, (log(9e7) - mu)/s, mu, s)), mu and s of the
            // lognormal above
            (lognormal(5e7, 2e7, Some([3e7, 9e7])), [30000045.625303753, 30887660.903499838, 48388356.705669224, 72213856.50114259, 89999684.79993846]),
        ]
    }

    /// The largest u below 1, 1 − 2⁻⁵³, between 0 and a far limit h: mpmath 1.3 at 50 digits, the
    /// root x of Q(x) = Q(h) + 2⁻⁵³ (1/2 − Q(h)) with Q(x) = `erfc(x/sqrt(2))/2`.
    #[test]
    fn the_far_tails_have_all_digits() {
        let last = 1.0 - f64::EPSILON / 2.0;
        for (limit, expected) in [(9.0, 8.292_119_562_507_686), (40.0, 8.292_361_075_813_595)] {
            let half = values(&Distribution::Normal {
                mean: 0.0,
                deviation: 1.0,
                truncated: Some([0.0, limit]),
            });
            let value = half.at(last);
            assert!((value / expected - 1.0).abs() < 1e-14, "{value} {expected}");
        }
        for truncated in [None, Some([-1.0, 1e300]), Some([-1e300, 1.0])] {
            let normal = values(&Distribution::Normal {
                mean: 0.0,
                deviation: 1.0,
                truncated,
            });
            let drawn = [0.0, 1e-300, 0.3, 0.7, 0.999_999, last].map(|u| normal.at(u));
            assert!(drawn.is_sorted(), "{drawn:?}");
            assert!(drawn.iter().all(|value| value.is_finite()), "{drawn:?}");
        }
    }

    #[test]
    fn limits_that_leave_nothing_are_refused() {
        let far = Distribution::Normal {
            mean: 0.0,
            deviation: 1.0,
            truncated: Some([50.0, 60.0]),
        };
        let expected = SamplingError::Excluded {
            low: 50.0,
            high: 60.0,
        };
        assert_eq!(Values::new(&far), Err(expected));
    }

    #[test]
    fn values_of_a_list_are_equally_probable() {
        let list = values(&Distribution::Values(vec![1.0, 2.0, 4.0]));
        let drawn = [0.0, 0.33, 0.34, 0.66, 0.67, 1.0 - 1e-16].map(|u| list.at(u));
        assert_eq!(drawn, [1.0, 1.0, 2.0, 2.0, 4.0, 4.0]);
    }

    #[test]
    fn levels_include_both_ends() {
        let (low, high) = (0.1, 0.7);
        let uniform = values(&Distribution::Uniform { low, high });
        let levels: Vec<f64> = (0..4).map(|level| uniform.level(level, 4)).collect();
        assert_eq!((levels[0], levels[3]), (0.1, 0.7));
        assert!((levels[1] - 0.3).abs() < 1e-15 && (levels[2] - 0.5).abs() < 1e-15);
    }
}
