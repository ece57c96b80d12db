//! Solves the rows of a slice and writes them as they are solved.

use std::io::{self, Write};
use std::ops::Range;

use super::SliceError;
use super::column::{Column, columns};
use super::csv;
use super::header::{Header, Identity};
use super::part::Part;
use crate::rows::results::Results;
use crate::rows::stream::stream;
use crate::rows::threads::Watch;
use crate::rows::warned::RowRemarks;
use crate::source::RowSource;
use crate::sweep::Sweep;
use crate::sweep_source::SweepSource;

/// The format of the files of results.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SliceFormat {
    /// Text with a header line; an empty cell is a value that was not computed.
    #[default]
    Csv,
    /// Apache Parquet, with null for a value that was not computed; needs the feature `parquet`.
    Parquet,
}

/// Successive rows of a sweep, to be solved and written.
///
/// # Example
/// Half of 1000 towers, drawn by a Latin hypercube, in memory:
/// ```
/// use std::ops::ControlFlow;
/// use towermodes::{Change, Material, Rna, Station, TowerDescription};
/// use towermodes_files::{Distribution, Sampling, SamplingKind, SweepResults, Varied};
/// use towermodes_sweep::{Base, Slice, Sweep, SweepSource};
///
/// let description = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// };
/// let changes = Change::parse_all(["rna.mass"], &description)?;
/// let sweep = Sweep::new(Base::from(description), changes, &SweepResults::default())?;
/// let mass = Varied {
///     name: "rna.mass".to_owned(),
///     distribution: Distribution::Uniform { low: 3.3e5, high: 3.7e5 },
///     levels: None,
/// };
/// let source = SweepSource::sampled(Sampling {
///     kind: SamplingKind::LatinHypercube,
///     rows: 1000,
///     seed: 1,
///     correlations: Vec::new(),
///     vary: vec![mass],
/// })?;
///
/// let mut text = Vec::new();
/// let slice = Slice { rows: 0..500, ..Slice::all(&sweep, &source) };
/// let solved = slice.write(&mut text, 2, &mut |_| ControlFlow::Continue(()))?;
/// assert_eq!((solved.rows, solved.failed), (500, 0));
/// let text = String::from_utf8(text)?;
/// assert!(text.starts_with("# towermodes ") && text.lines().count() == 502);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Slice<'a> {
    /// The sweep.
    pub sweep: &'a Sweep,
    /// The values of its rows.
    pub source: &'a SweepSource,
    /// The rows of the slice, numbered from 0 in the whole sweep.
    pub rows: Range<u64>,
    /// The format.
    pub format: SliceFormat,
}

/// The rows that a range selects, numbered from 0; the range may end beyond the last row.
///
/// # Errors
/// [`SliceError::NoSuchRows`] for a range without rows of the sweep.
pub fn rows_within(asked: Range<u64>, count: u64) -> Result<Range<u64>, SliceError> {
    let rows = asked.start..asked.end.min(count);
    match rows.is_empty() {
        true => Err(SliceError::NoSuchRows { rows: asked, count }),
        false => Ok(rows),
    }
}

/// The counts and remarks of a run.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Solved {
    /// Number of rows.
    pub rows: u64,
    /// Number of rows that failed or lack a mode.
    pub failed: u64,
    /// The first of these rows, with its message.
    pub first_failure: Option<(u64, String)>,
    /// Rows with input that is probably a mistake.
    pub warnings: RowRemarks,
    /// Rows in which several modes share a motion.
    pub shared: RowRemarks,
}

impl<'a> Slice<'a> {
    /// A slice with all rows, in CSV.
    pub fn all(sweep: &'a Sweep, source: &'a SweepSource) -> Self {
        Self {
            sweep,
            source,
            rows: 0..source.rows(),
            format: SliceFormat::Csv,
        }
    }

    /// Solves the rows and writes them in their order. The bytes do not depend on the number of
    /// threads, and any number of rows needs little memory.
    ///
    /// The watch is called on the calling thread about fifty times a second with the number of
    /// rows that are solved.
    ///
    /// # Errors
    /// [`SliceError`]: the sweep has no such rows, the table has changed, the results cannot be
    /// written, or the watch stopped the run. The output is then incomplete.
    pub fn write(
        &self,
        out: impl Write + Send,
        threads: usize,
        watch: &mut Watch<'_>,
    ) -> Result<Solved, SliceError> {
        self.check()?;
        let columns = columns(self.sweep);
        let header = Identity::of(self.sweep, self.source).header(self.rows.clone());
        let mut writer = Writer::new(self.format, out, &header, &columns)?;
        let mut solved = Solved::default();
        let remarks = stream(
            self.sweep,
            self.rows.clone(),
            (threads, watch),
            |rows| Ok(self.source.block(rows)?),
            |block, results| Ready::new(self, block, results, &columns),
            |ready| {
                solved.add(&ready);
                writer.add(ready)
            },
        )?;
        writer.finish()?;
        Ok(Solved {
            warnings: remarks.warnings,
            shared: remarks.shared,
            ..solved
        })
    }

