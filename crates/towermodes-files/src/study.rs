//! The study of a sweep: which towers are solved, as the table `[sweep]` of a file describes it.
//!
//! ```toml
//! [sweep]
//! base = "nrel-5mw.toml"
//! sampling = "sobol"
//! rows = 100_000
//! seed = 1
//!
//! [sweep.vary]
//! "rna.mass" = { uniform = [3.3e5, 3.7e5] }
//! "scale(stations[*].wall)" = { normal = [1.0, 0.02], truncated = [0.9, 1.1] }
//!
//! [sweep.results]
//! modes = 4
//! ```
//!
//! The types are plain data; [`Sampling`] has the rules for its numbers.

use std::ops::Range;

use towermodes::{Method, ModeName};

use crate::input::ReadOptions;
use crate::sampling::Sampling;
use crate::source::Source;

/// A sweep as a file describes it.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepStudy {
    /// The file with the tower that is varied, relative to the study.
    pub base: Placed<String>,
    /// How the base is read where its format leaves a choice.
    pub reading: ReadOptions,
    /// The values of each row.
    pub rows: SweepRows,
    /// What is computed and written for each row.
    pub results: SweepResults,
    /// The study's own file, for messages.
    pub source: Source,
}

/// A value and its bytes in the file of the study.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed<T> {
    /// The value.
    pub value: T,
    /// Its bytes.
    pub span: Range<usize>,
}

/// The values of the rows of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub enum SweepRows {
    /// A table with a column for each change, in CSV or Parquet, relative to the study.
    Table(Placed<String>),
    /// Values drawn from distributions.
    Sampled {
        /// The rule.
        sampling: Sampling,
        /// The bytes of each name in [`Sampling::vary`].
        spans: Vec<Range<usize>>,
    },
}

/// What is computed and written for each row.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepResults {
    /// The modes that have columns.
    pub modes: SweepModes,
    /// Number of segments or elements; `None` is the default of a sweep.
    pub segments: Option<usize>,
    /// The method; `None` is that of the base, as `solve` takes it.
    pub method: Option<Method>,
    /// Whether sections have rotary inertia in bending.
    pub rotary_inertia: bool,
    /// Whether the varied values are columns of the results.
    pub inputs: bool,
    /// Number of rows of a part; `None` is the default.
    pub rows_per_part: Option<u64>,
}

impl Default for SweepResults {
    fn default() -> Self {
        Self {
            modes: SweepModes::default(),
            segments: None,
            method: None,
            rotary_inertia: true,
            inputs: true,
            rows_per_part: None,
        }
    }
}

/// The modes that have columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SweepModes {
    /// Those that are the lowest of the base, by name.
    Lowest(usize),
    /// These.
    Named(Vec<ModeName>),
}

/// The number of modes of a sweep if it is not given.
pub const DEFAULT_SWEEP_MODES: usize = 4;

impl Default for SweepModes {
    fn default() -> Self {
        Self::Lowest(DEFAULT_SWEEP_MODES)
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
        refused(&lognormal(0.0, None), "mean of a lognormal value is 0");
        refused(
            &lognormal(1.0, Some([-2.0, -1.0])),
            "lower limit 0 is not below",
        );
        let triangular = |low, mode, high| Distribution::Triangular { low, mode, high };
        assert_eq!(triangular(1.0, 1.0, 2.0).check(), Ok(()));
        refused(&triangular(1.0, 3.0, 2.0), "3 is not between 1 and 2");
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
            vary,
        };
        assert_eq!(grid(12, vec![vary(3), vary(4)]).check(), Ok(()));
        let error = |sampling: Sampling| sampling.check().expect_err("refused").to_string();
        let large = error(grid(1, vec![vary(1 << 20); 4]));
        assert!(large.contains("more than 4294967296 rows"), "{large}");
        let other = error(grid(11, vec![vary(3), vary(4)]));
        assert!(other.contains("is 11, but the grid has 12"), "{other}");
        assert!(error(grid(1, Vec::new())).contains("nothing is varied"));
        let random = Sampling {
            kind: SamplingKind::Random,
            ..grid(0, vec![vary(3)])
        };
        assert!(error(random).contains("must be from 1 to 4294967296"));
    }
}
