//! The sampling of the rows of a sweep, as plain data with the rules for its values; the crate
//! `towermodes-sweep` draws the values.

mod correlation;

pub use correlation::{Correlation, CorrelationError, MAX_CORRELATED};

use thiserror::Error;
use towermodes::number::Plain;

/// The sampling of the rows of a sweep: each row is a function only of the seed and its number.
#[derive(Debug, Clone, PartialEq)]
pub struct Sampling {
    /// The kind.
    pub kind: SamplingKind,
    /// Number of rows, at most [`MAX_ROWS`]; for a grid the product of the levels.
    pub rows: u64,
    /// The seed of the random numbers; not used for a grid.
    pub seed: u64,
    /// The changes and their distributions.
    pub vary: Vec<Varied>,
    /// The pairs of dependent inputs; empty if all are independent.
    pub correlations: Vec<Correlation>,
}

/// The largest number of rows of a sweep, 2³².
pub const MAX_ROWS: u64 = 1 << 32;

/// The largest number of changes whose values a Sobol sequence can draw.
pub const MAX_SOBOL_DIMENSIONS: usize = 64;

/// A change by its name, `rna.mass` or `scale(stations[*].wall)`, and its values.
#[derive(Debug, Clone, PartialEq)]
pub struct Varied {
    /// The name of the change.
    pub name: String,
    /// The distribution of its values.
    pub distribution: Distribution,
    /// Number of equally spaced values of a grid with [`Distribution::Uniform`], both ends
    /// included;
    /// none for other kinds of sampling and for [`Distribution::Values`].
    pub levels: Option<u64>,
}

/// The kinds of sampling.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SamplingKind {
    /// Every combination of levels; the first change varies slowest.
    Grid,
    /// Latin hypercube: the range of every change has `rows` equally probable intervals, and each
    /// interval has exactly one row.
    LatinHypercube,
    /// Independent values.
    Random,
    /// Scrambled Sobol sequence: evenly distributed in all changes together; best with rows = 2ⁿ.
    Sobol,
}

impl SamplingKind {
    /// All kinds.
    pub const ALL: [Self; 4] = [Self::Grid, Self::LatinHypercube, Self::Random, Self::Sobol];

    /// Its name in a sweep study: `grid`, `latin-hypercube`, `random`, `sobol`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Grid => "grid",
            Self::LatinHypercube => "latin-hypercube",
            Self::Random => "random",
            Self::Sobol => "sobol",
        }
    }
}

/// The distribution of a value.
#[derive(Debug, Clone, PartialEq)]
pub enum Distribution {
    /// Equally probable between two values.
    Uniform {
        /// The lowest value.
        low: f64,
        /// The highest value.
        high: f64,
    },
    /// Normal (Gaussian).
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation before truncation.
        deviation: f64,
        /// The lowest and the highest value; other values are excluded, and the density between
        /// them is increased proportionally.
        truncated: Option<[f64; 2]>,
    },
    /// Lognormal: the logarithm is Gaussian.
    LogNormal {
        /// Mean of the value itself, not of its logarithm.
        mean: f64,
        /// Standard deviation of the value itself, before truncation.
        deviation: f64,
        /// The limits, as for a normal distribution.
        truncated: Option<[f64; 2]>,
    },
    /// One of several values, equally probable.
    Values(Vec<f64>),
}

impl Distribution {
    /// Its name in a sweep study: `uniform`, `normal`, `lognormal`, `values`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Uniform { .. } => "uniform",
            Self::Normal { .. } => "normal",
            Self::LogNormal { .. } => "lognormal",
            Self::Values(_) => "values",
        }
    }

    /// Checks the parameters of the distribution.
    ///
    /// # Errors
    /// [`SamplingError`] with the first parameter that is impossible for the distribution.
    pub fn check(&self) -> Result<(), SamplingError> {
        if let Some(value) = self.numbers().find(|value| !value.is_finite()) {
            return Err(SamplingError::NotFinite { value });
        }
        match *self {
            Self::Uniform { low, high } => rising(low, high),
            Self::Normal {
                deviation,
                truncated,
                ..
            } => positive(deviation).and_then(|()| range(truncated)),
            Self::LogNormal {
                mean,
                deviation,
                truncated,
            } => {
                if mean <= 0.0 {
                    return Err(SamplingError::LogNormalMean { mean });
                }
                positive(deviation)?;
                range(truncated.map(|[low, high]| [low.max(0.0), high]))
            }
            Self::Values(ref values) => match values.is_empty() {
                true => Err(SamplingError::NoValues),
                false => Ok(()),
            },
        }
    }

    /// All parameters of the distribution.
    fn numbers(&self) -> impl Iterator<Item = f64> {
        let (own, truncated, values): ([f64; 2], _, &[f64]) = match self {
            Self::Uniform { low, high } => ([*low, *high], None, &[]),
            Self::Normal {
                mean,
                deviation,
                truncated,
            }
            | Self::LogNormal {
                mean,
                deviation,
                truncated,
            } => ([*mean, *deviation], *truncated, &[]),
            Self::Values(values) => ([0.0; 2], None, values),
        };
        let truncated = truncated.into_iter().flatten();
        own.into_iter()
            .chain(truncated)
            .chain(values.iter().copied())
    }
}

