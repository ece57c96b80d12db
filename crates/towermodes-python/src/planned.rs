//! The sweep: the tower, the changes, their values, and the requested modes.

use std::ops::Range;
use std::path::Path;

use numpy::PyArray1;
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use towermodes::Change;
use towermodes_files::{
    SiblingFiles, Source, SweepResults, SweepRows, TowerInput, read, read_sweep_study,
};
use towermodes_sweep::{RowSource, SweepSource, Table, rows_within};

use crate::error::{of_read, of_slice, usage};
use crate::input::tower_input;
use crate::lock::released;
use crate::sweep::SweepOptions;
use crate::tower::Tower;

/// The tower and the changed input values.
pub struct Planned {
    /// The changes of the tower.
    pub changes: Vec<Change>,
    /// Their values.
    pub source: SweepSource,
    /// The requested modes and the method.
    pub results: SweepResults,
}

/// The sweep of a table in a file.
///
/// # Errors
/// `ValueError` or `OSError` with the mistake in the table.
pub fn of_table(
    input: &TowerInput,
    table: &Path,
    results: &SweepOptions,
    ignore: &[String],
) -> PyResult<Planned> {
    let results = results.over(SweepResults::default())?;
    let table = Table::open(table, &input.description, ignore);
    let table = table.map_err(|error| of_slice(error.into()))?;
    Ok(Planned {
        changes: table.changes().to_vec(),
        source: SweepSource::Table(Box::new(table)),
        results,
    })
}

/// The sweep of a study, for the tower that it names or for another one. Names of files in the
/// study are relative to its own path.
///
/// # Errors
/// `TowerError` with the mistakes of the study and of the tower; errors of [`of_table`].
pub fn of_study(
    study: &Source,
    tower: Option<&TowerInput>,
    results: &SweepOptions,
    ignore: &[String],
) -> PyResult<Planned> {
    let beside = SiblingFiles::of(Path::new(&study.name));
    let study = read_sweep_study(study).map_err(of_read)?;
    let own;
    let input = match tower {
        Some(tower) => tower,
        None => {
            let base = read(&beside.path(&study.base.value), &study.reading);
            own = tower_input(base.map_err(of_read)?)?;
            &own
        }
    };
    match &study.rows {
        SweepRows::Table(path) => {
            let planned = of_table(input, &beside.path(&path.value), results, ignore)?;
            let results = results.over(study.results)?;
            Ok(Planned { results, ..planned })
        }
        SweepRows::Sampled { .. } if !ignore.is_empty() => {
            Err(usage("ignore applies only to a table of values"))
        }
        SweepRows::Sampled { sampling, .. } => {
            let changes = study.changes(&input.description).map_err(of_read)?;
            let source = SweepSource::sampled(sampling.clone());
            let source = source.map_err(|error| of_read(study.undrawn(error)))?;
            Ok(Planned {
                changes,
                source,
                results: results.over(study.results)?,
            })
        }
    }
}

/// A column of numbers with its name.
type NamedColumn<'py> = (String, Bound<'py, PyArray1<f64>>);

/// Columns with their names, and the number of their first row.
type Values<'py> = (Vec<NamedColumn<'py>>, u64);

/// The first requested row, and the row after the last one.
type Rows = Option<(u64, u64)>;

/// The requested rows of a table: the first row, and the row after the last one.
#[pyfunction]
#[pyo3(name = "rows_within")]
pub fn rows_within_table(rows: (u64, u64), count: u64) -> PyResult<(u64, u64)> {
    let rows = rows_within(rows.0..rows.1, count).map_err(of_slice)?;
    Ok((rows.start, rows.end))
}

/// The values of a table in a file: a column for each change of a tower.
#[pyfunction]
#[pyo3(signature = (
    tower, path: "str", ignore: "list[str]", rows,
) -> "tuple[list[tuple[str, Incomplete]], int]")]
pub fn values_of_table<'py>(
    py: Python<'py>,
    tower: &Tower,
    path: &str,
    ignore: Vec<String>,
    rows: Rows,
) -> PyResult<Values<'py>> {
    let input = &tower.model.input;
    let (columns, first_row) = released(py, || {
        let planned = of_table(input, Path::new(path), &SweepOptions::default(), &ignore)?;
        columns(&planned, rows)
    })?;
    Ok((arrays(py, columns), first_row))
}

/// The values of a study with this tower as its base, and the options of the sweep: those given,
/// else those of the study.
#[pyfunction]
#[pyo3(signature = (
    tower, text, name, ignore: "list[str]", options: "dict[str, object]", rows,
) -> "tuple[tuple[list[tuple[str, Incomplete]], int], dict[str, object]]")]
pub fn values_of_study<'py>(
    py: Python<'py>,
    tower: &Tower,
    text: String,
    name: String,
    ignore: Vec<String>,
    options: SweepOptions,
    rows: Rows,
) -> PyResult<(Values<'py>, SweepOptions)> {
    let (input, source) = (&tower.model.input, Source { name, text });
    let ((columns, first_row), options) = released(py, || {
        let planned = of_study(&source, Some(input), &options, &ignore)?;
        let options = options.with(&planned.results);
        Ok::<_, PyErr>((columns(&planned, rows)?, options))
    })?;
    Ok(((arrays(py, columns), first_row), options))
}

fn arrays(py: Python<'_>, columns: Columns) -> Vec<NamedColumn<'_>> {
    let array = |(name, values)| (name, PyArray1::from_vec(py, values));
    columns.into_iter().map(array).collect()
}

/// The name and the values of each change.
type Columns = Vec<(String, Vec<f64>)>;

/// The columns of the requested rows, and the number of the first row.
fn columns(planned: &Planned, rows: Rows) -> PyResult<(Columns, u64)> {
    let all = planned.source.rows();
    let Range { start, end } = match rows {
        None => 0..all,
        Some((start, end)) => rows_within(start..end, all).map_err(of_slice)?,
    };
    let count = end - start;
    let full = || {
        let message = format!(
            "the values of {count} rows do not fit into memory; take fewer at a time with rows=range(…)"
        );
        PyMemoryError::new_err(message)
    };
    let block = planned.source.block(start..end);
    let block = block.map_err(|error| of_slice(error.into()))?;
    let reserved = usize::try_from(count).map_err(|_| full())?;
    let mut columns = Vec::new();
    for change in &planned.changes {
        let mut values = Vec::new();
        values.try_reserve_exact(reserved).map_err(|_| full())?;
        columns.push((change.name().to_owned(), values));
    }
    let mut values = vec![0.0; columns.len()];
    for row in 0..count {
        block.row(row, &mut values);
        for ((_, column), value) in columns.iter_mut().zip(&values) {
            column.push(*value);
        }
    }
    Ok((columns, start))
}
