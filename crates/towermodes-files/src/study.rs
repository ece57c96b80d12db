//! The sweep study: the towers to be solved, as the table `[sweep]` of a file describes them.
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
//! The types are plain data; [`Sampling`] has the rules for its values.

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
    /// Options for reading the base, if its format leaves a choice.
    pub reading: ReadOptions,
    /// The values of each row.
    pub rows: SweepRows,
    /// The results that are computed and written for each row.
    pub results: SweepResults,
    /// The sweep study, for messages.
    pub source: Source,
}

/// A value and its byte range in the study.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed<T> {
    /// The value.
    pub value: T,
    /// Its byte range.
    pub span: Range<usize>,
}

/// The values of the rows of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub enum SweepRows {
    /// A table with a column for each change, in CSV or Parquet, relative to the study.
    Table(Placed<String>),
    /// Values drawn from distributions.
    Sampled {
        /// The sampling rule.
        sampling: Sampling,
        /// The byte range of each name in [`Sampling::vary`].
        spans: Vec<Range<usize>>,
        /// The byte range of each entry of [`Sampling::correlations`].
        correlation_spans: Vec<Range<usize>>,
    },
}

/// The results that are computed and written for each row.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepResults {
    /// The modes whose results are columns.
    pub modes: SweepModes,
    /// Number of segments or elements; `None` for the default of a sweep.
    pub segments: Option<usize>,
    /// The method; `None` for the default of `solve` for the base.
    pub method: Option<Method>,
    /// Whether sections have rotary inertia in bending.
    pub rotary_inertia: bool,
    /// Whether the varied values are columns of the results.
    pub inputs: bool,
}

impl Default for SweepResults {
    fn default() -> Self {
        Self {
            modes: SweepModes::default(),
            segments: None,
            method: None,
            rotary_inertia: true,
            inputs: true,
        }
    }
}

/// The modes whose results are columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SweepModes {
    /// This number of modes, the lowest of the base, by name.
    Lowest(usize),
    /// The modes with these names.
    Named(Vec<ModeName>),
}

/// The number of modes of a sweep if it is not given.
pub const DEFAULT_SWEEP_MODES: usize = 4;

impl Default for SweepModes {
    fn default() -> Self {
        Self::Lowest(DEFAULT_SWEEP_MODES)
    }
}