fn rising(low: f64, high: f64) -> Result<(), SamplingError> {
    // The difference of two finite numbers may overflow.
    match low < high && (high - low).is_finite() {
        true => Ok(()),
        false => Err(SamplingError::Range { low, high }),
    }
}

fn range(truncated: Option<[f64; 2]>) -> Result<(), SamplingError> {
    truncated.map_or(Ok(()), |[low, high]| rising(low, high))
}

fn positive(deviation: f64) -> Result<(), SamplingError> {
    match deviation > 0.0 {
        true => Ok(()),
        false => Err(SamplingError::Deviation { deviation }),
    }
}

impl Sampling {
    /// The number of rows of a grid: the product of the levels of its changes; none if it is above
    /// [`MAX_ROWS`] or if a change has no levels.
    pub fn grid_rows(vary: &[Varied]) -> Option<u64> {
        vary.iter().try_fold(1_u64, |rows, varied| {
            rows.checked_mul(varied.level_count()?)
                .filter(|rows| *rows <= MAX_ROWS)
        })
    }

    /// Checks the sampling; the distributions have [their own check](Distribution::check), so that
    /// a reader can report each at its place.
    ///
    /// # Errors
    /// [`SamplingError`] if the sampling is impossible.
    pub fn check(&self) -> Result<(), SamplingError> {
        if self.vary.is_empty() {
            return Err(SamplingError::NothingVaried);
        }
        let dimensions = self.vary.len();
        if self.kind == SamplingKind::Sobol && dimensions > MAX_SOBOL_DIMENSIONS {
            return Err(SamplingError::TooManyForSobol { dimensions });
        }
        if !(1..=MAX_ROWS).contains(&self.rows) {
            return Err(SamplingError::Rows { rows: self.rows });
        }
        if let Err((index, error)) = self.correlated_places() {
            return Err((index, error).into());
        }
        if self.kind != SamplingKind::Grid {
            return Ok(());
        }
        let without = self.vary.iter().find(|v| v.level_count().is_none());
        if let Some(varied) = without {
            return Err(SamplingError::NoLevels {
                name: varied.name.clone(),
                distribution: varied.distribution.name(),
            });
        }
        match Self::grid_rows(&self.vary) {
            None => Err(SamplingError::LargeGrid),
            Some(product) if product != self.rows => Err(SamplingError::GridRows {
                rows: self.rows,
                product,
            }),
            Some(_) => Ok(()),
        }
    }
}

impl Varied {
    /// The number of its values in a grid, if it can be used in a grid.
    pub fn level_count(&self) -> Option<u64> {
        match (&self.distribution, self.levels) {
            (Distribution::Values(values), _) => Some(values.len() as u64),
            (Distribution::Uniform { .. }, Some(levels @ 2..)) => Some(levels),
            _ => None,
        }
    }
}

/// Why values cannot be drawn.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SamplingError {
    /// A number that is infinite or NaN.
    #[error("{value} is not a finite number")]
    NotFinite {
        /// The number.
        value: f64,
    },
    /// A lower limit that is not below the upper limit, or a difference of limits that overflows.
    #[error("the lower limit {} is not below the upper limit {}", Plain(*.low), Plain(*.high))]
    Range {
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
    /// A standard deviation that is 0 or negative.
    #[error("the standard deviation is {}; it must be positive", Plain(*.deviation))]
    Deviation {
        /// The standard deviation.
        deviation: f64,
    },
    /// A lognormal distribution with a mean of 0 or less.
    #[error("the mean of a lognormal distribution is {}; it must be positive", Plain(*.mean))]
    LogNormalMean {
        /// The mean.
        mean: f64,
    },
    /// An empty list of values.
    #[error("the list of values is empty")]
    NoValues,
    /// Limits that exclude every representable value.
    #[error("the limits {} and {} of `truncated` exclude all values of the distribution", Plain(*.low), Plain(*.high))]
    Excluded {
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
    /// There are no changes.
    #[error("nothing is varied; name at least one parameter")]
    NothingVaried,
    /// More changes than the Sobol sequence has dimensions.
    #[error(
        "{dimensions} inputs are varied, but sobol varies {MAX_SOBOL_DIMENSIONS} at most; use latin-hypercube"
    )]
    TooManyForSobol {
        /// The number of changes.
        dimensions: usize,
    },
    /// No rows, or too many.
    #[error("the number of rows is {rows}; it must be from 1 to {MAX_ROWS}")]
    Rows {
        /// The number of rows.
        rows: u64,
    },
    /// A distribution in a grid without a number of levels, or of a kind that has no levels.
    #[error("`{name}` {}", no_levels(distribution))]
    NoLevels {
        /// The change.
        name: String,
        /// The name of its distribution.
        distribution: &'static str,
    },
    /// A grid with more rows than a sweep may have.
    #[error("the grid has more than {MAX_ROWS} rows; reduce the levels")]
    LargeGrid,
    /// A number of rows that differs from that of the grid.
    #[error("the number of rows is {rows}, but the grid has {product}; omit `rows`")]
    GridRows {
        /// The given number.
        rows: u64,
        /// The product of the levels.
        product: u64,
    },
    /// A correlation that is impossible.
    #[error("{error}")]
    Correlation {
        /// Its index in [`Sampling::correlations`].
        index: usize,
        /// The reason.
        error: Box<CorrelationError>,
    },
}

