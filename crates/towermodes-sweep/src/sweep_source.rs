//! The source of the values of all rows of a sweep: a table in a file, or a sample.

use std::ops::Range;

use towermodes_files::{Sampling, SamplingError, SamplingKind};

use crate::sampling::Draw;
use crate::source::SourceBlock;
use crate::sweep::Sweep;
use crate::table::{Table, TableError};

/// The source of the values of the rows of a sweep.
#[derive(Debug)]
pub enum SweepSource {
    /// A table in a file.
    Table(Box<Table>),
    /// A sample.
    Sampled {
        /// The sampling.
        sampling: Sampling,
        /// The generator of its values.
        draw: Draw,
    },
}

impl SweepSource {
    /// A sample.
    ///
    /// # Errors
    /// [`SamplingError`] for a sampling that cannot be drawn.
    pub fn sampled(sampling: Sampling) -> Result<Self, SamplingError> {
        let draw = Draw::new(&sampling)?;
        Ok(Self::Sampled { sampling, draw })
    }

    /// The names of the changes whose values the source gives.
    pub(crate) fn names(&self) -> Vec<&str> {
        match self {
            Self::Table(table) => table.changes().iter().map(|change| change.name()).collect(),
            Self::Sampled { sampling, .. } => {
                let vary = sampling.vary.iter();
                vary.map(|varied| varied.name.trim()).collect()
            }
        }
    }

    /// Whether it gives values for the changes of this sweep, in the same order.
    pub(crate) fn fits(&self, sweep: &Sweep) -> bool {
        let changes = sweep.changes().iter().map(|change| change.name());
        self.names().into_iter().eq(changes)
    }

    /// Whether the rows are independent, as in random sampling: then a share of the rows has the
    /// standard error of a binomial distribution.
    pub fn is_independent(&self) -> bool {
        match self {
            Self::Table(_) => false,
            Self::Sampled { sampling, .. } => sampling.kind == SamplingKind::Random,
        }
    }

    /// Number of rows.
    pub fn rows(&self) -> u64 {
        match self {
            Self::Table(table) => table.rows(),
            Self::Sampled { draw, .. } => draw.rows(),
        }
    }

    /// The values of rows, numbered from 0. For a table they are read by this call, so only these
    /// rows need memory; for a sample they are computed later and need none.
    ///
    /// # Errors
    /// [`TableError`] if the table has changed, or can no longer be read.
    ///
    /// # Panics
    /// If there are no such rows.
    pub fn block(&self, rows: Range<u64>) -> Result<SourceBlock<'_>, TableError> {
        assert!(rows.start <= rows.end && rows.end <= self.rows());
        Ok(match self {
            Self::Sampled { draw, .. } => SourceBlock::of(draw, rows),
            Self::Table(table) => {
                SourceBlock::read(table.read(rows.clone())?, rows, table.changes().len())
            }
        })
    }
}
