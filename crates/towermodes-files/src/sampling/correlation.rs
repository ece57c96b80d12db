//! The correlations of the varied inputs of a sweep, as plain data with their rules.

use std::collections::HashSet;
use std::fmt;

use thiserror::Error;
use towermodes::number::Plain;

use super::{Distribution, Sampling, SamplingKind};

/// The correlation of two varied input values. Inputs without a correlation are independent.
///
/// The dependence is a Gaussian copula: each value follows from a standard normal score, and the
/// scores have a joint normal distribution with these correlations (Nataf 1962).
#[derive(Debug, Clone, PartialEq)]
pub struct Correlation {
    /// The names of the two inputs, as in [`Varied::name`](crate::Varied::name).
    pub between: [String; 2],
    /// The correlation coefficient of the normal scores, from −1 to 1. For two normal inputs
    /// without limits it is also that of the values.
    pub coefficient: f64,
}

/// The largest number of varied inputs that have correlations.
pub const MAX_CORRELATED: usize = 500;

/// Why inputs cannot be correlated as requested.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum CorrelationError {
    /// A grid: it contains every combination of its values.
    #[error(
        "a grid has every combination of its values, so they cannot be correlated; use sampling = \"random\", \"latin-hypercube\" or \"sobol\""
    )]
    Grid,
    /// A coefficient outside its range.
    #[error("the correlation coefficient is {}; it must be from -1 to 1", given(*.coefficient))]
    Coefficient {
        /// The coefficient.
        coefficient: f64,
    },
    /// An input that does not vary.
    #[error("`{name}` is not among the varied inputs")]
    NotVaried {
        /// The name.
        name: String,
    },
    /// A correlation of an input with itself.
    #[error("`{name}` cannot be correlated with itself; name two different inputs")]
    Itself {
        /// The name.
        name: String,
    },
    /// A pair that is given twice.
    #[error("the correlation of `{}` and `{}` is given twice; remove one", between[0], between[1])]
    Repeated {
        /// The names.
        between: [String; 2],
    },
    /// An input with a list of values, whose distribution function has no inverse.
    #[error("`{name}` has a list of values, which cannot be correlated; give it a distribution")]
    List {
        /// The name.
        name: String,
    },
    /// More inputs than [`MAX_CORRELATED`].
    #[error("{count} inputs have correlations; the limit is {MAX_CORRELATED}")]
    TooMany {
        /// The number of inputs.
        count: usize,
    },
    /// A correlation of the values of two inputs, one of which is not normal.
    #[error(
        "`coefficient` is the correlation of the values, which can be given only for two normal distributions without limits, but `{name}` does not have one; give `score_coefficient`, the correlation of the normal scores, or the rows as a table (`table = \"values.csv\"`)"
    )]
    OfValues {
        /// The name of this input.
        name: String,
    },
    /// A coefficient that contradicts the others: the correlation matrix is not positive definite.
    #[error("the correlations contradict each other: {}", contradiction(between, *coefficient, *limits))]
    Contradiction {
        /// The names.
        between: [String; 2],
        /// The coefficient; none for a pair that is not in the list.
        coefficient: Option<f64>,
        /// The lowest and the highest possible coefficient, given the correlations with the inputs
        /// before the second.
        limits: [f64; 2],
    },
}

/// A coefficient with all its digits: 1.0000001 is not 1.
fn given(coefficient: f64) -> String {
    match coefficient.abs() {
        1e-4..1e6 => format!("{coefficient}"),
        _ => Plain(coefficient).to_string(),
    }
}

fn contradiction([a, b]: &[String; 2], coefficient: Option<f64>, limits: [f64; 2]) -> String {
    let limits = Limits(limits);
    match coefficient {
        Some(coefficient) => format!(
            "`{a}` and `{b}` cannot have {} beside the other coefficients, which allow {limits}; a pair that is not listed has 0",
            given(coefficient)
        ),
        None => format!(
            "`{a}` and `{b}` have no coefficient, which means 0, but the other coefficients allow only values {limits}; add a coefficient of these two inputs, or reduce the others"
        ),
    }
}

