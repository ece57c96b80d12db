//! A sweep whose results are a folder of parts, solved part by part by whoever has time.

use std::path::PathBuf;

use pyo3::prelude::*;
use towermodes_files::Source;
use towermodes_sweep::{
    DEFAULT_ROWS_PER_PART, PartFormat, PartOptions, Parts, PartsError, Shard, Sweep, SweepSource,
};

use crate::error::{of_parts, of_read, usage};
use crate::lock::released;
use crate::planned::{Planned, of_study, of_table};
use crate::sweep::{SweepOptions, look, refused};
use crate::tower::Tower;

/// The folder of the results of a sweep.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct SweepFolder {
    sweep: Sweep,
    source: SweepSource,
    folder: PathBuf,
    options: PartOptions,
}

/// How the results are written.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct FolderOptions {
    format: String,
    rows_per_part: Option<u64>,
    force: bool,
    inputs: bool,
    ignore: Vec<String>,
}

#[pymethods]
impl SweepFolder {
    /// Opens the folder, and makes it if it does not exist. The values are a table, or without a
    /// tower a study.
    #[new]
    #[pyo3(signature = (
        tower,
        values: "str",
        folder: "str",
        results: "dict[str, object]",
        options: "dict[str, object]",
    ))]
    fn new(
        py: Python<'_>,
        tower: Option<&Tower>,
        values: PathBuf,
        folder: PathBuf,
        results: SweepOptions,
        options: FolderOptions,
    ) -> PyResult<Self> {
        released(py, || {
            let planned = match tower {
                Some(tower) => of_table(&tower.model.input, &values, &results, &options.ignore),
                None => {
                    let study = Source::from_path(&values);
                    let study = study.map_err(|error| of_read(error.into()))?;
                    of_study(&study, None, &results, &options.ignore)
                }
            };
            let Planned {
                base,
                changes,
                source,
                mut results,
            } = planned?;
            results.inputs &= options.inputs;
            let sweep = Sweep::new(base, changes, &results).map_err(refused)?;
            let mut part_options = options.of_parts(results.rows_per_part)?;
            let parts = Parts::open(&sweep, &source, &folder, part_options);
            drop(parts.map_err(of_parts)?);
            // Removed once, not whenever a worker opens the folder.
            part_options.force = false;
            Ok(Self {
                sweep,
                source,
                folder,
                options: part_options,
            })
        })
    }

    /// The SHA-256 of all that the results depend on.
    #[getter]
    fn key(&self) -> PyResult<String> {
        Ok(self.parts()?.key().to_owned())
    }

    /// Number of rows of the whole sweep.
    #[getter]
    fn rows(&self) -> u64 {
        self.source.rows()
    }

    /// Number of parts of the whole sweep.
    #[getter]
    fn count(&self) -> PyResult<u64> {
        Ok(self.parts()?.count())
    }

    /// The first row of a part and the row behind its last.
    fn rows_of(&self, part: u64) -> PyResult<(u64, u64)> {
        let rows = self.parts()?.rows_of(part);
        Ok((rows.start, rows.end))
    }

    /// The parts that are not there or not whole.
    fn missing(&self, py: Python<'_>) -> PyResult<Vec<u64>> {
        released(py, || self.parts()?.missing().map_err(of_parts))
    }

    /// Solves a part and writes it: its number of rows, and how many of them have failed.
    fn solve(&self, py: Python<'_>, part: u64, threads: usize) -> PyResult<(u64, u64)> {
        let mut interrupted = None;
        let solved = released(py, || {
            let parts = self.parts()?;
            let mut watch = |_| look(&mut interrupted);
            parts.solve(&[part], threads, &mut watch).map_err(of_parts)
        });
        match (solved, interrupted) {
            (_, Some(exception)) => Err(exception),
            (solved, None) => solved.map(|progress| (progress.rows, progress.failures)),
        }
    }

    /// How many rows of a part that is there have failed.
    fn failures_of(&self, py: Python<'_>, part: u64) -> PyResult<u64> {
        released(py, || {
            let results = self.parts()?.read(part).map_err(of_parts)?;
            Ok(results.failures.len() as u64)
        })
    }

    /// Writes `_SUCCESS` if all parts are there; whether they are.
    fn finish(&self, py: Python<'_>) -> PyResult<bool> {
        released(py, || match self.parts()?.finish() {
            // It is computed in the next round.
            Err(PartsError::Lost { .. }) => Ok(false),
            finished => finished.map_err(of_parts),
        })
    }
}

impl SweepFolder {
    fn parts(&self) -> PyResult<Parts<'_>> {
        let parts = Parts::open(&self.sweep, &self.source, &self.folder, self.options);
        parts.map_err(of_parts)
    }
}

impl FolderOptions {
    fn of_parts(&self, of_study: Option<u64>) -> PyResult<PartOptions> {
        let format = match self.format.as_str() {
            "csv" => PartFormat::Csv,
            "parquet" => PartFormat::Parquet,
            format => {
                return Err(usage(format!(
                    "format is '{format}'; it must be 'parquet' or 'csv'"
                )));
            }
        };
        Ok(PartOptions {
            format,
            rows_per_part: (self.rows_per_part.or(of_study)).unwrap_or(DEFAULT_ROWS_PER_PART),
            force: self.force,
            shard: Shard::ALL,
        })
    }
}