    /// Refuses rows that the sweep does not have, and values for other changes.
    fn check(&self) -> Result<(), SliceError> {
        let count = self.source.rows();
        if self.rows.start >= self.rows.end || self.rows.end > count {
            let rows = self.rows.clone();
            return Err(SliceError::NoSuchRows { rows, count });
        }
        if self.source.fits(self.sweep) {
            return Ok(());
        }
        let changes = self.sweep.changes().iter();
        Err(SliceError::OtherChanges {
            found: self.source.names().into_iter().map(str::to_owned).collect(),
            expected: changes.map(|change| change.name().to_owned()).collect(),
        })
    }
}

impl Solved {
    fn add(&mut self, ready: &Ready) {
        self.rows += ready.rows;
        self.failed += ready.failed;
        if self.first_failure.is_none() {
            self.first_failure.clone_from(&ready.first_failure);
        }
    }
}

/// Rows that are ready to be written.
struct Ready {
    rows: u64,
    failed: u64,
    first_failure: Option<(u64, String)>,
    content: io::Result<Content>,
}

enum Content {
    Text(Vec<u8>),
    #[cfg(feature = "parquet")]
    Columns(Box<Part>),
}

impl Ready {
    /// Results with the values of their rows, which are in a block.
    fn new(
        slice: &Slice<'_>,
        block: &dyn RowSource,
        results: Results,
        columns: &[(String, Column)],
    ) -> Self {
        let first = results.failures.get(0);
        let first_failure = first.map(|(row, sentence)| (row, sentence.to_owned()));
        let (rows, failed) = (results.rows() as u64, results.failures.len() as u64);
        let part = Part::new(slice.sweep, block, results);
        Self {
            rows,
            failed,
            first_failure,
            content: match slice.format {
                SliceFormat::Csv => csv::rows(&part, columns).map(Content::Text),
                #[cfg(feature = "parquet")]
                SliceFormat::Parquet => Ok(Content::Columns(Box::new(part))),
                // The writer has refused it.
                #[cfg(not(feature = "parquet"))]
                SliceFormat::Parquet => Err(io::ErrorKind::Unsupported.into()),
            },
        }
    }
}

enum Writer<W: Write + Send> {
    Csv(W),
    #[cfg(feature = "parquet")]
    Parquet(Box<super::parquet::Writer<W>>),
}

impl<W: Write + Send> Writer<W> {
    fn new(
        format: SliceFormat,
        mut out: W,
        header: &Header,
        columns: &[(String, Column)],
    ) -> Result<Self, SliceError> {
        match format {
            SliceFormat::Csv => {
                let mut text = format!("# {header}\n").into_bytes();
                text.extend(csv::names(columns).map_err(SliceError::Output)?);
                out.write_all(&text).map_err(SliceError::Output)?;
                Ok(Self::Csv(out))
            }
            #[cfg(feature = "parquet")]
            SliceFormat::Parquet => {
                let writer = super::parquet::Writer::new(out, header, columns.to_vec());
                Ok(Self::Parquet(Box::new(writer.map_err(of_parquet)?)))
            }
            #[cfg(not(feature = "parquet"))]
            SliceFormat::Parquet => Err(SliceError::NoParquet),
        }
    }

    fn add(&mut self, ready: Ready) -> Result<(), SliceError> {
        let content = ready.content.map_err(SliceError::Output)?;
        match (self, content) {
            (Self::Csv(out), Content::Text(text)) => {
                out.write_all(&text).map_err(SliceError::Output)
            }
            #[cfg(feature = "parquet")]
            (Self::Parquet(writer), Content::Columns(part)) => {
                writer.add(*part).map_err(of_parquet)
            }
            #[cfg(feature = "parquet")]
            _ => Err(SliceError::Output(io::ErrorKind::InvalidInput.into())),
        }
    }

    fn finish(self) -> Result<(), SliceError> {
        match self {
            Self::Csv(mut out) => out.flush().map_err(SliceError::Output),
            #[cfg(feature = "parquet")]
            Self::Parquet(writer) => writer.finish().map_err(of_parquet),
        }
    }
}

/// The error of a write; a full disk gets its own message.
#[cfg(feature = "parquet")]
fn of_parquet(error: ::parquet::errors::ParquetError) -> SliceError {
    use ::parquet::errors::ParquetError;
    SliceError::Output(match error {
        ParquetError::External(cause) => match cause.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(cause) => io::Error::other(cause),
        },
        error => io::Error::other(error),
    })
}