/// "from -0.62 to 0.98", rounded inwards; for a narrow range one number.
struct Limits([f64; 2]);

impl fmt::Display for Limits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [low, high] = self.0;
        let inwards = |scale: f64| [(low * scale).ceil() / scale, (high * scale).floor() / scale];
        let rounded = [1e3, 1e6, 1e9].map(inwards);
        match rounded.into_iter().find(|[low, high]| low <= high) {
            Some([low, high]) if low < high => {
                write!(f, "from {} to {}", Plain(low + 0.0), Plain(high + 0.0))
            }
            Some([low, _]) => write!(f, "{}", Plain(low + 0.0)),
            None => write!(f, "{:.6}", 0.5 * (low + high)),
        }
    }
}

impl Sampling {
    /// The indices in [`Sampling::vary`] of the two inputs of each correlation, the smaller first.
    ///
    /// # Errors
    /// The index of a correlation that is impossible by itself or repeated, with the reason.
    pub fn correlated_places(&self) -> Result<Vec<[usize; 2]>, (usize, CorrelationError)> {
        let mut seen = HashSet::new();
        let mut places = Vec::with_capacity(self.correlations.len());
        for (index, correlation) in self.correlations.iter().enumerate() {
            let pair = self.pair(correlation).map_err(|error| (index, error))?;
            if !seen.insert(pair) {
                let between = correlation.between.clone();
                return Err((index, CorrelationError::Repeated { between }));
            }
            places.push(pair);
        }
        let numbers: HashSet<usize> = places.iter().flatten().copied().collect();
        match numbers.len() > MAX_CORRELATED {
            true => {
                let count = numbers.len();
                Err((places.len() - 1, CorrelationError::TooMany { count }))
            }
            false => Ok(places),
        }
    }

    fn pair(&self, correlation: &Correlation) -> Result<[usize; 2], CorrelationError> {
        if self.kind == SamplingKind::Grid {
            return Err(CorrelationError::Grid);
        }
        let place = |name: &String| {
            let place = self.vary.iter().position(|v| v.name.trim() == name.trim());
            let place = place.ok_or_else(|| CorrelationError::NotVaried { name: name.clone() })?;
            match self.vary[place].distribution {
                Distribution::Values(_) => Err(CorrelationError::List { name: name.clone() }),
                _ => Ok(place),
            }
        };
        let [first, second] = &correlation.between;
        let (first, second) = (place(first)?, place(second)?);
        if first == second {
            let name = correlation.between[0].clone();
            return Err(CorrelationError::Itself { name });
        }
        let coefficient = correlation.coefficient;
        match (-1.0..=1.0).contains(&coefficient) {
            true => Ok([first.min(second), first.max(second)]),
            false => Err(CorrelationError::Coefficient { coefficient }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Limits;

    #[test]
    fn a_coefficient_that_is_hardly_wrong_has_all_its_digits() {
        let coefficient = 1.000_000_1;
        let said = super::CorrelationError::Coefficient { coefficient }.to_string();
        assert_eq!(
            said,
            "the correlation coefficient is 1.0000001; it must be from -1 to 1"
        );
    }

    #[test]
    fn limits_are_rounded_inwards() {
        let shown = |low, high| Limits([low, high]).to_string();
        assert_eq!(shown(-0.62049, 0.98051), "from -0.62 to 0.98");
        assert_eq!(shown(0.123_456_1, 0.123_457_2), "0.123457");
        assert_eq!(shown(-1.0, 1.0), "from -1 to 1");
        assert_eq!(shown(-0.0001, 0.5), "from 0 to 0.5");
        assert_eq!(shown(0.25, 0.25), "0.25");
    }
}
