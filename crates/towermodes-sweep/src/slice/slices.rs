//! The slices of one sweep, read together.

use std::ops::Range;
use std::path::PathBuf;

use super::SliceError;
use super::column::{Column, columns};
use super::header::Identity;
use super::read::open;
use crate::rows::results::Results;
use crate::sweep::Sweep;
use crate::sweep_source::SweepSource;

/// The slices of one sweep, in the order of their rows.
#[derive(Debug)]
pub struct Slices<'a> {
    sweep: &'a Sweep,
    source: &'a SweepSource,
    columns: Vec<(String, Column)>,
    files: Vec<(PathBuf, Range<u64>)>,
}

impl<'a> Slices<'a> {
    /// Opens the files and reads which rows they contain.
    ///
    /// # Errors
    /// [`SliceError`]: a file cannot be read, is not a slice of this sweep, or contains rows that
    /// another one contains too.
    pub fn open(
        sweep: &'a Sweep,
        source: &'a SweepSource,
        paths: &[PathBuf],
    ) -> Result<Self, SliceError> {
        let identity = Identity::of(sweep, source);
        let mut files = Vec::new();
        for path in paths {
            let (header, _) = open(path)?;
            let (path, differences) = (path.clone(), identity.differences(&header));
            if !differences.is_empty() {
                return Err(SliceError::OtherSweep { path, differences });
            }
            files.push((path, header.rows));
        }
        files.sort_by_key(|(_, rows)| rows.start);
        for pair in files.windows(2) {
            let [(first, rows), (second, others)] = pair else {
                continue;
            };
            if others.start < rows.end {
                return Err(SliceError::Overlap {
                    paths: [first.clone(), second.clone()],
                    rows: others.start..rows.end.min(others.end),
                });
            }
        }
        Ok(Self {
            sweep,
            source,
            columns: columns(sweep),
            files,
        })
    }

    /// The sweep of these results.
    pub fn sweep(&self) -> &Sweep {
        self.sweep
    }

    /// The source of the input values of the rows.
    pub fn source(&self) -> &SweepSource {
        self.source
    }

    /// Number of rows of all slices.
    pub fn rows(&self) -> u64 {
        let rows = self.files.iter().map(|(_, rows)| rows.end - rows.start);
        rows.sum()
    }

    /// The rows of a range that no slice contains, in increasing order.
    pub fn missing(&self, wanted: Range<u64>) -> Vec<Range<u64>> {
        let mut missing = Vec::new();
        let mut next = wanted.start;
        for (_, rows) in &self.files {
            let end = rows.start.min(wanted.end);
            if next < end {
                missing.push(next..end);
            }
            next = next.max(rows.end);
        }
        if next < wanted.end {
            missing.push(next..wanted.end);
        }
        missing
    }

    /// Visits the results of all slices in their order, in blocks of rows; values of a missing mode
    /// or a failed row are NaN.
    ///
    /// # Errors
    /// [`SliceError`] for a slice that cannot be read or is incomplete.
    pub fn each(&self, visit: &mut dyn FnMut(Results)) -> Result<(), SliceError> {
        for (path, rows) in &self.files {
            let (_, file) = open(path)?;
            let read = file.each(self.sweep, &self.columns, rows.clone(), visit);
            read.map_err(|detail| SliceError::Damaged {
                path: path.clone(),
                rows: rows.clone(),
                detail,
            })?;
        }
        Ok(())
    }
}