impl From<(usize, CorrelationError)> for SamplingError {
    fn from((index, error): (usize, CorrelationError)) -> Self {
        let error = Box::new(error);
        Self::Correlation { index, error }
    }
}

/// The message for a distribution without levels in a grid.
fn no_levels(distribution: &str) -> String {
    match distribution {
        "uniform" => "is uniform without levels; in a grid add levels = n, n at least 2".to_owned(),
        other => format!(
            "is {other}, which cannot be used in a grid; use values = [...], or uniform = [low, high] with levels = n, n at least 2"
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::{Distribution, Sampling, SamplingKind, Varied};

    #[track_caller]
    fn refused(distribution: &Distribution, expected: &str) {
        let error = distribution.check().expect_err("refused").to_string();
        assert!(error.contains(expected), "{error}");
    }

    #[test]
    fn impossible_distributions_are_refused_with_their_numbers() {
        let uniform = |low, high| Distribution::Uniform { low, high };
        assert_eq!(uniform(1.0, 2.0).check(), Ok(()));
        refused(
            &uniform(2.0, 2.0),
            "lower limit 2 is not below the upper limit 2",
        );
        refused(&uniform(f64::NAN, 2.0), "NaN is not a finite number");
        refused(&uniform(1.0, f64::INFINITY), "inf is not a finite number");
        let normal = |mean, deviation, truncated| Distribution::Normal {
            mean,
            deviation,
            truncated,
        };
        assert_eq!(normal(-1.0, 2.0, Some([-3.0, 0.0])).check(), Ok(()));
        refused(
            &normal(1.0, 0.0, None),
            "standard deviation is 0; it must be positive",
        );
        refused(
            &normal(1.0, 1.0, Some([3.0, 2.0])),
            "lower limit 3 is not below",
        );
        refused(&normal(1.0, 1.0, Some([f64::NEG_INFINITY, 2.0])), "-inf");
        let lognormal = |mean, truncated| Distribution::LogNormal {
            mean,
            deviation: 1.0,
            truncated,
        };
        assert_eq!(lognormal(1.0, Some([-1.0, 2.0])).check(), Ok(()));
        refused(
            &lognormal(0.0, None),
            "mean of a lognormal distribution is 0",
        );
        refused(
            &lognormal(1.0, Some([-2.0, -1.0])),
            "lower limit 0 is not below",
        );
        refused(&Distribution::Values(Vec::new()), "list of values is empty");
        refused(&Distribution::Values(vec![1.0, f64::NAN]), "NaN");
    }

    #[test]
    fn grids_have_the_product_of_their_levels() {
        let vary = |levels| Varied {
            name: "rna.mass".to_owned(),
            distribution: Distribution::Uniform {
                low: 0.0,
                high: 1.0,
            },
            levels: Some(levels),
        };
        assert_eq!(Sampling::grid_rows(&[vary(3), vary(4)]), Some(12));
        assert_eq!(Sampling::grid_rows(&[vary(1)]), None);
        assert_eq!(Sampling::grid_rows(&vec![vary(1 << 20); 4]), None);
        let grid = |rows, vary| Sampling {
            kind: SamplingKind::Grid,
            rows,
            seed: 0,
            correlations: Vec::new(),
            vary,
        };
        assert_eq!(grid(12, vec![vary(3), vary(4)]).check(), Ok(()));
        let error = |sampling: Sampling| sampling.check().expect_err("refused").to_string();
        let large = error(grid(1, vec![vary(1 << 20); 4]));
        assert!(large.contains("more than 4294967296 rows"), "{large}");
        let other = error(grid(11, vec![vary(3), vary(4)]));
        assert!(other.contains("is 11, but the grid has 12"), "{other}");
        assert!(error(grid(1, Vec::new())).contains("nothing is varied"));
        for kind in SamplingKind::ALL {
            let empty = Sampling {
                kind,
                ..grid(0, vec![vary(3)])
            };
            assert!(error(empty).contains("must be from 1 to 4294967296"));
        }
    }
}
