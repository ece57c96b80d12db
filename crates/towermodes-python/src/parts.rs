//! A sweep whose results are a folder of parts, solved part by part by whoever has time.

use std::path::{Path, PathBuf};

use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use towermodes::Change;
use towermodes_files::{
    SiblingFiles, Source, SweepResults, SweepRows, TowerInput, read, read_sweep_study,
};
use towermodes_sweep::{
    Base, DEFAULT_ROWS_PER_PART, PartFormat, PartOptions, Parts, PartsError, Shard, Sweep,
    SweepSource, Table, TableError, TableProblem,
};

use crate::error::{of_read, usage};
use crate::lock::released;
use crate::reading::tower_input;
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
                None => of_study(&values, &results, &options.ignore),
            };
            let (base, changes, source, mut results) = planned?;
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

/// What is swept: the tower, the changes, their values, and what is computed.
type Planned = (Base, Vec<Change>, SweepSource, SweepResults);

fn of_table(
    input: &TowerInput,
    table: &Path,
    results: &SweepOptions,
    ignore: &[String],
) -> PyResult<Planned> {
    let results = results.over(SweepResults::default())?;
    let table = Table::open(table, &input.description, ignore);
    let table = table.map_err(|error| of_parts(error.into()))?;
    let changes = table.changes().to_vec();
    let source = SweepSource::Table(Box::new(table));
    Ok((Base::from(input), changes, source, results))
}

/// A study, with the files that it names.
fn of_study(study: &Path, results: &SweepOptions, ignore: &[String]) -> PyResult<Planned> {
    let source = Source::from_path(study).map_err(|error| of_read(error.into()))?;
    let beside = SiblingFiles::of(study);
    let study = read_sweep_study(&source).map_err(of_read)?;
    let base = read(&beside.path(&study.base.value), &study.reading);
    let input = tower_input(base.map_err(of_read)?)?;
    let (changes, source) = match &study.rows {
        SweepRows::Table(path) => {
            let table = beside.path(&path.value);
            let mut planned = of_table(&input, &table, results, ignore)?;
            planned.3 = results.over(study.results)?;
            return Ok(planned);
        }
        SweepRows::Sampled { .. } if !ignore.is_empty() => {
            return Err(usage("ignore applies only to a table of values"));
        }
        SweepRows::Sampled { sampling, .. } => {
            let changes = study.changes(&input.description).map_err(of_read)?;
            let source = SweepSource::sampled(sampling.clone());
            (
                changes,
                source.map_err(|error| of_read(study.undrawn(error)))?,
            )
        }
    };
    let results = results.over(study.results)?;
    Ok((Base::from(&input), changes, source, results))
}

/// A folder that cannot be used, or a table with mistakes.
fn of_parts(error: PartsError) -> PyErr {
    match &error {
        PartsError::Io { path, error: io } => match io.raw_os_error() {
            // Python chooses the class of the exception by the number.
            Some(number) => PyOSError::new_err((number, io.to_string(), path.clone())),
            None => PyOSError::new_err(error.to_string()),
        },
        PartsError::Table(TableError { name, problem }) => match &**problem {
            TableProblem::Io(io) => match io.raw_os_error() {
                Some(number) => PyOSError::new_err((number, io.to_string(), name.clone())),
                None => PyOSError::new_err(error.to_string()),
            },
            _ => usage(error.to_string()),
        },
        PartsError::Unwritable { .. }
        | PartsError::Damaged { .. }
        | PartsError::Replaced { .. } => PyOSError::new_err(error.to_string()),
        _ => usage(error.to_string()),
    }
}
